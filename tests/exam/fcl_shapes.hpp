// SPDX-License-Identifier: MIT
// Converts graze's shapes to FCL's, with their transforms.
#pragma once

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::exam {

template <class T>
fcl::Vector3<T> vector(const Vec<3, T>& v) {
  return {v.x, v.y, v.z};
}

/// One of FCL's shapes and its transform.
template <class Shape, class T>
struct Placed {
  Shape shape;
  fcl::Transform3<T> pose = fcl::Transform3<T>::Identity();
};

template <class Shape, class T>
Placed<Shape, T> placed_at(const Shape& shape, const fcl::Vector3<T>& center) {
  Placed<Shape, T> placed{shape};
  placed.pose.translation() = center;
  return placed;
}

template <class T>
auto placed(const Sphere<3, T>& sphere) {
  return placed_at<fcl::Sphere<T>, T>(fcl::Sphere<T>(sphere.radius), vector(sphere.center));
}

template <class T>
auto placed(const Aabb<3, T>& box) {
  const Vec<3, T> center = (box.min + box.max) * T(0.5);
  return placed_at<fcl::Box<T>, T>(fcl::Box<T>(vector<T>(box.max - box.min)), vector(center));
}

template <class T>
auto placed(const Obb<3, T>& box) {
  auto result = placed_at<fcl::Box<T>, T>(fcl::Box<T>(vector<T>(box.half_extents * T(2))), vector(box.center));
  for (Dim i = 0; i < 3; ++i) result.pose.linear().col(static_cast<int>(i)) = vector<T>(box.axes[i]);
  return result;
}

/// FCL's capsules are parallel to z.
template <class T>
auto placed(const Capsule<3, T>& capsule) {
  const fcl::Vector3<T> way = vector<T>(capsule.b - capsule.a);
  const Vec<3, T> center = (capsule.a + capsule.b) * T(0.5);
  auto result = placed_at<fcl::Capsule<T>, T>(fcl::Capsule<T>(capsule.radius, way.norm()), vector(center));
  if (way.norm() > 0) {
    result.pose.linear() = Eigen::Quaternion<T>::FromTwoVectors(fcl::Vector3<T>::UnitZ(), way).toRotationMatrix();
  }
  return result;
}

template <class T>
auto placed(const Plane<3, T>& plane) {
  return Placed<fcl::Plane<T>, T>{fcl::Plane<T>(vector(plane.normal), plane.offset)};
}

template <class T>
auto placed(const HalfSpace<3, T>& solid) {
  return Placed<fcl::Halfspace<T>, T>{fcl::Halfspace<T>(vector(solid.normal), solid.offset)};
}

template <class S>
inline constexpr bool is_triangle = false;
template <class T>
inline constexpr bool is_triangle<Triangle<3, T>> = true;
template <class S>
inline constexpr bool is_plane_or_half_space = false;
template <class T>
inline constexpr bool is_plane_or_half_space<Plane<3, T>> = true;
template <class T>
inline constexpr bool is_plane_or_half_space<HalfSpace<3, T>> = true;

}  // namespace graze::exam
