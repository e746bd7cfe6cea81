// SPDX-License-Identifier: MIT
// Every primitive, its default value, and the helpers that create one from points.
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/sphere.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

void print(const char* what, const Point& v) { std::printf("%s (%g, %g, %g)\n", what, v.x, v.y, v.z); }

int main(int argc, char** argv) {
  const graze::Segment<3> segment{{0, 0, 0}, {2, 3, 6}};
  std::printf("length %g, squared %g\n", length(segment), length_squared(segment));

  const graze::Aabb<3> box = graze::Aabb<3>::from_center({-4, 0, 1}, {1, 2, 1});
  print("box.min", box.min);
  print("box.max", box.max);
  print("from swapped corners, min", graze::Aabb<3>::from_corners({5, 0, 9}, {1, 2, 3}).min);

  const graze::Ray<3> ray = graze::ray_between(Point(4, -5, 0), Point(4, -5, 2));
  print("ray.direction", ray.direction);
  const graze::Triangle<3> triangle{{7, 0, 0}, {7, 3, 0}, {7, 0, 4}};
  const graze::Plane<3> plane = graze::plane_through(triangle.a, triangle.b, triangle.c);
  print("plane.normal", plane.normal);
  std::printf("plane.offset %g\n", plane.offset);

  try {
    graze::ray_between(Point(1, 1, 1), Point(1, 1, 1));
  } catch (const std::invalid_argument& error) {
    std::printf("%s\n", error.what());
  }
  try {
    graze::plane_through(Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2));
  } catch (const std::invalid_argument& error) {
    std::printf("%s\n", error.what());
  }
  std::printf("a sphere of radius -1 %s\n", graze::defect(graze::Sphere<3>{{0, 0, 0}, -1}).data());
  const float zero = length(Point(1, 1, 1) - Point(1, 1, 1));
  std::printf("naively, a direction of length 0 made unit: %s\n",
              std::isnan(zero / zero) ? "not a number" : "a number");

  cookbook::Picture<3> picture("primitives");
  picture.draw(segment, "segment");
  picture.draw(box, "box");
  picture.draw(ray, "ray");
  picture.draw(triangle, "triangle");
  picture.draw(graze::Sphere<3>{{-1, -4, 1}, 1}, "sphere");
  picture.draw(graze::Obb<3>{{4, 0, 1}, {1, 2, 1}, graze::Mat<3>(graze::rotation_matrix({0, 0, 1}, 30))},
               "oriented box");
  picture.draw(graze::Capsule<3>{{-4, 5, 1}, {0, 5, 1}, 1}, "capsule");
  picture.draw(graze::Plane<3>{{0, 0, 1}, 0}, "plane");
  picture.draw(Point(1, -1, 0), "point");
  return picture.save(argc, argv);
}
