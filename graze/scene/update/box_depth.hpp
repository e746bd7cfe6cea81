// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The minimum distance that one of two boxes must move along an axis until they only touch; negative if they are
/// apart. Each difference is rounded once. Negative or NaN if a box is Aabb::nothing(); otherwise never NaN.
template <Dim N, class T>
T box_depth(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  T depth = std::min(a.max[0] - b.min[0], b.max[0] - a.min[0]);
  for (Dim i = 1; i < N; ++i) depth = std::min(depth, std::min(a.max[i] - b.min[i], b.max[i] - a.min[i]));
  return depth;
}

}  // namespace graze::detail
