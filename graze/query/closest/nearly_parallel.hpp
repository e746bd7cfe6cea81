// SPDX-License-Identifier: MIT
// The nearest points of two nearly parallel 3D segments. The distance hardly changes along such segments, so comparing
// distances cannot find its minimum: it is calculated in twice the precision of double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/orientation_3d.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/closest_on_core.hpp>
#include <graze/shape/segment.hpp>

namespace graze::detail {

/// A vector whose coordinates are sums of two doubles.
using TwofoldVec = std::array<Rounded, 3>;

/// b - a, exactly.
inline TwofoldVec twofold_difference(const Vec<3, double>& b, const Vec<3, double>& a) {
  return {two_sum(b.x, -a.x), two_sum(b.y, -a.y), two_sum(b.z, -a.z)};
}

/// a x b, scaled to a length of about 1, with errors around epsilon squared divided by the sine: the factor is a power
/// of two. Zero if the product is.
inline TwofoldVec twofold_normal(const TwofoldVec& a, const TwofoldVec& b) {
  TwofoldVec normal{};
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Rounded left = two_product(a[j].value, b[k].value);
    const Rounded right = two_product(a[k].value, b[j].value);
    const double left_rest = left.error + (a[j].value * b[k].error + a[j].error * b[k].value);
    const double right_rest = right.error + (a[k].value * b[j].error + a[k].error * b[j].value);
    const Rounded difference = two_sum(left.value, -right.value);
    normal[i] = two_sum(difference.value, difference.error + (left_rest - right_rest));
    size = std::max(size, std::fabs(normal[i].value));
  }
  int exponent = 0;
  (void)std::frexp(size, &exponent);
  for (Rounded& x : normal) x = {std::ldexp(x.value, -exponent), std::ldexp(x.error, -exponent)};
  return normal;
}

/// Whether the angle between two edges is so close to 0 or 180 degrees that distances lose too many digits.
inline bool are_nearly_parallel(const Vec<3, double>& a, const Vec<3, double>& b) {
  constexpr double most_sine = 1.0 / 8;
  const Vec<3, double> normal = cross(a, b);
  return max_abs(normal) <= most_sine * (max_abs(a) * max_abs(b));
}

/// Where the line of segment a is nearest to that of b, in lengths of a. With u and v along a and b, w from a's start
/// to b's, n = u x v, it is det(w, v, n) / n^2. None if they are parallel.
inline std::optional<double> place_of_perpendicular(const Segment<3, double>& a, const Segment<3, double>& b) {
  const TwofoldVec u = twofold_difference(a.end, a.start);
  const TwofoldVec v = twofold_difference(b.end, b.start);
  const TwofoldVec n = twofold_normal(u, v);
  const Vec<3, double> n0(n[0].value, n[1].value, n[2].value);
  if (!(max_abs(n0) > 0)) return std::nullopt;
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
