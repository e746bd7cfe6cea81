// SPDX-License-Identifier: MIT
// Whether a bounding volume as stored contains a point, in rational numbers. Compiled once for each space, by
// exact.cpp.in.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::test {

template <Dim N, class T>
bool contains_exactly(const Sphere<N, T>& sphere, const Vec<N, T>& point);

/// The box is all center + axes * u with |u[i]| <= half_extents[i], whatever the axes are.
template <Dim N, class T>
bool contains_exactly(const Obb<N, T>& box, const Vec<N, T>& point);

/// Comparisons only.
template <Dim N, class T>
bool contains_exactly(const Aabb<N, T>& box, const Vec<N, T>& point) {
  for (Dim i = 0; i < N; ++i) {
    if (!(box.min[i] <= point[i] && point[i] <= box.max[i])) return false;
  }
  return true;
}

extern template bool contains_exactly(const Sphere<2, float>&, const Vec<2, float>&);
extern template bool contains_exactly(const Obb<2, float>&, const Vec<2, float>&);
extern template bool contains_exactly(const Sphere<3, float>&, const Vec<3, float>&);
extern template bool contains_exactly(const Obb<3, float>&, const Vec<3, float>&);
extern template bool contains_exactly(const Sphere<2, double>&, const Vec<2, double>&);
extern template bool contains_exactly(const Obb<2, double>&, const Vec<2, double>&);
extern template bool contains_exactly(const Sphere<3, double>&, const Vec<3, double>&);
extern template bool contains_exactly(const Obb<3, double>&, const Vec<3, double>&);

}  // namespace graze::test
