// SPDX-License-Identifier: MIT
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>

int main() {
  const graze::AnyShape<3> ball = graze::Sphere<3>{{0, 0, 0}, 1};
  const graze::AnyShape<3> box = graze::Aabb<3>{{0.5F, -1, -1}, {2, 1, 1}};
  const graze::AnyShape<3> far = graze::Sphere<3>{{9, 0, 0}, 1};
  const graze::Vec<3> way{9, 0, 0};
  const bool is_right = graze::contact(ball, box)->depth == 0.5F && graze::manifold(ball, box).size == 1 &&
                        graze::distance(ball, far) == 7 && graze::shape_cast(ball, way, far).has_value() &&
                        graze::time_of_impact(ball, {.linear = way}, far, {}).has_value() &&
                        graze::ray_cast(ball, graze::Ray<3>{{-9, 0, 0}, {1, 0, 0}})->t == 8;
  return is_right ? 0 : 1;
}
