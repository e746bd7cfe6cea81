// SPDX-License-Identifier: MIT
// The nearest points of any two convex shapes, from their support functions alone: the pairs of closest_points.hpp
// without a closed form. Include closest_points.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/relation/unbounded.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// The maximum number of support points: two complete runs, or one and an expansion with two support points per step,
/// and the directions that prove bounds in between.
inline constexpr std::size_t most_supports = 3 * static_cast<std::size_t>(gjk_iteration_limit) + 32;

/// The Minkowski difference a - b, which remembers the points that its support points were made from.
template <Convex A, Convex B>
class WitnessedDifference final : public AnyDifference<dimension_of<A>> {
 public:
  static constexpr Dim dimension = dimension_of<A>;
  using Point = Vec<dimension, double>;

  WitnessedDifference(const A& a, const B& b)
      : a_(a), b_(b), largest_(std::max(largest_within(a), largest_within(b))) {}

  Point support(const Point& direction) override {
    const Point on_a = wide_support(a_, direction);
    const Point on_b = wide_support(b_, -direction);
    largest_ = std::max({largest_, max_abs(on_a), max_abs(on_b)});
    if (count_ < witnesses_.size()) witnesses_[count_++] = {on_a, on_b};
    return on_a - on_b;
  }

  double resolution() const override { return std::max(support_error<A>, support_error<B>) * largest_; }

  const A& a() const { return a_; }
  const B& b() const { return b_; }

  /// Resets the resolution to its initial value, as in a new search: earlier support points no longer affect it.
  void begin_anew() { largest_ = std::max(largest_within(a_), largest_within(b_)); }

  /// The points that a support point was made from.
  struct Witness {
    Point on_a;
    Point on_b;
  };

  /// Every difference has one. For NaN, an arbitrary one.
  const Witness& witness(const Point& difference) const {
    std::size_t i = 0;
    while (i + 1 < count_ && witnesses_[i].on_a - witnesses_[i].on_b != difference) ++i;
    return witnesses_[i];
  }

  /// A support point before rounding.
  TwofoldVec<dimension> exact(const Point& difference) const override {
    const Witness& made_of = witness(difference);
    return twofold_difference(made_of.on_a, made_of.on_b);
  }

 private:
  const A& a_;
  const B& b_;
  double largest_;
  std::size_t count_ = 0;
  std::array<Witness, most_supports> witnesses_;
};

/// GJK stops when the distance is known well enough, but then the points can be off by its square root. This continues
/// until no support point is nearer by more than rounding: for polytopes, until the right faces are found.
template <class Differences>
void go_on(Differences& differences, GjkResult<Differences::dimension>& result) {
  constexpr Dim N = Differences::dimension;
  GjkProgress<N> progress(result.separation);
  for (int step = 0; step < gjk_iteration_limit && result.simplex.size <= static_cast<std::size_t>(N); ++step) {
    if (!(result.upper > result.resolution)) return;
    const Vec<N, double>& toward = progress.toward;
    const Vec<N, double> next = differences.support(-toward);
    raise_lower(result, dot(toward, next) / result.upper, toward);  // upper > resolution >= 0
    const double nearer_by = dot(toward, result.separation - next);
    const double noise = tolerance::epsilon * dot(abs(toward), abs(next));
    if (!(nearer_by > noise) || is_corner_of(result.simplex, next)) return;
    Simplex<N> extended = result.simplex;
    extended.push(next);
    const std::optional<NearestOnSimplex<N>> found = gjk_step(extended, result, progress);
    if (!found) return;
    result.separation = found->point;
    result.simplex = found->face;
    result.upper = std::sqrt(found->distance_squared);
  }
}

// ---- Barycentric coordinates in a simplex

/// A 3D simplex, relative to its first corner: with edges e_i to the others, its point sum of s_i e_i has the
/// coordinates s_i.
template <Dim N>
class SharesInSimplex {
 public:
  using Shares = std::array<double, 3>;

