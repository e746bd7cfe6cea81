// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N, class T>
bool covers(const Aabb<N, T>& bounds, const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    if (box.min[i] < bounds.min[i] || box.max[i] > bounds.max[i]) return false;
  }
  return true;
}

/// Branch-free is_valid.
template <Dim N, class T>
bool is_finite_box(const Aabb<N, T>& box) {
  constexpr T most = std::numeric_limits<T>::max();
  unsigned faults = 0;
  for (Dim i = 0; i < N; ++i) {
    faults |= box.min[i] >= -most ? 0U : 1U;
    faults |= box.max[i] >= box.min[i] ? 0U : 1U;
    faults |= box.max[i] <= most ? 0U : 1U;
  }
  return faults == 0;
}

/// Branch-free Aabb::grow, for boxes without NaN.
template <Dim N, class T>
void grow_at_once(Aabb<N, T>& bounds, const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    bounds.min[i] = box.min[i] < bounds.min[i] ? box.min[i] : bounds.min[i];
    bounds.max[i] = box.max[i] > bounds.max[i] ? box.max[i] : bounds.max[i];
  }
}

template <Dim N, class T>
Aabb<N, T> box_around(Aabb<N, T> a, const Aabb<N, T>& b) {
  grow_at_once(a, b);
  return a;
}

/// The expected cost of a box for a query, up to a factor: the probability that a random line hits it, which is
/// proportional to its surface area, in 2D to its perimeter (Goldsmith and Salmon 1987, "Automatic creation of object
/// hierarchies for ray tracing"). Infinite or NaN if the product overflows.
template <Dim N, class T>
double surface_of(const Aabb<N, T>& box) {
  Vec<N, double> side;
  for (Dim i = 0; i < N; ++i) side[i] = static_cast<double>(box.max[i]) - static_cast<double>(box.min[i]);
  if constexpr (N == 2) return side[0] + side[1];
  if constexpr (N == 3) return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

}  // namespace graze::detail
