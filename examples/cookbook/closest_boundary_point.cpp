// SPDX-License-Identifier: MIT
// The nearest point of a surface, from outside and from inside: where to push an object that has entered.
#include <cmath>
#include <cstdio>

#include <graze/query/closest_boundary_point.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// From the center to the point, as far as the radius.
Point naive_on_circle(const graze::Circle<>& disc, const Point& p) {
  const Point to_point = p - disc.center;
  return disc.center + to_point * (disc.radius / length(to_point));
}

int main(int argc, char** argv) {
  const graze::Circle<> disc{{-8, 0}, 4};
  const graze::Aabb<2> box{{-2, -4}, {6, 4}};
  const graze::Triangle<2> ramp{{8, -4}, {18, -4}, {18, 4}};

  const Point at_center = graze::closest_boundary_point(disc, disc.center);
  const Point naive = naive_on_circle(disc, disc.center);
  std::printf("disc, from its center: (%g, %g), naively %s\n", at_center.x, at_center.y,
              std::isnan(naive.x) ? "not a number" : "a number");
  const Point in_box = graze::closest_boundary_point(box, Point(5, 1));
  std::printf("box, from (5, 1) inside: (%g, %g)\n", in_box.x, in_box.y);
  const Point middle = graze::closest_boundary_point(box, Point(2, 0));
  std::printf("box, from its center, four faces as near: (%g, %g)\n", middle.x, middle.y);
  const Point in_ramp = graze::closest_boundary_point(ramp, Point(14, -1));
  std::printf("ramp, from (14, -1) inside: (%g, %g)\n", in_ramp.x, in_ramp.y);

  cookbook::Picture<2> picture("closest points of the surface");
  picture.draw(disc, "disc");
  picture.draw(box, "box");
  picture.draw(ramp, "ramp");
  const auto show = [&picture](const auto& shape, const Point& p) {
    picture.connect(p, graze::closest_boundary_point(shape, p));
    picture.draw(p);
  };
  for (const Point& p : {Point(-8, 0), Point(-10, 1), Point(-7, -2), Point(-5, 5)}) show(disc, p);
  for (const Point& p : {Point(5, 1), Point(2, 3), Point(0, -1), Point(3, -2.5F), Point(4, 6)}) show(box, p);
  for (const Point& p : {Point(14, -1), Point(16, -3), Point(17, 1), Point(9, 1)}) show(ramp, p);
  return picture.save(argc, argv);
}
