// SPDX-License-Identifier: MIT
// Calls every public query, for every pair of shapes, so that a compiler that only checks syntax (-fsyntax-only)
// instantiates each template as for a user. Not run: the queries' own tests check answers.
#include <vector>

#include <graze/query/bounding.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/outline.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/convex_mesh.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/pick.hpp>
#include <graze/shape/posed.hpp>

namespace {

using namespace graze;

/// Of two shapes of any kind.
template <class A, class B>
void ask_pair(const A& a, const B& b) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  (void)relation(a, b);
  (void)intersects(a, b);
  (void)distance(a, b);
  (void)closest_points(a, b);
  (void)contact(a, b);
  (void)separation(a, b);
  (void)manifold(a, b);
  (void)shape_cast(a, Vec<N, T>(T(1)), b);
  (void)time_of_impact(a, Motion<N, T>{}, b, Motion<N, T>{});
}

/// Of one shape of any kind.
template <Dim N, class T>
void ask_one(const AnyShape<N, T>& shape) {
  const Vec<N, T> point(T(1));
  (void)bounds(shape);
  (void)touching_bounds(shape);
  (void)contains(shape, point);
  (void)closest_point(shape, point);
  (void)closest_boundary_point(shape, point);
  (void)signed_distance(shape, point);
  (void)ray_cast(shape, Ray<N, T>{});
  (void)ray_cast(shape, Segment<N, T>{});
  (void)mass_properties(shape);
  (void)transformed(shape, Pose<N, T>{});
  (void)translated(shape, point);
  (void)compound_of<N, T>({shape, shape});
}

template <Dim N, class T>
void ask_points(const std::vector<Vec<N, T>>& points) {
  (void)bounding_box(points);
  (void)bounding_obb(points);
  (void)bounding_sphere(points);
  (void)bounding_sphere_fast(points);
  const Polytope<N, T> hull = convex_hull(points);
  (void)outline(hull, View<N>{});
  (void)gjk(hull, Posed<Polytope<N, T>>{hull});
  if constexpr (N == 2) {
    (void)convex_parts(points);
  } else {
    (void)convex_mesh(points);
  }
}

template <Dim N, class T>
void ask_all(const AnyShape<N, T>& shape) {
  ask_one(shape);
  ask_pair(shape, shape);
  ask_points(std::vector<Vec<N, T>>(4));
}

}  // namespace

int main() {
  ask_all<2, float>({});
  ask_all<2, double>({});
  ask_all<3, float>({});
  ask_all<3, double>({});
}
