// SPDX-License-Identifier: MIT
// Poses as consecutive numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

#include "bridge.hpp"

namespace graze::wasm {

/// A position, then an angle in radians or a quaternion x, y, z, w.
template <Dim N>
constexpr std::size_t numbers_in_pose = N == 2 ? 3 : 7;

/// Pose `index` of a consecutive array. Throws std::invalid_argument if a number is not finite or a quaternion is zero.
template <Dim N>
Pose<N, double> pose_at(std::span<const double> numbers, std::size_t index) {
  const std::span<const double> own = numbers.subspan(index * numbers_in_pose<N>, numbers_in_pose<N>);
  for (const double number : own) {
    if (!std::isfinite(number))
      throw std::invalid_argument(fmt::format("pose {} has a number that is not finite", index));
  }
  const Vec<N, double> position = vector_at<N>(own, 0);
  if constexpr (N == 2) {
    return Pose<2, double>::from_angle(position, own[2]);
  } else {
    const Vec<4, double> quaternion(own[3], own[4], own[5], own[6]);
    if (quaternion == Vec<4, double>(0.0)) {
      throw std::invalid_argument(fmt::format("pose {} has a quaternion of length zero", index));
    }
    return Pose<3, double>::from_quaternion(position, quaternion);
  }
}

}  // namespace graze::wasm
