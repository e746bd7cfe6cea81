// SPDX-License-Identifier: MIT
// Where a ray enters a shape as stored. For hulls, in integers: an entry point is in a simplex of at most as many
// corners as there are dimensions, so all such simplices are tried, however thin. For round shapes, the roots have
// fifty digits.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/kinds.hpp"
#include "exact/numbers.hpp"
#include "exact/solid.hpp"
#include "exact/unbounded.hpp"
#include "parts_of.hpp"

namespace graze::test {

/// Linear equations in integers, with the right-hand side in the last column.
using IntegerRows = std::vector<std::vector<Integer>>;

/// The last unknown of equations with a unique solution, if no unknown is negative; otherwise none. Bareiss 1968,
/// "Sylvester's identity and multistep integer-preserving Gaussian elimination": all divisions are exact.
inline std::optional<Rational> last_of_solution(IntegerRows rows) {
  const std::size_t unknowns = rows.front().size() - 1;
  Integer pivot = 1;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t chosen = column;
    while (chosen < rows.size() && rows[chosen][column] == 0) ++chosen;
    if (chosen == rows.size()) return std::nullopt;
    std::swap(rows[column], rows[chosen]);
    const std::vector<Integer> pivot_row = rows[column];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == column) continue;
      const Integer factor = rows[i][column];
      for (std::size_t j = 0; j <= unknowns; ++j) {
        rows[i][j] = (pivot_row[column] * rows[i][j] - factor * pivot_row[j]) / pivot;
      }
    }
    pivot = pivot_row[column];
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i >= unknowns && rows[i][unknowns] != 0) return std::nullopt;
    if (i < unknowns && rows[i][unknowns] * pivot < 0) return std::nullopt;
  }
  // Both have the same sign, and Rational takes no negative denominator.
  return Rational(Integer(abs(rows[unknowns - 1][unknowns])), Integer(abs(pivot)));
}

/// The first position of a ray, as a multiple of its direction, in the Minkowski sum of a convex hull of corners and
/// the cone of `ways`. The ray's origin must be outside.
template <Dim N>
class HullEntry {
 public:
  using Vector = RationalVec<N>;

  HullEntry(const Vector& origin, const Vector& direction, const std::vector<Vector>& corners,
            const std::vector<Vector>& ways = {}) {
    for (const auto* list : {&corners, &ways}) {
      for (const Vector& v : *list) grow_unit(v);
    }
    grow_unit(origin);
    grow_unit(direction);
    origin_ = whole(origin);
    direction_ = whole(direction);
    for (const Vector& corner : corners) generators_.push_back({whole(corner), 1});
    for (const Vector& way : ways) generators_.push_back({whole(way), 0});
  }

  std::optional<Rational> find() {
    choose_from(0);
    return first_;
  }

 private:
  struct Generator {
    IntegerVec<N> place;
    int weight;  ///< 0 for a direction.
  };

  void grow_unit(const Vector& v) {
    for (const Rational& x : v) unit_ = std::max(unit_, Integer(denominator(x)));
  }

  IntegerVec<N> whole(const Vector& v) const {
    IntegerVec<N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = Integer(numerator(v[i])) * (unit_ / Integer(denominator(v[i])));
    return result;
  }

  void choose_from(std::size_t next) {
    if (!chosen_.empty()) try_chosen();
    if (chosen_.size() == static_cast<std::size_t>(N)) return;
    for (std::size_t i = next; i < generators_.size(); ++i) {
      chosen_.push_back(i);
      choose_from(i + 1);
      chosen_.pop_back();
    }
  }

  /// The weighted sum of the chosen ones minus t times the direction is the origin; the corners' weights sum to one.
  void try_chosen() {
    IntegerRows rows;
    for (std::size_t axis = 0; axis <= static_cast<std::size_t>(N); ++axis) {
      const bool is_sum = axis == static_cast<std::size_t>(N);
      std::vector<Integer>& row = rows.emplace_back();
      for (const std::size_t i : chosen_)
        row.push_back(is_sum ? Integer(generators_[i].weight) : generators_[i].place[axis]);
      row.push_back(is_sum ? Integer(0) : Integer(-direction_[axis]));
      row.push_back(is_sum ? Integer(1) : origin_[axis]);
    }
    const std::optional<Rational> t = last_of_solution(std::move(rows));
    if (t && (!first_ || *t < *first_)) first_ = *t;
  }

