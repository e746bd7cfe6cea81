// SPDX-License-Identifier: MIT
// bounding_box(points): the smallest axis-aligned box around points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/math/platform/throw.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {
namespace detail {

/// The error for points without a bounding volume, naming the called function.
template <Dim N, class T>
[[noreturn]] void refuse_points(std::span<const Vec<N, T>> points, const std::string& function) {
  if (points.empty()) GRAZE_THROW(std::invalid_argument(function + ": there are no points"));
  const auto bad = std::find_if(points.begin(), points.end(), [](const Vec<N, T>& point) { return !is_finite(point); });
  GRAZE_THROW(std::invalid_argument(function + ": point " + std::to_string(bad - points.begin()) +
                                    " has a coordinate that is not finite"));
}

/// The box of points. It validates them: at least one, all finite.
template <Dim N, class T>
Aabb<N, T> checked_box(std::span<const Vec<N, T>> points, const char* function) {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  bool finite = !points.empty();
  for (const Vec<N, T>& point : points) {
    for (Dim i = 0; i < N; ++i) {
      // Conditional moves: the loop runs at memory speed.
      box.min[i] = point[i] < box.min[i] ? point[i] : box.min[i];
      box.max[i] = point[i] > box.max[i] ? point[i] : box.max[i];
      finite &= std::fabs(point[i]) <= std::numeric_limits<T>::max();
    }
  }
  if (!finite) refuse_points(points, function);
  return box;
}

/// Local coordinates in which a set of points has about unit size and is near the origin: squares and products of three
/// differences stay in the range of double, and a set far from the origin loses no precision.
template <Dim N>
struct LocalFrame {
  Vec<N, double> origin;
  double scale;  ///< A power of two: scaling does not round.

  template <class T>
  Vec<N, double> local(const Vec<N, T>& point) const {
    return (wide<N, T>(point) - origin) * scale;
  }
  Vec<N, double> world(const Vec<N, double>& point) const { return origin + point / scale; }
};

/// The largest side of a box; infinite if it exceeds the largest double.
template <Dim N, class T>
double largest_side(const Aabb<N, T>& box) {
  return max_abs<N, double>(wide<N, T>(box.max) - wide<N, T>(box.min));
}

/// For points in a box whose sides are finite and not all zero. Scales are limited to 2^1000, so that they stay finite
/// for the smallest sets, which can be squared anyway.
template <Dim N, class T>
LocalFrame<N> local_frame(const Aabb<N, T>& box) {
  constexpr int most = 1000;
  const int exponent = std::clamp(-std::ilogb(largest_side(box)), -most, most);
  return {wide<N, T>(box.min) * 0.5 + wide<N, T>(box.max) * 0.5, std::ldexp(1.0, exponent)};
}

}  // namespace detail

/// The smallest axis-aligned box that contains the points; exact. Throws std::invalid_argument if there are no points
/// or a coordinate is not finite.
template <Dim N, class T>
Aabb<N, T> bounding_box(std::span<const Vec<N, T>> points) {
  return detail::checked_box(points, "bounding_box");
}

/// The overload for a vector or a braced list.
template <Dim N, class T>
Aabb<N, T> bounding_box(const std::vector<Vec<N, T>>& points) {
  return bounding_box(std::span<const Vec<N, T>>(points));
}

/// The overload for anything that converts to a span of points.
template <PointRow Row>
auto bounding_box(const Row& points) {
  return bounding_box(span_of(points));
}

/// The overload with the dimension given explicitly.
template <Dim N, PointRowIn<N> Row>
auto bounding_box(const Row& points) {
  return bounding_box(span_of(points));
}

}  // namespace graze
