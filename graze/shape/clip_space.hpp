// SPDX-License-Identifier: MIT
/// @file
/// The meaning of a view-projection matrix: it maps a point p, extended by a coordinate 1, to clip coordinates: (x, y,
/// z, w) in 3D, (x, y, w) in 2D. The point is visible at the device coordinates (x / w, y / w) if w is positive, both
/// are from -1 to 1, and in 3D z / w is between its values on the near and far plane.
#pragma once

#include <array>
#include <cmath>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// The range of z / w, which the matrix alone does not tell.
enum class ClipDepth {
  minus_one_to_one,  ///< OpenGL; also glm::perspective unless GLM_FORCE_DEPTH_ZERO_TO_ONE is defined.
  zero_to_one,       ///< Near 0, far 1: Direct3D, Vulkan, Metal, WebGPU.
  one_to_zero,       ///< Near 1, far 0: reversed depth, for the same interfaces with better precision.
};

namespace detail {

constexpr double near_depth(ClipDepth depth) {
  if (depth == ClipDepth::one_to_zero) return 1;
  return depth == ClipDepth::zero_to_one ? 0 : -1;
}

constexpr double far_depth(ClipDepth depth) { return depth == ClipDepth::one_to_zero ? 0 : 1; }

/// All x with dot(normal, x) + offset = 0. If the normal is zero, that is all points or none.
template <Dim N>
struct ClipPlane {
  Vec<N, double> normal;
  double offset;

  double height(const Vec<N, double>& point) const { return dot(normal, point) + offset; }
};

/// The common point of the planes. Not finite if there is none or more than one.
inline Vec<2, double> meeting_point(const std::array<ClipPlane<2>, 2>& lines) {
  const auto& [a, b] = lines;
  const double area = accurate_cross(a.normal, b.normal);
  return (perpendicular(b.normal) * a.offset - perpendicular(a.normal) * b.offset) / area;
}

inline Vec<3, double> meeting_point(const std::array<ClipPlane<3>, 3>& planes) {
  const auto& [a, b, c] = planes;
  const Vec<3, double> of_a = accurate_cross(b.normal, c.normal);
  const double volume = dot(a.normal, of_a);
  return (of_a * -a.offset - accurate_cross(c.normal, a.normal) * b.offset -
          accurate_cross(a.normal, b.normal) * c.offset) /
         volume;
}

/// The rows of a matrix, each a function of the point, in double.
template <Dim N>
class ClipSpace {
 public:
  template <class T>
  explicit ClipSpace(const Mat<N + 1, T>& view_projection) {
    for (Dim row = 0; row <= N; ++row) {
      ClipPlane<N>& plane = rows_[static_cast<std::size_t>(row)];
      for (Dim j = 0; j < N; ++j) plane.normal[j] = static_cast<double>(view_projection[j][row]);
      plane.offset = static_cast<double>(view_projection[N][row]);
    }
  }

  bool has_finite_numbers() const {
    for (const ClipPlane<N>& row : rows_) {
      if (!is_finite(row.normal) || !std::isfinite(row.offset)) return false;
    }
    return true;
  }

  /// The plane on which clip coordinate `axis`, divided by w, has this value.
  ClipPlane<N> level(Dim axis, double value) const {
    const ClipPlane<N>& row = rows_[static_cast<std::size_t>(axis)];
    return {row.normal - w().normal * value, row.offset - w().offset * value};
  }

  /// w as a function of the point. For a perspective camera it is zero on the plane through the eye.
  const ClipPlane<N>& w() const { return rows_[N]; }

 private:
  std::array<ClipPlane<N>, N + 1> rows_;
};

}  // namespace detail
}  // namespace graze