  Integer unit_ = 1;
  IntegerVec<N> origin_;
  IntegerVec<N> direction_;
  std::vector<Generator> generators_;
  std::vector<std::size_t> chosen_;
  std::optional<Rational> first_;
};

/// The smaller root of a t^2 + 2 b t + c = 0 with a > 0, if it is positive; without cancellation.
inline std::optional<Wide> first_root(const Rational& a, const Rational& b, const Rational& c) {
  const Rational discriminant = b * b - a * c;
  if (c <= 0 || b >= 0 || discriminant < 0) return std::nullopt;
  return Wide(wide_of(c) / (sqrt(wide_of(discriminant)) - wide_of(b)));
}

inline void keep_lesser(std::optional<Wide>& first, const std::optional<Wide>& other) {
  if (other && (!first || *other < *first)) first = other;
}

/// Spheres around both ends and the cylinder between.
template <Dim N>
std::optional<Wide> round_entry(const RationalVec<N>& origin, const RationalVec<N>& direction, const Solid<N>& solid) {
  std::optional<Wide> first;
  const Rational radius_squared = solid.radius * solid.radius;
  for (const RationalVec<N>& center : solid.corners) {
    const RationalVec<N> off = origin - center;
    keep_lesser(first, first_root(dot(direction, direction), dot(off, direction), dot(off, off) - radius_squared));
  }
  if (solid.corners.size() < 2) return first;
  const RationalVec<N> axis = solid.corners[1] - solid.corners[0];
  const RationalVec<N> off = origin - solid.corners[0];
  const Rational squared = dot(axis, axis);
  const Rational along = dot(direction, axis);
  const Rational start = dot(off, axis);
  const Rational across_squared = squared * dot(direction, direction) - along * along;
  if (across_squared == 0) return first;
  const std::optional<Wide> tube = first_root(across_squared, squared * dot(off, direction) - start * along,
                                              squared * dot(off, off) - start * start - radius_squared * squared);
  if (!tube) return first;
  // Close to the ends, where the digits may not suffice, the spheres are entered at the same position.
  const Wide place = wide_of(start) + *tube * wide_of(along);
  if (place >= 0 && place <= wide_of(squared)) keep_lesser(first, tube);
  return first;
}

/// Where the ray first meets the shape, as a multiple of its direction, rounded once; 0 if it starts inside, none if it
/// misses.
template <Dim N, class T>
std::optional<double> exact_entry(const AnyShape<N, T>& shape, const Ray<N, T>& ray) {
  const RationalVec<N> origin = exact(ray.origin);
  const RationalVec<N> direction = exact(ray.direction);
  const auto rounded_to_double = [](const auto& t) -> std::optional<double> {
    if (!t) return std::nullopt;
    return static_cast<double>(*t);
  };
  return std::visit(
      [&](const auto& held) -> std::optional<double> {
        using S = std::decay_t<decltype(held)>;
        if constexpr (has_parts<S>) {
          std::optional<double> first;
          const auto whole = parts_of<N, T>(shape);
          for (const Part<N, T>& part : whole->parts) {
            const std::optional<double> entry = exact_entry<N, T>(part.shape, ray);
            if (entry && (!first || *entry < *first)) first = entry;
          }
          return first;
        } else {
          const AnyShape<N, T> start(ray.origin);
          if (exact_verdict<N, T>(start, shape, Measure::distance).relation != Relation::apart) return 0.0;
          if constexpr (is_plane_or_half_space<S>) {
            const ExactLevel<N> surface = level(held);
            const Rational climb = dot(surface.normal, direction);
            if (climb == 0) return std::nullopt;
            const Rational t = (surface.offset - dot(surface.normal, origin)) / climb;
            return t < 0 ? std::nullopt : std::optional<double>(to_double(t));
          } else if constexpr (is_ray<S>) {
            const auto t = HullEntry<N>(origin, direction, {exact(held.origin)}, {exact(held.direction)}).find();
            return t ? std::optional<double>(to_double(*t)) : std::nullopt;
          } else {
            const Solid<N> body = solid(held);
            if (body.radius > 0) return rounded_to_double(round_entry<N>(origin, direction, body));
            const auto t = HullEntry<N>(origin, direction, body.corners).find();
            return t ? std::optional<double>(to_double(*t)) : std::nullopt;
          }
        }
      },
      shape);
}

}  // namespace graze::test
