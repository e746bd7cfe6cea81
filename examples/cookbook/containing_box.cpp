// SPDX-License-Identifier: MIT
// The bounding box of points, and two common ways to lose some of them.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include <graze/query/bounding.hpp>
#include <graze/query/contains.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// Starts the search for the largest coordinate at "the smallest float".
Point naive_max(const std::vector<Point>& points) {
  Point max(std::numeric_limits<float>::min());
  for (const Point& point : points) max = {std::max(max.x, point.x), std::max(max.y, point.y)};
  return max;
}

int main(int argc, char** argv) {
  const std::vector<Point> points{{-7, -5}, {-6, -1}, {-4, -3}, {-3, -6}, {-2, -2}, {-1, -4}};
  const graze::Aabb<2> box = graze::bounding_box(points);
  const Point wrong = naive_max(points);
  std::printf("box from (%g, %g) to (%g, %g)\n", box.min.x, box.min.y, box.max.x, box.max.y);
  std::printf("naive max: (%.3g, %.3g)\n", wrong.x, wrong.y);

  // A rectangle stored as a corner and a size: does it still contain the opposite corner?
  std::mt19937 random(1);
  int lost = 0;
  int kept = 0;
  for (int i = 0; i < 1000; ++i) {
    const float a = -static_cast<float>(random() % 1000) / 1000;
    const float b = static_cast<float>(random() % 1000) / 7;
    const float size = b - a;
    lost += a + size < b ? 1 : 0;
    kept += graze::contains(graze::bounding_box(std::vector<Point>{{a, a}, {b, b}}), Point(b)) ? 1 : 0;
  }
  std::printf("corner and size lose the far corner %d times of 1000, min and max %d times\n", lost, 1000 - kept);

  cookbook::Picture<2> picture("a box around points");
  picture.draw(box, "bounding_box");
  picture.draw(graze::Aabb<2>{box.min, wrong}, "max sought from the smallest positive float");
  for (const Point& point : points) picture.connect(point, point);
  return picture.save(argc, argv);
}
