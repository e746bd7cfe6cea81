// SPDX-License-Identifier: MIT
// Vectors, matrices, poses, motions and rays of C as those of a world, and back.
#pragma once

#include <string>
#include <string_view>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/ray.hpp>

#include "../graze.h"
#include "errors.hpp"

namespace graze::c {

/// Rounded to the numbers of the world.
template <Dim N, class T>
Vec<N, T> vec_in(const graze_vec& vector) {
  if constexpr (N == 2) {
    return {static_cast<T>(vector.x), static_cast<T>(vector.y)};
  } else {
    return {static_cast<T>(vector.x), static_cast<T>(vector.y), static_cast<T>(vector.z)};
  }
}

template <Dim N, class T>
graze_vec vec_out(const Vec<N, T>& vector) {
  graze_vec result{};
  result.x = static_cast<double>(vector.x);
  result.y = static_cast<double>(vector.y);
  if constexpr (N == 3) result.z = static_cast<double>(vector.z);
  return result;
}

template <Dim N, class T>
Mat<N, T> mat_in(const graze_mat& matrix) {
  Mat<N, T> result;
  for (Dim j = 0; j < N; ++j) result[j] = vec_in<N, T>(matrix.columns[j]);
  return result;
}

template <Dim N, class T>
graze_mat mat_out(const Mat<N, T>& matrix) {
  graze_mat result{};
  for (Dim j = 0; j < N; ++j) result.columns[j] = vec_out<N, T>(matrix[j]);
  if constexpr (N == 2) result.columns[2].z = 1;
  return result;
}

inline void require_valid(std::string_view role, std::string_view fault) {
  if (!fault.empty()) throw Error(GRAZE_INVALID_ARGUMENT, std::string(role) + " " + std::string(fault));
}

/// A point or motion. Throws Error, naming it, if a coordinate is not finite.
template <Dim N, class T>
Vec<N, T> finite_in(std::string_view role, const graze_vec& vector) {
  const auto result = vec_in<N, T>(vector);
  require_valid(role, is_finite(result) ? "" : "has a coordinate that is not finite");
  return result;
}

/// Throws Error if a number is not finite or the rotation is not orthonormal.
template <Dim N, class T>
Pose<N, T> pose_in(std::string_view role, const graze_pose& pose) {
  const Pose<N, T> result{mat_in<N, T>(pose.rotation), finite_in<N, T>(role, pose.position)};
  const bool is_rotation = orthonormal_error(result.rotation) <= tolerance::orthonormal;
  require_valid(role, is_rotation ? "" : "has a rotation that is not orthonormal (unit length, at right angles)");
  return result;
}

/// No motion for a null pointer. Throws Error if a number is not finite.
template <Dim N, class T>
Motion<N, T> motion_in(std::string_view role, const graze_motion* motion) {
  Motion<N, T> result;
  if (motion == nullptr) return result;
  result.linear = vec_in<N, T>(motion->linear);
  result.center = vec_in<N, T>(motion->center);
  if constexpr (N == 2) {
    result.angular = static_cast<T>(motion->angular.z);
  } else {
    result.angular = vec_in<N, T>(motion->angular);
  }
  require_valid(role, is_finite(result) ? "" : "has a number that is not finite");
  return result;
}

/// Throws Error if the ray is not valid.
template <Dim N, class T>
Ray<N, T> ray_in(std::string_view role, const graze_ray& ray) {
  const Ray<N, T> result{vec_in<N, T>(ray.origin), vec_in<N, T>(ray.direction)};
  require_valid(role, defect(result));
  return result;
}

}  // namespace graze::c
