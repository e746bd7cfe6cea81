// SPDX-License-Identifier: MIT
// The closed forms of relation.hpp for a point and a 2D polygon. Include relation.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include <graze/math/orientation.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// Whether a point next to a polygon touches it, within the rounding that `contains` allows, too. `rescaled()` is
/// called first if the pair is not of usual size.
template <class T, class Rescaled>
Relation relation_from_outside(Corners<T> corners, const Vec<2, T>& point, const Rescaled& rescaled) {
  const Vec<2, double> p = wide<2, T>(point);
  double own_size = 0;
  for (const Vec<2, T>& corner : corners) own_size = std::max(own_size, sum_abs(p - wide<2, T>(corner)));
  if (!is_usual_size<T>(own_size)) {
    if (const std::optional<Relation> verdict = rescaled()) return *verdict;
  }
  const double distance = surface_point_of<T>(corners, p).distance;
  return distance <= tolerance::rounding * own_size ? Relation::touching : Relation::apart;
}

/// Inside, on an edge or outside, exactly; slightly outside still counts as touching. Corners as in Polytope.
template <class T, class Rescaled>
Relation relation_to_polygon(Corners<T> corners, const Vec<2, T>& point, const Rescaled& rescaled) {
  const std::size_t count = corners.size();
  if (count < 3 || orientation(corners[0], corners[1], corners[2]) == 0)
    return relation_from_outside<T>(corners, point, rescaled);
  Relation verdict = Relation::overlapping;
  for (std::size_t i = 0; i < count; ++i) {
    const int turn = orientation(corners[i], corners[i + 1 < count ? i + 1 : 0], point);
    if (turn < 0) return relation_from_outside<T>(corners, point, rescaled);
    if (turn == 0) verdict = Relation::touching;
  }
  return verdict;
}

/// The same for any order of the corners.
template <class T>
Relation closed_form(const Vec<2, T>& point, const Triangle<2, T>& triangle) {
  auto corners = triangle.vertices();
  std::sort(corners.begin(), corners.end(), lexicographically_less<2, T>);
  return relation_to_polygon<T>(counter_clockwise(Triangle<2, T>{corners[0], corners[1], corners[2]}), point,
                                [&] { return verdict_in_range(point, triangle); });
}

template <class T>
Relation closed_form(const Vec<2, T>& point, const Polytope<2, T>& polygon) {
  return relation_to_polygon<T>(polygon.vertices(), point, [&] { return verdict_in_range(point, polygon); });
}

}  // namespace graze::detail
