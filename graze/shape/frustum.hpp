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

/// What a camera sees: the convex hull of its corners, eight in space, four in the plane. Corner k is on the right if
/// bit 0 of k is set, at the top if bit 1 is, on the far plane if bit 2 is. Corners may coincide: a pyramid is a
/// frustum. It is no alternative of AnyShape; where one is wanted, `convex_hull<N, T>(frustum.corners)` is the same
/// set.
template <Dim N, class T = float>
struct Frustum {
  static constexpr std::size_t corner_count = std::size_t{1} << static_cast<unsigned>(N);

  std::array<Vec<N, T>, corner_count> corners = unit_corners();  ///< Default: those of the box from -1 to 1.

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
  ClipDepth depth = ClipDepth::minus_one_to_one;
  /// No more is seen than what is this far off the plane through the eye. A projection without a far plane needs it,
  /// one with a nearer far plane does not notice it, nor does one without perspective.
  double far_limit = std::numeric_limits<double>::infinity();
};

namespace detail {

/// The corner that bits of k say, in space with this plane for the near or the far one.
template <Dim N>
Vec<N, double> frustum_corner(const ClipSpace<N>& clip, std::size_t k, const ClipPlane<N>& last) {
  std::array<ClipPlane<N>, static_cast<std::size_t>(N)> planes;
  planes.fill(last);
  planes[0] = clip.level(0, (k & 1U) != 0 ? 1 : -1);
  planes[1] = clip.level(1, (k & 2U) != 0 ? 1 : -1);
  return meeting_point(planes);
}

/// The corners of the far plane; those of the limit if one of them is beyond it, at infinity, or behind the eye.
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

/// What a camera in space sees, by its view-projection matrix: where the planes meet that its rows describe (Gribb and
/// Hartmann 2001), calculated in double and rounded to T. Throws std::invalid_argument for a matrix with a number that
/// is not finite, one that is not that of a camera, and one without a far plane if there is no `far_limit`.
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

/// The same in the plane, where nothing is near or far: the quadrilateral that fills the screen.
template <class T>
Frustum<2, T> frustum_of(const Mat<3, T>& view_projection) {
  const detail::ClipSpace<2> clip(view_projection);
  detail::require_finite_matrix(clip, "frustum_of");
  std::array<Vec<2, double>, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = detail::frustum_corner(clip, k, clip.w());
  return detail::rounded_frustum<2, T>(corners, clip);
}

}  // namespace graze
