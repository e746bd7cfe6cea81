// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A rigid motion: x goes to rotation * x + position. Default: the identity.
template <Dim N, class T = float>
struct Pose {
  Mat<N, T> rotation = Mat<N, T>(T(1));
  Vec<N, T> position = Vec<N, T>(T(0));
};

/// The image of a point. Calculated in double, rounded once.
template <Dim N, class T>
Vec<N, T> transformed(const Vec<N, T>& point, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(point) + wide<N, T>(pose.position));
}

/// The image of a direction: turned, not moved.
template <Dim N, class T>
Vec<N, T> rotated(const Vec<N, T>& direction, const Pose<N, T>& pose) {
  return Vec<N, T>(wide_matrix<N, T>(pose.rotation) * wide<N, T>(direction));
}

/// The image of a frame of axes (columns): turned, not moved.
template <Dim N, class T>
Mat<N, T> rotated(const Mat<N, T>& axes, const Pose<N, T>& pose) {
  Mat<N, T> result;
  for (Dim j = 0; j < N; ++j) result[j] = rotated<N, T>(axes[j], pose);
  return result;
}

}  // namespace graze
