// SPDX-License-Identifier: MIT
// Whether a point is in a solid: the surface belongs to the solid.
#include <cstdio>

#include <graze/query/contains.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// The usual test of a sphere: it excludes the surface and calculates in float.
bool naive_in_disc(const graze::Circle<>& disc, const Point& p) {
  return dot(p - disc.center, p - disc.center) < disc.radius * disc.radius;
}

int main(int argc, char** argv) {
  const graze::Circle<> disc{{0, 0}, 5};
  int on_rim = 0;
  int naive = 0;
  int ours = 0;
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      if (x * x + y * y != 25) continue;
      ++on_rim;
      naive += naive_in_disc(disc, Point(x, y)) ? 1 : 0;
      ours += graze::contains(disc, Point(x, y)) ? 1 : 0;
    }
  }
  std::printf("%d points with whole coordinates on the rim: contains %d, naively %d\n", on_rim, ours, naive);

  const graze::Circle<> spot{{3, 4}, 0};
  std::printf("a disc of radius 0 contains its center: %d, naively %d\n", graze::contains(spot, Point(3, 4)) ? 1 : 0,
              naive_in_disc(spot, {3, 4}) ? 1 : 0);
  // Squares of 1e20 overflow to infinity in float, and infinity is not less than infinity.
  const graze::Circle<> galaxy{{0, 0}, 1e20F};
  std::printf("a disc of radius 1e20 contains its center's neighbour at 5e19: %d, naively %d\n",
              graze::contains(galaxy, Point(5e19F, 0)) ? 1 : 0, naive_in_disc(galaxy, {5e19F, 0}) ? 1 : 0);

  cookbook::Picture<2> picture("which points of a grid are contained");
  const graze::Mat<2> turn(graze::rotation_matrix(30));
  const graze::AnyShape<2> shapes[] = {
      disc, graze::Aabb<2>{{7, -5}, {12, 0}}, graze::OrientedRect<>{{10, 4.5F}, {3, 2}, turn},
      graze::Triangle<2>{{14, -5}, {21, -5}, {17, 6}}, graze::Capsule<2>{{-12, -4}, {-8, 4}, 2}};
  for (const auto& shape : shapes) picture.draw(shape);
  for (int x = -14; x <= 21; ++x) {
    for (int y = -6; y <= 7; ++y) {
      const Point p(x, y);
      bool held = false;
      for (const auto& shape : shapes) held = held || graze::contains(shape, p);
      held ? picture.connect(p, p) : picture.draw(p);
    }
  }
  return picture.save(argc, argv);
}
