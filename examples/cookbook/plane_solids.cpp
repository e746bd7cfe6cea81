// SPDX-License-Identifier: MIT
// A plane against a sphere, a box and an oriented box: how far the solid reaches along the normal.
#include <cmath>
#include <cstdio>

#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

// Takes the value of the plane's equation for a distance.
bool naive(const graze::Plane<3>& plane, const graze::Sphere<3>& sphere) {
  return std::fabs(dot(plane.normal, sphere.center) - plane.offset) <= sphere.radius;
}

// Uses the sphere through the box's corners instead of the box.
bool naive(const graze::Plane<3>& plane, const graze::Aabb<3>& box) {
  return naive(plane, graze::Sphere<3>{box.center(), length(box.half_extents())});
}

int main(int argc, char** argv) {
  // A small triangle in the floor; the normal's length is twice its area.
  const graze::Plane<3> floor = graze::plane_through(Point(0, 0, 0), Point(0.5F, 0, 0), Point(0, 0.5F, 0));
  const graze::Sphere<3> ball{{-4, 0, 2}, 1};
  const graze::Sphere<3> lying{{-4, 4, 1}, 1};
  const graze::Aabb<3> slab{{-1.5F, -2, 1}, {1.5F, 2, 1.2F}};
  const graze::Obb<3> edge{{4, 3, std::sqrt(2.0F)}, {1, 1, 1}, graze::Mat<3>(graze::rotation_matrix({1, 0, 0}, 45))};
  const graze::Obb<3> sunk{{4, -1, 0.5F}, {1, 1, 1}, graze::Mat<3>(graze::rotation_matrix({0, 0, 1}, 30))};
  const auto say = [](bool yes) { return yes ? "touching" : "apart"; };
  std::printf("normal of length %g\n", length(floor.normal));
  std::printf("ball, 1 above the floor: %s, naively %s\n", graze::name_of(graze::relation(floor, ball)).data(),
              say(naive(floor, ball)));
  std::printf("ball lying on the floor: %s, naively %s\n", graze::name_of(graze::relation(floor, lying)).data(),
              say(naive(floor, lying)));
  std::printf("slab, 1 above the floor: %s, naively %s\n", graze::name_of(graze::relation(floor, slab)).data(),
              say(naive(graze::Plane<3>{{0, 0, 1}, 0}, slab)));
  std::printf("box on its edge: %s; sunk box: %s\n", graze::name_of(graze::relation(floor, edge)).data(),
              graze::name_of(graze::relation(floor, sunk)).data());

  // The plane is only a surface. The solid below it is a half-space.
  const graze::HalfSpace<3> ground{floor.normal, floor.offset};
  const graze::Sphere<3> buried{{0, 0, -5}, 1};
  std::printf("buried ball: floor %s, ground %s\n", say(graze::intersects(floor, buried)),
              say(graze::intersects(ground, buried)));

  cookbook::Picture<3> picture("a plane and solids");
  picture.add(floor, "floor");
  picture.add(ball, "ball above");
  picture.add(lying, "ball lying");
  picture.add(slab, "slab above");
  picture.add(edge, "on its edge");
  picture.add(sunk, "sunk box");
  return picture.save(argc, argv);
}
