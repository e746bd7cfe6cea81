// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include <graze/math/platform/throw.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/clip_space.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// The view volume of a camera: the convex hull of its corners, eight in 3D, four in 2D. Bit 0 of a corner's index
/// tells left (0) from right (1), bit 1 bottom from top, bit 2 the near from the far plane. Corners may coincide, so a
/// pyramid is a frustum. It is not an alternative of AnyShape; where you need one, `convex_hull<N, T>(frustum.corners)`
/// is the same set.
template <Dim N, class T = float>
struct Frustum {
  static constexpr std::size_t corner_count = std::size_t{1} << static_cast<unsigned>(N);  ///< 8 in 3D, 4 in 2D.

  std::array<Vec<N, T>, corner_count> corners = unit_corners();  ///< Default: the box from -1 to 1.

 private:
  static constexpr std::array<Vec<N, T>, corner_count> unit_corners() {
    std::array<Vec<N, T>, corner_count> corners{};
    for (std::size_t k = 0; k < corner_count; ++k) {
      for (Dim i = 0; i < N; ++i) corners[k][i] = ((k >> static_cast<unsigned>(i)) & 1U) != 0 ? T(1) : T(-1);
    }
    return corners;
  }
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Frustum<N, T>> = Description("", field::corners("corners", &Frustum<N, T>::corners,
                                                                                     "corner"));
}  // namespace detail

/// The corner that is farthest along `direction` (any nonzero length), in double; of several the first.
template <Dim N, class T>
Vec<N, double> support(const Frustum<N, T>& frustum, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> best = wide<N, T>(frustum.corners[0]);
  double height = dot(best, direction);
  for (std::size_t k = 1; k < frustum.corners.size(); ++k) {
    const Vec<N, double> corner = wide<N, T>(frustum.corners[k]);
    const double candidate = dot(corner, direction);
    if (candidate > height) {
      height = candidate;
      best = corner;
    }
  }
  return best;
}

/// How a view-projection matrix is to be read.
struct FrustumOptions {
  ClipDepth depth = ClipDepth::minus_one_to_one;  ///< The depth range that the projection was made for.
  /// The largest distance from the plane through the eye that is seen, above zero. Required for a projection without a
  /// far plane. Without effect if the far plane is nearer, and for projections without perspective.
  double far_limit = std::numeric_limits<double>::infinity();
};

namespace detail {

/// The corner with index k; in 3D it lies on the plane `last`, the near or the far one.
template <Dim N>
Vec<N, double> frustum_corner(const ClipSpace<N>& clip, std::size_t k, const ClipPlane<N>& last) {
  std::array<ClipPlane<N>, static_cast<std::size_t>(N)> planes;
  planes.fill(last);
  planes[0] = clip.level(0, (k & 1U) != 0 ? 1 : -1);
  planes[1] = clip.level(1, (k & 2U) != 0 ? 1 : -1);
  return meeting_point(planes);
}

/// The corners on the far plane; those on the plane at the limit if one of them is beyond it, at infinity, or behind
/// the eye.
inline std::array<Vec<3, double>, 4> far_corners(const ClipSpace<3>& clip, const FrustumOptions& options) {
  const double unit = std::sqrt(length_squared(clip.w().normal));
  const double limit = unit > 0 ? options.far_limit * unit : std::numeric_limits<double>::infinity();
  const auto corners_on = [&clip](const ClipPlane<3>& plane) {
    std::array<Vec<3, double>, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = frustum_corner(clip, k, plane);
    return corners;
  };
  const std::array<Vec<3, double>, 4> corners = corners_on(clip.level(2, far_depth(options.depth)));
  for (const Vec<3, double>& corner : corners) {
    const double w = clip.w().height(corner);
    if (is_finite(corner) && w > 0 && w <= limit) continue;
    if (std::isfinite(limit)) return corners_on({clip.w().normal, clip.w().offset - limit});
    GRAZE_THROW(std::invalid_argument(
        "frustum_of: the projection has no far plane; say in far_limit how far off things are seen"));
  }
  return corners;
}

template <Dim N, class T>
Frustum<N, T> rounded_frustum(const std::array<Vec<N, double>, Frustum<N, T>::corner_count>& corners,
                              const ClipSpace<N>& clip) {
  Frustum<N, T> frustum;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (!(clip.w().height(corners[k]) > 0)) {
      GRAZE_THROW(std::invalid_argument(
          "frustum_of: the matrix is not that of a camera: it sees nothing, or what is behind it"));
    }
    frustum.corners[k] = Vec<N, T>(corners[k]) + T(0);  // never minus zero
  }
  if (!defect(frustum).empty()) {
    GRAZE_THROW(
        std::invalid_argument("frustum_of: a corner is too far away for numbers of its type; give a far_limit"));
  }
  return frustum;
}

template <Dim N>
void require_finite_matrix(const ClipSpace<N>& clip, std::string_view function) {
  if (clip.has_finite_numbers()) return;
  GRAZE_THROW(std::invalid_argument(std::string(function) + ": the matrix has a number that is not finite"));
}

}  // namespace detail

/// The view volume of a 3D camera, from its view-projection matrix: the intersections of the six planes that the rows
/// of the matrix describe (Gribb and Hartmann 2001), calculated in double and rounded to T. Throws
/// std::invalid_argument if a number is not finite, the matrix is not that of a camera, it has no far plane and
/// `far_limit` is infinite, `far_limit` is not above zero, or a corner is out of the range of T.
template <class T>
Frustum<3, T> frustum_of(const Mat<4, T>& view_projection, const FrustumOptions& options = {}) {
  const detail::ClipSpace<3> clip(view_projection);
  detail::require_finite_matrix(clip, "frustum_of");
  if (!(options.far_limit > 0)) GRAZE_THROW(std::invalid_argument("frustum_of: far_limit is not above zero"));
  const auto near_plane = clip.level(2, detail::near_depth(options.depth));
  const auto far = detail::far_corners(clip, options);
  std::array<Vec<3, double>, 8> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = detail::frustum_corner(clip, k, near_plane);
    corners[k + 4] = far[k];
  }
  return detail::rounded_frustum<3, T>(corners, clip);
}

/// The view area of a 2D camera: the quadrilateral that fills the screen. Throws std::invalid_argument if a number is
/// not finite, the matrix is not that of a camera, or a corner is out of the range of T.
template <class T>
Frustum<2, T> frustum_of(const Mat<3, T>& view_projection) {
  const detail::ClipSpace<2> clip(view_projection);
  detail::require_finite_matrix(clip, "frustum_of");
  std::array<Vec<2, double>, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = detail::frustum_corner(clip, k, clip.w());
  return detail::rounded_frustum<2, T>(corners, clip);
}

}  // namespace graze
