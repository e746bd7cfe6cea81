// SPDX-License-Identifier: MIT
// Exact verdicts with rays, planes and half-spaces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/numbers.hpp"
#include "exact/solid.hpp"
#include "exact/verdict.hpp"

namespace graze::test {

/// The sine below which `is_nearly_parallel`.
inline constexpr double nearly_parallel_sine = 64 * std::numeric_limits<double>::epsilon();

/// Whether x is not zero, but x^2 is below (nearly_parallel_sine * y)^2, given both squares.
inline bool is_barely(const Rational& squared, const Rational& of_squared) {
  return squared != 0 && squared < of_squared * exact(nearly_parallel_sine * nearly_parallel_sine);
}

template <Dim N>
Rational largest_coordinate(const RationalVec<N>& v) {
  Rational largest = 0;
  for (const Rational& x : v) largest = std::max(largest, Rational(abs(x)));
  return largest;
}

template <Dim N>
Rational largest_coordinate(const Solid<N>& solid) {
  Rational largest = 0;
  for (const RationalVec<N>& corner : solid.corners) largest = std::max(largest, largest_coordinate<N>(corner));
  return largest + solid.radius;
}

// ---- A ray, truncated without effect: the points of the other shape are nearest to the part that is kept.

/// From the ray's origin to beyond `reach` times its direction; by a power of two, because the coordinates of solids
/// are integers divided by powers of two.
template <Dim N>
Solid<N> cut_ray(const RationalVec<N>& origin, const RationalVec<N>& direction, const Rational& reach) {
  Rational cut = 1;
  while (cut <= reach) cut *= 2;
  while (reach > 0 && cut > 2 * reach) cut /= 2;
  return hull_of<N>({origin, origin + direction * cut});
}

/// Twice as far as the ray's farthest point closest to a corner, and farther than the corners are from the origin, so
/// that the cut is no nearer than any side.
template <Dim N, class T>
Solid<N> solid_beside(const Ray<N, T>& ray, const Solid<N>& other) {
  const RationalVec<N> origin = exact(ray.origin);
  const RationalVec<N> direction = exact(ray.direction);
  const Rational squared = dot(direction, direction);
  Rational reach = 0;
  for (const RationalVec<N>& corner : other.corners) {
    const RationalVec<N> to_corner = corner - origin;
    reach = std::max(reach, Rational(dot(to_corner, direction) / squared));
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        if (direction[j] != 0) reach = std::max(reach, Rational(abs(to_corner[i] / direction[j]) / 1024));
      }
    }
  }
  return cut_ray<N>(origin, direction, Rational(2 * reach));
}

/// The nearest points of the lines of two rays, as multiples of the directions; none if parallel.
template <Dim N>
std::optional<std::array<Rational, 2>> nearest_places(const RationalVec<N>& between, const RationalVec<N>& first,
                                                      const RationalVec<N>& second) {
  // between + t second - s first is perpendicular to both directions.
  const Rational a = dot(first, first);
  const Rational b = dot(first, second);
  const Rational c = dot(second, second);
  const Rational determinant = a * c - b * b;
  if (determinant == 0) return std::nullopt;
  const Rational d = dot(first, between);
  const Rational e = dot(second, between);
  return std::array<Rational, 2>{(c * d - b * e) / determinant, (b * d - a * e) / determinant};
}

/// Two rays, truncated beyond the other's origin and beyond the nearest points of their lines.
template <Dim N, class T>
std::array<Solid<N>, 2> cut_rays(const Ray<N, T>& a, const Ray<N, T>& b) {
  const RationalVec<N> first = exact(a.direction);
  const RationalVec<N> second = exact(b.direction);
  const RationalVec<N> between = exact(b.origin) - exact(a.origin);
  Rational reach_a = abs(dot(between, first)) / dot(first, first);
  Rational reach_b = abs(dot(between, second)) / dot(second, second);
  if (const auto places = nearest_places<N>(between, first, second)) {
    reach_a = std::max(reach_a, (*places)[0]);
    reach_b = std::max(reach_b, (*places)[1]);
  }
  return {cut_ray<N>(exact(a.origin), first, Rational(2 * reach_a)),
          cut_ray<N>(exact(b.origin), second, Rational(2 * reach_b))};
}

// ---- Planes and half-spaces

template <Dim N>
struct ExactLevel {
  RationalVec<N> normal;
  Rational offset;
  bool is_solid;  ///< A half-space.
};

template <Dim N, class T>
ExactLevel<N> level(const Plane<N, T>& plane) {
  return {exact(plane.normal), exact(static_cast<double>(plane.offset)), false};
}

template <Dim N, class T>
ExactLevel<N> level(const HalfSpace<N, T>& solid) {
  return {exact(solid.normal), exact(static_cast<double>(solid.offset)), true};
}

/// The heights of a set above a plane, in units of the normal; none means infinite.
struct ExactHeights {
  std::optional<Rational> low;
  std::optional<Rational> high;
};

