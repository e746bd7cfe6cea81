// SPDX-License-Identifier: MIT
// Certificates with planes and half-spaces: the heights of the corners suffice, without a search.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "exact/body.hpp"
#include "exact/certificate.hpp"
#include "exact/enclosed.hpp"
#include "exact/numbers.hpp"

namespace graze::test {

/// If the sine between directions may be below this, the oracle decides, which has its own, smaller limit.
inline constexpr double clearly_not_parallel = 1e-12;

/// The smaller number, or either if uncertain.
inline Enclosed lesser(const Enclosed& a, const Enclosed& b) {
  const Enclosed difference = taken_as_exact(a) - taken_as_exact(b);
  const Enclosed& less = difference.high <= 0 ? a : b;
  return {less.high, less.low, std::max(a.error, b.error)};
}

/// The gap of a set whose core's lowest point is at `height`, in units of the normal's length, and that is inflated by
/// `radius`.
inline GapBounds bounds_of_height(const Enclosed& height, const Enclosed& unit_squared, const Enclosed& radius) {
  GapBounds bounds;
  const double least_unit = std::sqrt(lower_bound(unit_squared)) / outward;
  const double most_unit = std::sqrt(upper_bound(unit_squared)) * outward;
  const auto divided = [&](double x, bool up) {
    const double quotient = x / ((x > 0) == up ? least_unit : most_unit);
    return quotient * ((x > 0) == up ? outward : 1 / outward);
  };
  if (!is_surely_not_negative(height)) {
    bounds.low = divided(lower_bound(height), false) - magnitude(radius) * outward;
    bounds.low -= std::fabs(bounds.low) * (outward - 1) + std::numeric_limits<double>::denorm_min();
    if (is_surely_zero(radius)) {
      bounds.high = std::nextafter(divided(upper_bound(height), true), std::numeric_limits<double>::infinity());
    }
    bounds.is_overlapping =
        is_surely_negative(height) || upper_bound(height) * outward < lower_bound(radius) * least_unit / outward;
    return bounds;
  }
  // (h - r n) / n = (h^2 - r^2 n^2) / (h + r n) / n, without cancellation.
  const Enclosed beyond = height * height - radius * radius * unit_squared;
  const double most = (upper_bound(height) + magnitude(radius) * most_unit) * outward;
  const double least = (lower_bound(height) + lower_bound(radius) * least_unit) / outward;
  const double above = upper_bound(beyond);
  const double below = lower_bound(beyond);
  bounds.is_overlapping = is_surely_negative(beyond);
  bounds.low = below == 0 ? 0 : divided(below / (below > 0 ? most : least) / outward, false);
  bounds.high = above == 0 ? 0 : divided(above / (above > 0 ? least : most) * outward, true);
  if (below < 0) bounds.low *= outward * outward;
  if (above < 0) bounds.high /= outward * outward;
  // Quotients may underflow.
  if (below != 0) bounds.low = std::nextafter(bounds.low, -std::numeric_limits<double>::infinity());
  if (above != 0) bounds.high = std::nextafter(bounds.high, std::numeric_limits<double>::infinity());
  return bounds;
}

template <std::size_t N>
Enclosed height_over(const Body<N>& level, const EnclosedVec<N>& anchor) {
  return dot(level.way, anchor) - enclosed(level.offset);
}

/// An upper bound of the plane's distance from the origin.
template <std::size_t N>
double least_distance_from_origin(const Body<N>& level) {
  return std::fabs(level.offset) / std::sqrt(upper_bound(dot(level.way, level.way))) / outward;
}

/// An upper bound of the coordinates of a body; for a ray, of its origin.
template <std::size_t N>
double least_largest_coordinate(const Body<N>& body) {
  double largest = 0;
  for (std::size_t corner = 0; corner < body.count; ++corner) {
    for (std::size_t i = 0; i < N; ++i) {
      const Enclosed x = body.anchor[i] + body.corners[corner][i];
      largest = std::max(largest, std::fabs(x.high) - std::fabs(x.low) - x.error);
    }
  }
  return (largest + body.radius) / outward;
}

template <std::size_t N>
GapBounds bounds_over_level(const Body<N>& level, const Body<N>& body) {
  const Enclosed at_anchor = height_over(level, body.anchor);
  std::optional<Enclosed> lowest;
  std::optional<Enclosed> lowest_below;
  for (std::size_t corner = 0; corner < body.count; ++corner) {
    const Enclosed height = at_anchor + dot(level.way, body.corners[corner]);
    lowest = lowest ? lesser(*lowest, height) : height;
    lowest_below = lowest_below ? lesser(*lowest_below, -height) : -height;
  }
  // The nearer side of a plane is the one with less of the body.
  Enclosed gap = *lowest;
  if (level.form == BodyForm::plane) gap = -lesser(-*lowest, -*lowest_below);
  GapBounds bounds = bounds_of_height(gap, dot(level.way, level.way), enclosed(body.radius));
  bounds.largest = std::max(least_distance_from_origin(level), least_largest_coordinate(body));
  return bounds;
}

/// Whether a direction rises from a plane with a sine of more than `clearly_not_parallel`.
template <std::size_t N>
bool is_clearly_climbing(const Enclosed& product, const EnclosedVec<N>& a, const EnclosedVec<N>& b) {
  const double lengths = std::sqrt(upper_bound(dot(a, a))) * std::sqrt(upper_bound(dot(b, b)));
  return std::fabs(product.high) - std::fabs(product.low) - product.error > clearly_not_parallel * lengths;
}

template <std::size_t N>
GapBounds bounds_over_level_of_ray(const Body<N>& level, const Body<N>& ray) {
  const Enclosed start = height_over(level, ray.anchor);
  const Enclosed climb = dot(level.way, ray.way);
  const bool is_flat = is_surely_zero(climb);
  const bool is_rising = is_surely_positive(climb);
  const bool is_falling = is_surely_negative(climb);
  GapBounds bounds;
  if (!is_flat && !is_rising && !is_falling) return bounds;
  const Enclosed unit_squared = dot(level.way, level.way);
  const bool is_plane = level.form == BodyForm::plane;
  if (is_falling && !is_plane) {
    bounds.is_overlapping = true;
  } else {
    // The ray's heights begin or end at `start`; for a parallel ray, both.
    Enclosed gap = start;
    if (is_plane && is_falling) gap = -start;
    if (is_plane && is_flat) gap = -lesser(start, -start);
    bounds = bounds_of_height(gap, unit_squared, enclosed(0));
  }
  bounds.may_be_parallel = !is_flat && !is_clearly_climbing<N>(climb, level.way, ray.way);
  bounds.largest = std::max(least_distance_from_origin(level), least_largest_coordinate(ray));
  return bounds;
}

/// The squared sine of two vectors times the squares of their lengths.
template <std::size_t N>
Enclosed squared_cross(const EnclosedVec<N>& a, const EnclosedVec<N>& b) {
  if constexpr (N == 2) {
    const Enclosed turn = a[0] * b[1] - a[1] * b[0];
    return turn * turn;
  } else {
    const EnclosedVec<3> normal = cross(a, b);
    return dot(normal, normal);
  }
}

/// Whether the sine of two vectors is more than `clearly_not_parallel`.
template <std::size_t N>
bool is_clearly_not_parallel(const EnclosedVec<N>& a, const EnclosedVec<N>& b) {
  const double squares = upper_bound(dot(a, a)) * upper_bound(dot(b, b));
  return lower_bound(squared_cross<N>(a, b)) > clearly_not_parallel * clearly_not_parallel * squares * outward;
}

template <std::size_t N>
GapBounds bounds_of_levels(const Body<N>& a, const Body<N>& b) {
  GapBounds bounds;
  if (is_clearly_not_parallel<N>(a.way, b.way)) {
    bounds.is_overlapping = true;
    return bounds;
  }
  bounds.may_be_parallel = true;
  if (!is_surely_zero(squared_cross<N>(a.way, b.way))) return bounds;
  bounds.may_be_parallel = false;
  // b's normal is c / s times a's, with c their dot product and s = a's squared length; so b's plane is at b.offset s /
  // c, and (b.offset s - a.offset c) above a, in units of |c| / n times its normal.
  const Enclosed product = dot(a.way, b.way);
  const bool same_way = is_surely_positive(product);
  if (!same_way && !is_surely_negative(product)) return bounds;
  const Enclosed squared = dot(a.way, a.way);
  Enclosed rise = enclosed(b.offset) * squared - enclosed(a.offset) * product;
  if (!same_way) rise = -rise;
  const bool a_is_solid = a.form == BodyForm::solid;
  const bool b_is_solid = b.form == BodyForm::solid;
  if (a_is_solid && b_is_solid && same_way) {
    bounds.is_overlapping = true;
    return bounds;
  }
  Enclosed gap = rise;
  if (!a_is_solid && b_is_solid && same_way) gap = -rise;
  if (!a_is_solid && !b_is_solid) gap = -lesser(rise, -rise);
  // In units of |c| * sqrt(s): gap / |c| in units of a's normal, which has length sqrt(s).
  bounds = bounds_of_height(gap, product * product * squared, enclosed(0));
  bounds.largest = std::max(least_distance_from_origin(a), least_distance_from_origin(b));
  return bounds;
}

}  // namespace graze::test