  explicit SharesInSimplex(const Simplex<N>& simplex) : first_(simplex.points[0]), count_(simplex.size - 1) {
    double size = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      edges_[i] = lifted(simplex.points[i + 1] - first_);
      size = std::max(size, max_abs(edges_[i]));
    }
    scale_ = scale_to_moderate(size);
    for (Vec<3, double>& edge : edges_) edge *= scale_;
  }

  /// Each from zero to one, and the sum at most one. If a tetrahedron is almost flat, rounding of its shares is large;
  /// what they leave of the point is distributed again.
  Shares of(const Vec<N, double>& point) const {
    constexpr int rounds = 3;
    if (count_ == 2) return of_triangle(lifted(point - first_) * scale_);
    Shares shares{};
    Vec<3, double> rest = lifted(point - first_) * scale_;
    for (int round = 0; round < rounds; ++round) {
      const Shares more = solve(rest);
      rest = lifted(point - first_) * scale_;
      for (std::size_t i = 0; i < count_; ++i) {
        shares[i] += more[i];
        rest -= edges_[i] * shares[i];
      }
    }
    double sum = 0;
    for (double& share : shares) sum += share = std::clamp(share, 0.0, 1.0);
    if (sum > 1) {
      for (double& share : shares) share /= sum;
    }
    return shares;
  }

 private:
  /// For a triangle, measured from one end of its longest side. However thin it is, no share moves the point by more
  /// than rounding: the share of the third corner is limited where the position along the longest side could otherwise
  /// not be reached, unless the angle at that corner is so wide that an error along the side is smaller.
  Shares of_triangle(const Vec<3, double>& point) const {
    const Vec<3, double>& u = edges_[0];
    const Vec<3, double>& v = edges_[1];
    const Vec<3, double> w = v - u;
    const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
    if (dot(u, u) == longest) {
      const auto [along, beside] = shares_by(u, v, point);
      return {along, beside, 0};
    }
    if (dot(v, v) == longest) {
      const auto [along, beside] = shares_by(v, u, point);
      return {beside, along, 0};
    }
    const auto [along, beside] = shares_by(w, -u, point - u);
    return {std::max(0.0, 1 - along - beside), along, 0};
  }

  /// `point` as a sum of multiples of the longest side of a triangle and of another side, from their common corner.
  static std::array<double, 2> shares_by(const Vec<3, double>& longest, const Vec<3, double>& other,
                                         const Vec<3, double>& point) {
    const double whole = dot(longest, longest);
    if (!(whole > 0)) return {};
    const auto place_along = [&](const Vec<3, double>& v) {
      const double place = dot(v, longest) / whole;
      return place + dot(v - longest * place, longest) / whole;
    };
    const double place = std::clamp(place_along(point), 0.0, 1.0);
    const double corner = std::clamp(place_along(other), 0.0, 1.0);  // it lies between the ends of the longest side
    const Vec<3, double> once = other - longest * place_along(other);
    const Vec<3, double> across = once - longest * place_along(once);
    const double width = dot(across, across);
    double beside = width > 0 ? std::clamp(dot(point, across) / width, 0.0, 1.0) : 0.0;
    const auto cut = [&](double from_corner, double from_place) {
      if (beside * from_corner > from_place && from_corner * from_corner * whole > width) {
        beside = from_place / from_corner;
      }
    };
    cut(corner, place);
    cut(1 - corner, 1 - place);
    return {std::clamp(place - beside * corner, 0.0, 1 - beside), beside};
  }

  /// Zero for a simplex that is flat up to rounding.
  Shares solve(const Vec<3, double>& point) const {
    const auto& [u, v, w] = edges_;
    Shares shares{};
    double whole = 0;
    if (count_ == 1) {
      whole = dot(u, u);
      shares[0] = dot(point, u);
    } else if (count_ == 3) {
      whole = dot(accurate_cross(u, v), w);
      shares = {dot(accurate_cross(v, w), point), dot(accurate_cross(w, u), point), dot(accurate_cross(u, v), point)};
    }
    if (whole == 0) return {};
    for (double& share : shares) share /= whole;
    return shares;
  }

  Vec<N, double> first_;
  std::size_t count_;
  std::array<Vec<3, double>, 3> edges_{};
  double scale_ = 1;
};

/// The points of a and b whose difference is a given point of a simplex; `differences` remember the points that its
/// corners were made from.
template <class Differences>
ClosestPair<Differences::dimension> pair_at(const Differences& differences,
                                            const Simplex<Differences::dimension>& simplex,
                                            const Vec<Differences::dimension, double>& point) {
  constexpr Dim N = Differences::dimension;
  const std::array<double, 3> shares = SharesInSimplex<N>(simplex).of(point);
  // Corners are added relative to the first one, so that nothing is lost far from the origin.
  const auto first = differences.witness(simplex.points[0]);
  ClosestPair<N> pair{first.on_a, first.on_b, -point, dot(point, point)};
  for (std::size_t i = 1; i < simplex.size; ++i) {
    const auto next = differences.witness(simplex.points[i]);
    pair.on_a += (next.on_a - first.on_a) * shares[i - 1];
    pair.on_b += (next.on_b - first.on_b) * shares[i - 1];
  }
  return pair;
}

/// GJK's final state besides the points.
template <Dim N>
struct ConvexCores {
  ClosestPair<N> closest;
  Status status;
  double error;
};

/// From GJK's result; `differences` remember the points that their support points were made from.
template <class Differences>
ConvexCores<Differences::dimension> closest_from(Differences& differences, GjkResult<Differences::dimension> found) {
  go_on(differences, found);
  return {pair_at(differences, found.simplex, found.separation), found.status,
          std::max(0.0, found.upper - found.lower) + found.resolution};
}

/// The nearest points of two cores, or a common point.
template <Convex A, Convex B>
ConvexCores<dimension_of<A>> closest_of_convex(const A& a, const B& b) {
  WitnessedDifference<A, B> differences(a, b);
  return closest_from(differences, gjk_on(differences, GjkOptions{}));
}

}  // namespace graze::detail