template <Dim N>
ExactHeights heights(const ExactLevel<N>& level, const Solid<N>& solid) {
  ExactHeights result;
  for (const RationalVec<N>& corner : solid.corners) {
    const Rational height = dot(level.normal, corner) - level.offset;
    result.low = result.low ? std::min(*result.low, height) : height;
    result.high = result.high ? std::max(*result.high, height) : height;
  }
  return result;
}

template <Dim N, class T>
ExactHeights heights(const ExactLevel<N>& level, const Ray<N, T>& ray) {
  const Rational height = dot(level.normal, exact(ray.origin)) - level.offset;
  const Rational climb = dot(level.normal, exact(ray.direction));
  ExactHeights result{height, height};
  if (climb < 0) result.low.reset();
  if (climb > 0) result.high.reset();
  return result;
}

/// The verdict for a gap of `units` between cores, in units of sqrt(unit_squared), less a radius.
inline ExactVerdict verdict(const Rational& units, const Rational& unit_squared, const Rational& radius) {
  ExactVerdict result;
  const Rational reach_squared = radius * radius * unit_squared;
  const bool is_touching = units >= 0 && units * units == reach_squared;
  const bool is_apart = units > 0 && units * units > reach_squared;
  if (is_touching) result.relation = Relation::touching;
  if (!is_touching && !is_apart) result.relation = Relation::overlapping;
  // (u - r n) / n = (u^2 - r^2 n^2) / (u + r n) / n, without cancellation.
  const Wide unit = sqrt(wide_of(unit_squared));
  const Wide reach = wide_of(radius);
  const Wide gap = units > 0 ? Wide(wide_of(units * units - reach_squared) / (wide_of(units) + reach * unit) / unit)
                             : Wide(wide_of(units) / unit - reach);
  result.gap = static_cast<double>(gap);
  return result;
}

inline ExactVerdict always_overlapping() {
  return {Relation::overlapping, -std::numeric_limits<double>::infinity(), 0, 0, false};
}

/// The distance of a plane from the origin.
template <Dim N>
double distance_from_origin(const ExactLevel<N>& level) {
  return static_cast<double>(abs(wide_of(level.offset)) / sqrt(wide_of(dot(level.normal, level.normal))));
}

template <Dim N>
ExactVerdict level_verdict(const ExactLevel<N>& level, const ExactHeights& heights, const Rational& radius) {
  std::optional<Rational> gap = heights.low;
  if (!level.is_solid && heights.high) {
    const Rational below = -*heights.high;
    gap = gap ? std::max(*gap, below) : below;
  }
  return gap ? verdict(*gap, dot(level.normal, level.normal), radius) : always_overlapping();
}

template <Dim N>
ExactVerdict level_verdict(const ExactLevel<N>& level, const Solid<N>& solid) {
  ExactVerdict result = level_verdict(level, heights(level, solid), solid.radius);
  result.largest = std::max(to_double(largest_coordinate(solid)), distance_from_origin(level));
  return result;
}

template <Dim N, class T>
ExactVerdict level_verdict(const ExactLevel<N>& level, const Ray<N, T>& ray) {
  ExactVerdict result = level_verdict(level, heights(level, ray), Rational(0));
  const Rational climb = dot(level.normal, exact(ray.direction));
  const RationalVec<N> direction = exact(ray.direction);
  result.largest = std::max(to_double(largest_coordinate<N>(exact(ray.origin))), distance_from_origin(level));
  result.is_nearly_parallel = is_barely(climb * climb, dot(level.normal, level.normal) * dot(direction, direction));
  return result;
}

/// b as a multiple of a, and the square of the remainder.
template <Dim N>
std::pair<Rational, Rational> compare_directions(const RationalVec<N>& a, const RationalVec<N>& b) {
  const Rational factor = dot(a, b) / dot(a, a);
  const RationalVec<N> rest = b - a * factor;
  return {factor, dot(rest, rest)};
}

template <Dim N>
ExactVerdict parallel_verdict(const ExactLevel<N>& a, const ExactLevel<N>& b, const Rational& factor) {
  // Both along a's normal; b is the solid above its plane if the normals are opposite.
  const Rational rise = b.offset / factor - a.offset;
  const Rational squared = dot(a.normal, a.normal);
  const bool same_way = factor > 0;
  if (a.is_solid && b.is_solid && same_way) return always_overlapping();
  if (a.is_solid) return verdict(rise, squared, 0);
  if (b.is_solid) return verdict(same_way ? Rational(-rise) : rise, squared, 0);
  return verdict(abs(rise), squared, 0);
}

template <Dim N>
ExactVerdict level_verdict(const ExactLevel<N>& a, const ExactLevel<N>& b) {
  const auto [factor, rest_squared] = compare_directions<N>(a.normal, b.normal);
  ExactVerdict result = rest_squared == 0 ? parallel_verdict(a, b, factor) : always_overlapping();
  result.largest = std::max(distance_from_origin(a), distance_from_origin(b));
  result.is_nearly_parallel = is_barely(rest_squared, dot(b.normal, b.normal));
  return result;
}

}  // namespace graze::test
