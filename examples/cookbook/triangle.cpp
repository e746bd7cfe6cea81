// SPDX-License-Identifier: MIT
// A triangle against a sphere, a box and another triangle.
#include <cmath>
#include <cstdio>

#include <graze/query/contains.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Triangle = graze::Triangle<3>;
using Point = graze::Vec<3>;

// "They touch when a corner is in the sphere."
bool naive(const Triangle& triangle, const graze::Sphere<3>& sphere) {
  for (const Point& corner : triangle.vertices()) {
    if (graze::contains(sphere, corner)) return true;
  }
  return false;
}

// The height of a point above the triangle's plane, by the unit normal.
float naive_height(const Triangle& t, const Point& p) {
  return std::fabs(dot(normalize(cross(t.b - t.a, t.c - t.a)), p - t.a));
}

int main(int argc, char** argv) {
  const Triangle sail{{0, -4, 0}, {0, 4, 0}, {0, 0, 6}};
  const graze::Sphere<3> ball{{1, 0, 2}, 1};
  const graze::Aabb<3> crate{{-2, 2, 0}, {0, 4, 1}};
  const Triangle blade{{-2, -1, 1}, {2, -3, 1}, {2, -1, 1}};
  std::printf("sail and ball: %s, by corners %s\n", graze::name_of(graze::relation(sail, ball)).data(),
              naive(sail, ball) ? "they touch" : "apart");
  std::printf("sail and crate: %s; sail and blade: %s\n", graze::name_of(graze::relation(sail, crate)).data(),
              graze::name_of(graze::relation(sail, blade)).data());

  // Two triangles in one plane, and triangles that are a segment or a point.
  const Triangle patch{{0, -6, 6}, {0, 0, 5}, {0, 0, 8}};
  const Triangle needle{{-1, 0, 3}, {1, 0, 3}, {0, 0, 3}};
  const Triangle speck{{0, 0, 3}, {0, 0, 3}, {0, 0, 3}};
  std::printf("sail and patch, in one plane: %s\n", graze::intersects(sail, patch) ? "they touch" : "apart");
  std::printf("sail and needle: %s; sail and speck: %s\n", graze::intersects(sail, needle) ? "they touch" : "apart",
              graze::intersects(sail, speck) ? "they touch" : "apart");
  std::printf("naively, the height over the needle is %s\n",
              std::isnan(naive_height(needle, {0, 0, 4})) ? "not a number" : "a number");

  cookbook::Picture<3> picture("triangles");
  picture.add(sail, "sail");
  picture.add(ball, "ball");
  picture.add(crate, "crate");
  picture.add(blade, "blade");
  picture.draw(Triangle{{3, 3, 0}, {5, 3, 0}, {4, 3, 3}}, "apart");
  return picture.save(argc, argv);
}
