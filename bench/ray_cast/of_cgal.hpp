// SPDX-License-Identifier: MIT
// CGAL's do_intersect of a ray or, if the shape is unbounded, its segment up to t_max, with the kernel that calculates
// in plain floats or doubles. It tells whether there is a hit, not where.
#pragma once

#include <type_traits>
#include <utility>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

template <class T>
using CgalKernel = CGAL::Simple_cartesian<T>;

template <class T>
auto cgal(const Vec<2, T>& v) {
  return typename CgalKernel<T>::Point_2(v.x, v.y);
}
template <class T>
auto cgal(const Vec<3, T>& v) {
  return typename CgalKernel<T>::Point_3(v.x, v.y, v.z);
}
template <class T>
auto cgal(const Segment<2, T>& segment) {
  return typename CgalKernel<T>::Segment_2(cgal(segment.start), cgal(segment.end));
}
template <class T>
auto cgal(const Segment<3, T>& segment) {
  return typename CgalKernel<T>::Segment_3(cgal(segment.start), cgal(segment.end));
}
template <class T>
auto cgal(const Sphere<3, T>& sphere) {
  return typename CgalKernel<T>::Sphere_3(cgal(sphere.center), sphere.radius * sphere.radius);
}
template <class T>
auto cgal(const Aabb<2, T>& box) {
  return typename CgalKernel<T>::Iso_rectangle_2(cgal(box.min), cgal(box.max));
}
/// Its box of doubles, as used in its trees.
template <class T>
auto cgal(const Aabb<3, T>& box) {
  return CGAL::Bbox_3(box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
}
template <class T>
auto cgal(const Triangle<2, T>& triangle) {
  return typename CgalKernel<T>::Triangle_2(cgal(triangle.a), cgal(triangle.b), cgal(triangle.c));
}
template <class T>
auto cgal(const Triangle<3, T>& triangle) {
  return typename CgalKernel<T>::Triangle_3(cgal(triangle.a), cgal(triangle.b), cgal(triangle.c));
}
template <class T>
auto cgal(const Plane<3, T>& plane) {
  return typename CgalKernel<T>::Plane_3(plane.normal.x, plane.normal.y, plane.normal.z, -plane.offset);
}

/// The query passed to CGAL.
template <class S>
auto cgal_path(const Case<S>& asked) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const Vec<N, T>& origin = asked.ray.origin;
  if constexpr (std::is_same_v<S, Plane<N, T>>) {
    return cgal(Segment<N, T>{origin, origin + asked.ray.direction * static_cast<T>(t_max)});
  } else if constexpr (N == 2) {
    return typename CgalKernel<T>::Ray_2(cgal(origin), cgal(origin + asked.ray.direction));
  } else {
    return typename CgalKernel<T>::Ray_3(cgal(origin), cgal(origin + asked.ray.direction));
  }
}

template <class S>
class CgalTest {
 public:
  static constexpr const char* name = "CGAL do_intersect";
  static constexpr double tolerance = std::is_same_v<scalar_of<S>, float> ? 1e-5 : 1e-13;

  explicit CgalTest(const Case<S>& asked) : shape_(cgal(asked.shape)), path_(cgal_path(asked)) {}

  bool cast() const { return CGAL::do_intersect(path_, shape_); }

 private:
  decltype(cgal(std::declval<S>())) shape_;
  decltype(cgal_path(std::declval<Case<S>>())) path_;
};

}  // namespace graze::ray_bench
