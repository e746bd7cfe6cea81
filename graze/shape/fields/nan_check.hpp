// SPDX-License-Identifier: MIT
// hold_nan(a, b): whether any number of two shapes is NaN. Comparisons drop a NaN as easily as not; sums keep it.
#pragma once

#include <cmath>
#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- The sum of a shape's absolute numbers, which may overflow. A polytope holds no NaN; a user's type is not looked
// into.

template <class S>
float numbers_of(const S&) {
  return 0;
}

template <Dim N, class T>
T numbers_of(const Vec<N, T>& v) {
  T sum = std::fabs(v[0]);
  for (Dim i = 1; i < N; ++i) sum += std::fabs(v[i]);
  return sum;
}

template <Dim N, class T>
T numbers_of(const Segment<N, T>& segment) {
  return numbers_of(segment.start) + numbers_of(segment.end);
}

template <Dim N, class T>
T numbers_of(const Ray<N, T>& ray) {
  return numbers_of(ray.origin) + numbers_of(ray.direction);
}

template <Dim N, class T>
T numbers_of(const Sphere<N, T>& sphere) {
  return numbers_of(sphere.center) + std::fabs(sphere.radius);
}

template <Dim N, class T>
T numbers_of(const Aabb<N, T>& box) {
  return numbers_of(box.min) + numbers_of(box.max);
}

template <Dim N, class T>
T numbers_of(const Obb<N, T>& box) {
  T sum = numbers_of(box.center) + numbers_of(box.half_extents);
  for (Dim i = 0; i < N; ++i) sum += numbers_of<N, T>(box.axes[i]);
  return sum;
}

template <Dim N, class T>
T numbers_of(const Plane<N, T>& plane) {
  return numbers_of(plane.normal) + std::fabs(plane.offset);
}

template <Dim N, class T>
T numbers_of(const HalfSpace<N, T>& solid) {
  return numbers_of(boundary(solid));
}

template <Dim N, class T>
T numbers_of(const Triangle<N, T>& triangle) {
  return numbers_of(triangle.a) + numbers_of(triangle.b) + numbers_of(triangle.c);
}

template <Dim N, class T>
T numbers_of(const Capsule<N, T>& capsule) {
  return numbers_of(axis(capsule)) + std::fabs(capsule.radius);
}

template <Dim N, class T>
T numbers_of(const Frustum<N, T>& frustum) {
  T sum = numbers_of(frustum.corners[0]);
  for (std::size_t k = 1; k < frustum.corners.size(); ++k) sum += numbers_of(frustum.corners[k]);
  return sum;
}

template <class A, class B>
bool hold_nan(const A& a, const B& b) {
  return std::isnan(numbers_of(a) + numbers_of(b));
}

}  // namespace graze::detail
