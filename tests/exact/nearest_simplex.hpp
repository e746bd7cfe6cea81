// SPDX-License-Identifier: MIT
// Searches for a proof: the simplex of corner differences nearest to a target, by the algorithm of Gilbert, Johnson and
// Keerthi (1988) in double or, if that fails, in long double. Nothing here is a proof; a certificate checks the result.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "exact/body.hpp"
#include "exact/enclosed.hpp"
#include "exact/numbers.hpp"

namespace graze::test {

/// The corners of one body of a pair, relative to a common position, as used by proofs and by searches.
template <std::size_t N, class Real>
struct Corners {
  std::array<EnclosedVec<N>, Body<N>::most_corners + 1> exact;
  std::array<std::array<Real, N>, Body<N>::most_corners + 1> near;
  std::size_t count = 0;

  void add(const EnclosedVec<N>& corner) {
    exact[count] = corner;
    for (std::size_t i = 0; i < N; ++i) near[count][i] = rounded_to<Real>(corner[i]);
    ++count;
  }
};

template <class Real>
bool is_below_zero(Real x) {
  return x < 0;
}

/// Points whose barycentric coordinates are known up to a common factor.
template <class Number, std::size_t N>
using Shares = std::array<Number, N + 1>;

/// Proportional to the barycentric coordinates of the projection of the origin to the span of points; for N + 1 points,
/// of the origin itself. All are negated if the points have the opposite orientation.
template <class Number, std::size_t N>
Shares<Number, N> shares_of(const std::array<std::array<Number, N>, N + 1>& x, std::size_t count) {
  Shares<Number, N> shares{};
  if (count == 1) {
    shares[0] = Number{1};
  } else if (count == 2) {
    const std::array<Number, N> edge = x[1] - x[0];
    shares = {dot(x[1], edge), -dot(x[0], edge)};
  } else if constexpr (N == 2) {
    const auto turn = [](const auto& p, const auto& q) { return p[0] * q[1] - p[1] * q[0]; };
    shares = {turn(x[1], x[2]), turn(x[2], x[0]), turn(x[0], x[1])};
  } else if (count == 3) {
    const std::array<Number, N> normal = cross(x[1] - x[0], x[2] - x[0]);
    shares = {dot(normal, cross(x[1], x[2])), dot(normal, cross(x[2], x[0])), dot(normal, cross(x[0], x[1]))};
  } else {
    const std::array<Number, N> first = cross(x[0], x[1]);
    const std::array<Number, N> last = cross(x[2], x[3]);
    shares = {dot(x[1], last), -dot(x[0], last), dot(x[3], first), -dot(x[2], first)};
  }
  return shares;
}

/// Perpendicular to one to N points, towards them from a position: from the edges, which loses less than a projection.
template <class Number, std::size_t N>
std::array<Number, N> normal_of(const std::array<std::array<Number, N>, N + 1>& x, std::size_t count,
                                const std::array<Number, N>& from_place) {
  if (count == 1) return from_place;
  const std::array<Number, N> edge = x[1] - x[0];
  std::array<Number, N> normal;
  if constexpr (N == 2) {
    normal = {edge[1], -edge[0]};
  } else if (count == 2) {
    normal = cross(edge, cross(from_place, edge));
  } else {
    normal = cross(edge, x[2] - x[0]);
  }
  return is_below_zero(dot(normal, from_place)) ? normal * Number{-1} : normal;
}

/// Corners of one body and of the other, `pairs[i]`, whose differences minus the target are `x[i]`.
template <std::size_t N, class Real>
struct Simplex {
  std::array<std::array<std::size_t, 2>, N + 1> pairs{};
  std::array<std::array<Real, N>, N + 1> x{};
  std::size_t count = 0;
  std::array<Real, N> target{};
  std::array<Real, N> normal{};  ///< From the target to the nearest point, of any length; zero if they coincide.
  Real squared = std::numeric_limits<Real>::infinity();

  /// As far as Real can decide.
  bool holds_target() const { return count == N + 1; }
};

template <std::size_t N, class Real>
class NearestSearch {
 public:
  using Point = std::array<Real, N>;
  using Simplex = test::Simplex<N, Real>;
  using Corners = test::Corners<N, Real>;

  NearestSearch(const Corners& a, const Corners& b, const Point& target) : a_(a), b_(b), target_(target) {}

  Simplex run() const {
    constexpr int most_steps = 40;
    constexpr Real nothing = std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
    Simplex best;
    best.target = target_;
    add(best, 0, 0);
    best = nearest_face(best);
    const Real start = best.squared;
    for (int step = 0; step < most_steps && !best.holds_target() && best.squared > nothing * start; ++step) {
      const std::size_t on_a = extreme(a_, best.normal, -1);
      const std::size_t on_b = extreme(b_, best.normal, 1);
      Simplex grown = best;
      if (!add(grown, on_a, on_b)) break;
      const Simplex next = nearest_face(grown);
      if (next.squared >= best.squared) break;
      best = next;
    }
    return best;
  }

 private:
  /// False if the pair is already in the simplex.
  bool add(Simplex& simplex, std::size_t on_a, std::size_t on_b) const {
    for (std::size_t i = 0; i < simplex.count; ++i) {
      if (simplex.pairs[i][0] == on_a && simplex.pairs[i][1] == on_b) return false;
    }
    simplex.pairs[simplex.count] = {on_a, on_b};
    simplex.x[simplex.count] = a_.near[on_a] - b_.near[on_b] - target_;
    ++simplex.count;
    return true;
  }

  static std::size_t extreme(const Corners& corners, const Point& direction, Real sign) {
    std::size_t best = 0;
    Real highest = -std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < corners.count; ++i) {
      const Real height = sign * dot(corners.near[i], direction);
      if (height > highest) {
        highest = height;
        best = i;
      }
    }
    return best;
  }

  /// Among all faces with the newest corner whose interior contains the projection of the target, the nearest one.
  static Simplex nearest_face(const Simplex& simplex) {
    Simplex best;
    const unsigned newest = 1U << (simplex.count - 1);
    for (unsigned chosen = newest; chosen < 2 * newest; ++chosen) {
      Simplex face;
      face.target = simplex.target;
      for (std::size_t i = 0; i < simplex.count; ++i) {
        if ((chosen >> i & 1U) == 0) continue;
        face.pairs[face.count] = simplex.pairs[i];
        face.x[face.count++] = simplex.x[i];
      }
      if (drop_perpendicular(face) && face.squared < best.squared) best = face;
    }
    return best;
  }

  static bool drop_perpendicular(Simplex& face) {
    const Shares<Real, N> shares = shares_of<Real, N>(face.x, face.count);
    bool is_positive = true;
    bool is_negative = true;
    for (std::size_t i = 0; i < face.count; ++i) {
      is_positive = is_positive && shares[i] > 0;
      is_negative = is_negative && shares[i] < 0;
    }
    if (!is_positive && !is_negative) return false;
    face.normal = face.holds_target() ? Point{} : normal_of<Real, N>(face.x, face.count, face.x[0]);
    const Real height = dot(face.normal, face.x[0]);
    const Real length_squared = dot(face.normal, face.normal);
    face.squared = length_squared > 0 ? height * height / length_squared : 0;
    return true;
  }

  const Corners& a_;
  const Corners& b_;
  Point target_;
};

}  // namespace graze::test
