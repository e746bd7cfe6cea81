// SPDX-License-Identifier: MIT
// Two oriented boxes in 3D: 15 axes can separate them, of which 9 nearly vanish when edges are nearly parallel.
#include <cmath>
#include <cstdio>
#include <random>

#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Box = graze::Obb<3>;

// The usual test in float: r[j][i] is the dot product of a's axis i and b's axis j.
bool naive(const Box& a, const Box& b) {
  const graze::Mat<3> r = transpose(a.axes) * b.axes;
  const graze::Vec<3> t = transpose(a.axes) * (b.center - a.center);
  const auto reach = [&r](int i, int j) { return std::fabs(r[j][i]); };
  for (int i = 0; i < 3; ++i) {
    float reach_a = a.half_extents[i];
    float reach_b = b.half_extents[i];
    for (int j = 0; j < 3; ++j) reach_a += b.half_extents[j] * reach(i, j);
    for (int j = 0; j < 3; ++j) reach_b += a.half_extents[j] * reach(j, i);
    if (std::fabs(t[i]) > reach_a || std::fabs(dot(t, r[i])) > reach_b) return false;
  }
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {  // the cross product of edge i and edge j
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const float both = a.half_extents[i1] * reach(i2, j) + a.half_extents[i2] * reach(i1, j) +
                         b.half_extents[j1] * reach(i, j2) + b.half_extents[j2] * reach(i, j1);
      if (std::fabs(t[i2] * r[j][i1] - t[i1] * r[j][i2]) > both) return false;
    }
  }
  return true;
}

int main(int argc, char** argv) {
  std::mt19937 random(1);
  const auto number = [&random] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  int naive_apart = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {  // cubes of side 2 that overlap by half a unit, turned by 1e-6 degrees
    const graze::Vec<3, double> axis{1, number(), number()};
    const auto axes = graze::rotation_matrix(axis, 90);
    const auto nearly = axes * graze::rotation_matrix({0, 1, number()}, 1e-6);
    const Box a{{0, 0, 0}, {1, 1, 1}, graze::Mat<3>(axes)};
    const Box b{graze::Vec<3>(axes * graze::Vec<3, double>{1.5, 1.5, number()}), {1, 1, 1}, graze::Mat<3>(nearly)};
    naive_apart += naive(a, b) ? 0 : 1;
    apart += graze::intersects(a, b) ? 0 : 1;
  }
  std::printf("of 2000 overlapping pairs, the usual test finds %d apart, intersects %d\n", naive_apart, apart);

  cookbook::Picture<3> picture("oriented boxes");
  const graze::Mat<3> tilt(graze::rotation_matrix(graze::Vec<3, double>(1, 0, 0), 45));
  picture.add(Box{{0, 0, 1}, {4, 0.7F, 0.7F}, tilt}, "beam");
  picture.add(Box{{0, 0, 2.2F}, {0.5F, 3, 0.5F}, graze::Mat<3>(graze::rotation_matrix({0, 1, 0}, 45))}, "beam across");
  picture.add(Box{{4, 4, 1}, {1, 1, 1}, tilt}, "apart");
  return picture.save(argc, argv);
}
