// SPDX-License-Identifier: MIT
// The nearest points of two nearly parallel 3D segments. The distance hardly changes along such segments, so comparing
// distances cannot find its minimum: it is calculated in twice the precision of double.
#pragma once

#include <algorithm>
#include <optional>

#include <graze/math/exact/twofold.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/closest_on_core.hpp>
#include <graze/shape/segment.hpp>

namespace graze::detail {

/// Whether the angle between two edges is so close to 0 or 180 degrees that distances lose too many digits.
inline bool are_nearly_parallel(const Vec<3, double>& a, const Vec<3, double>& b) {
  constexpr double most_sine = 1.0 / 8;
  const Vec<3, double> normal = cross(a, b);
  return max_abs(normal) <= most_sine * (max_abs(a) * max_abs(b));
}

/// Where the line of segment a is nearest to that of b, in lengths of a. With u and v along a and b, w from a's start
/// to b's, n = u x v, it is det(w, v, n) / n^2. None if they are parallel.
inline std::optional<double> place_of_perpendicular(const Segment<3, double>& a, const Segment<3, double>& b) {
  const TwofoldVec<3> u = twofold_difference(a.end, a.start);
  const TwofoldVec<3> v = twofold_difference(b.end, b.start);
  const TwofoldVec<3> n = twofold_normal(u, v);
  if (!(max_abs(rounded(n)) > 0)) return std::nullopt;
  const double whole = twofold_determinant({u, v, n});  // (u x v) . n
  return twofold_determinant({twofold_difference(b.start, a.start), v, n}) / whole;
}

/// The nearest points of two separate segments, relative to `origin`: none if they are parallel, or not nearly. The
/// nearest point of a's line, clamped to a, has the nearest point of b's line opposite; if that is clamped too, b's end
/// is nearest, with its own projection to a (Ericson, Real-Time Collision Detection, 5.1.9). Every step is as accurate
/// as its points, unlike that of the perpendicular alone.
inline std::optional<ClosestPair<3>> closest_of_nearly_parallel(const Segment<3, double>& a,
                                                                const Segment<3, double>& b,
                                                                const Vec<3, double>& origin) {
  if (!are_nearly_parallel(a.end - a.start, b.end - b.start)) return std::nullopt;
  const std::optional<double> place = place_of_perpendicular(a, b);
  if (!place) return std::nullopt;
  const Segment<3, double> local_a{a.start - origin, a.end - origin};
  const Segment<3, double> local_b{b.start - origin, b.end - origin};
  const double share = std::clamp(*place, 0.0, 1.0);
  const Vec<3, double> edge = local_a.end - local_a.start;
  const Vec<3, double> on_a = share <= 0.5 ? local_a.start + edge * share : local_a.end - edge * (1 - share);
  const ClosestOnCore<3> on_b = closest_on(local_b, on_a);
  ClosestPair<3> pair;
  if (is_between_ends(on_b)) {
    pair.offer_from_a(on_a, on_b);
  } else {
    pair.offer_from_b(on_b.point, closest_on(local_a, on_b.point));
  }
  return pair;
}

}  // namespace graze::detail
