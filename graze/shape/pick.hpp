// SPDX-License-Identifier: MIT
/// @file
/// Finds the ray or point of the world that is shown at a point of the screen.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/clip_space.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// Converts window coordinates to device coordinates. Pixels count from the upper left corner of the window to the
/// right and down; the center of the first one is (0.5, 0.5). Device coordinates run from -1 to 1, to the right and up.
/// Throws std::invalid_argument if the window has no area.
template <class T>
Vec<2, T> device_point(const Vec<2, T>& pixel, const Vec<2, T>& window_size) {
  if (!(window_size.x > T(0) && window_size.y > T(0))) {
    GRAZE_THROW(std::invalid_argument("device_point: the window has no area; its width and height must be above zero"));
  }
  const Vec<2, double> share = wide<2, T>(pixel) / wide<2, T>(window_size);
  return Vec<2, T>(Vec<2, double>(2 * share.x - 1, 1 - 2 * share.y));
}

namespace detail {

template <Dim N, class T>
ClipSpace<N> clip_space_for_picking(const Mat<N + 1, T>& view_projection, const Vec<2, T>& device,
                                    std::string_view function) {
  const ClipSpace<N> clip(view_projection);
  const std::string name(function);
  if (!clip.has_finite_numbers())
    GRAZE_THROW(std::invalid_argument(name + ": the matrix has a number that is not finite"));
  if (!is_finite(device)) GRAZE_THROW(std::invalid_argument(name + ": the point has a coordinate that is not finite"));
  return clip;
}

}  // namespace detail

/// Everything that a 3D camera shows at one point of the device: a ray that starts on the near plane, with a direction
/// of length 1, so that t is a distance. Calculated in double and rounded to T. Accepts projections without a far
/// plane. Throws std::invalid_argument if a number is not finite or the matrix shows no line at that point.
template <class T>
Ray<3, T> pick_ray(const Mat<4, T>& view_projection, const std::type_identity_t<Vec<2, T>>& device,
                   ClipDepth depth = ClipDepth::minus_one_to_one) {
  const auto clip = detail::clip_space_for_picking<3, T>(view_projection, device, "pick_ray");
  const auto column = clip.level(0, static_cast<double>(device.x));
  const auto row = clip.level(1, static_cast<double>(device.y));
  const auto near_plane = clip.level(2, detail::near_depth(depth));
  Vec<3, double> direction = accurate_cross(column.normal, row.normal);
  const bool depth_grows = detail::near_depth(depth) < detail::far_depth(depth);
  if ((dot(near_plane.normal, direction) > 0) != depth_grows) direction = -direction;
  direction /= std::sqrt(length_squared(direction));
  const Vec<3, double> origin = detail::meeting_point({column, row, near_plane});
  const Ray<3, T> ray{Vec<3, T>(origin) + T(0), Vec<3, T>(direction) + T(0)};  // never minus zero
  if (!defect(ray).empty()) GRAZE_THROW(std::invalid_argument("pick_ray: the matrix is not that of a camera"));
  return ray;
}

/// The point that a 2D camera shows at one point of the device. Calculated in double and rounded to T. Throws
/// std::invalid_argument if a number is not finite or the matrix shows no single point there.
template <class T>
Vec<2, T> pick_point(const Mat<3, T>& view_projection, const std::type_identity_t<Vec<2, T>>& device) {
  const auto clip = detail::clip_space_for_picking<2, T>(view_projection, device, "pick_point");
  const auto column = clip.level(0, static_cast<double>(device.x));
  const auto row = clip.level(1, static_cast<double>(device.y));
  const Vec<2, T> point = Vec<2, T>(detail::meeting_point({column, row})) + T(0);
  if (!is_finite(point)) GRAZE_THROW(std::invalid_argument("pick_point: the matrix is not that of a camera"));
  return point;
}

}  // namespace graze
