// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>

#include <graze/math/orientation.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// All x with dot(normal, x) = offset: a plane, in 2D a line. The normal may have any nonzero length.
template <Dim N, class T = float>
struct Plane {
  Vec<N, T> normal = unit_axis<N, T>(1);  ///< Any nonzero length; points to the positive side.
  T offset = T(0);  ///< dot(normal, x) on the plane: the distance from the origin times the length of the normal.
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Plane<N, T>> = Description("plane",
                                                                field::direction("normal", &Plane<N, T>::normal),
                                                                field::offset("offset", &Plane<N, T>::offset));
}  // namespace detail

/// The same plane with a normal of length 1, in double. Nothing overflows or underflows except the offset, which is
/// infinite if the plane is farther away than doubles reach.
template <Dim N, class T>
Plane<N, double> unit_plane(const Plane<N, T>& plane) {
  // Divides by the largest coordinate first, so that the squares stay in range.
  const double size = static_cast<double>(max_abs(plane.normal));  // not zero in a valid plane
  const Vec<N, double> scaled = wide<N, T>(plane.normal) / size;
  const double length = std::sqrt(dot(scaled, scaled));
  return {scaled / length, static_cast<double>(plane.offset) / size / length};
}

namespace detail {
template <Dim N, class T>
Plane<N, T> plane_at(const Vec<N, double>& normal, const Vec<N, T>& point) {
  const Plane<N, T> plane{Vec<N, T>(normal), static_cast<T>(dot(normal, wide<N, T>(point)))};
  if (!defect(plane).empty()) {
    GRAZE_THROW(
        std::invalid_argument("plane_through: the points are too close together or too far away for the normal and "
                              "offset to be numbers of their type"));
  }
  return plane;
}

/// Exact: points are collinear if their projections on the three coordinate planes are.
template <class T>
bool are_on_one_line(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c) {
  for (Dim i = 0; i < 3; ++i) {
    const auto shadow = [i](const Vec<3, T>& v) { return Vec<2, T>(v[(i + 1) % 3], v[(i + 2) % 3]); };
    if (orientation(shadow(a), shadow(b), shadow(c)) != 0) return false;
  }
  return true;
}
}  // namespace detail

/// The plane through three points. The normal points to the side from which they run counter-clockwise; its length is
/// twice the area of their triangle. Throws std::invalid_argument if the points are collinear, which is decided
/// exactly, or if T cannot represent the normal or the offset.
template <class T>
Plane<3, T> plane_through(const Vec<3, T>& a, const Vec<3, T>& b, const Vec<3, T>& c) {
  if (detail::are_on_one_line(a, b, c))
    GRAZE_THROW(std::invalid_argument("plane_through: the three points lie on one line"));
  const Vec<3, double> normal = accurate_cross(wide<3, T>(b) - wide<3, T>(a), wide<3, T>(c) - wide<3, T>(a));
  return detail::plane_at<3, T>(normal, a);
}

/// The line through two points. The normal points to the left of the way from a to b; its length is their distance.
/// Throws std::invalid_argument if the points are equal or T cannot represent the offset.
template <class T>
Plane<2, T> plane_through(const Vec<2, T>& a, const Vec<2, T>& b) {
  if (a == b) GRAZE_THROW(std::invalid_argument("plane_through: the two points are equal"));
  return detail::plane_at<2, T>(perpendicular(wide<2, T>(b) - wide<2, T>(a)), a);
}

}  // namespace graze
