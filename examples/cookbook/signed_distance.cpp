// SPDX-License-Identifier: MIT
// How far a point is from a surface: positive outside, negative inside, in units of length.
#include <cmath>
#include <cstdio>

#include <graze/query/signed_distance.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// Takes the value of the line's equation for a distance.
float naive_distance(const graze::Plane<2>& plane, const Point& p) { return dot(plane.normal, p) - plane.offset; }

int main(int argc, char** argv) {
  const graze::Plane<2> line = graze::plane_through(Point(-10, -4), Point(-2, 2));
  std::printf("line, (-5, 6): %g, naively %g\n", graze::signed_distance(line, Point(-5, 6)),
              naive_distance(line, {-5, 6}));
  std::printf("line, (-5, -4): %g, naively %g\n", graze::signed_distance(line, Point(-5, -4)),
              naive_distance(line, {-5, -4}));

  const graze::Aabb<2> box{{1, -4}, {7, 0}};
  const graze::Circle<> disc{{12, 1}, 3};
  std::printf("box, (2, 2): %g; (4, -3): %g; on the edge: %g\n", graze::signed_distance(box, Point(2, 2)),
              graze::signed_distance(box, Point(4, -3)), graze::signed_distance(box, Point(7, -2)));
  std::printf("disc, (12, 6): %g; center: %g\n", graze::signed_distance(disc, Point(12, 6)),
              graze::signed_distance(disc, disc.center));

  // A disc with this distance as radius just touches the surface.
  cookbook::Picture<2> picture("discs of the size of the distance");
  picture.draw(line, "line");
  picture.draw(box, "box");
  picture.draw(disc, "disc");
  graze::Layer group = 0;
  const auto show = [&](const auto& shape, const Point& p) {
    picture.add(graze::Circle<>{p, std::fabs(graze::signed_distance(shape, p))}, "", ++group);
    picture.add(p, "", group);
  };
  for (const Point& p : {Point(-5, 6), Point(-8, 0), Point(-5, -4)}) show(line, p);
  for (const Point& p : {Point(2, 2), Point(4, -2.5F), Point(8, -5)}) show(box, p);
  for (const Point& p : {Point(12, 6), Point(13, 0.5F), Point(16, -2)}) show(disc, p);
  return picture.save(argc, argv);
}
