// SPDX-License-Identifier: MIT
// Segments and rays against boxes and each other: the cases in which the usual formulas divide by zero.
#include <algorithm>
#include <cstdio>

#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;
using Ray = graze::Ray<2>;
using Segment = graze::Segment<2>;

// The slab test: where the ray enters and leaves the box along x and along y; zero times infinity is NaN.
bool naive(const Ray& ray, const graze::Aabb<2>& box) {
  float enter = 0;
  float leave = 1e30F;
  for (int i = 0; i < 2; ++i) {
    const float inverse = 1 / ray.direction[i];
    const float first = (box.min[i] - ray.origin[i]) * inverse;
    const float second = (box.max[i] - ray.origin[i]) * inverse;
    enter = std::max(std::min(first, second), enter);
    leave = std::min(std::max(first, second), leave);
  }
  return enter <= leave;
}

// The ends of each segment are on different sides of the other's line.
bool naive(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& s, const Point& p) { return graze::cross_2d(s.end - s.start, p - s.start); };
  return side(a, b.start) * side(a, b.end) < 0 && side(b, a.start) * side(b, a.end) < 0;
}

void print(const char* what, const auto& a, const auto& b) {
  std::printf("%-34s %s, naively %s\n", what, graze::intersects(a, b) ? "touching" : "apart",
              naive(a, b) ? "touching" : "apart");
}

int main(int argc, char** argv) {
  const graze::Aabb<2> box{{-3, -2}, {3, 2}};
  print("ray along the box's upper side:", Ray{{-6, 2}, {1, 0}}, box);
  print("ray along its lower side:", Ray{{-6, -2}, {1, 0}}, box);
  print("ray along its left side:", Ray{{-3, 5}, {0, -1}}, box);
  print("ray along its right side:", Ray{{3, 5}, {0, -1}}, box);
  print("end of one on the other:", Segment{{0, 0}, {4, 4}}, Segment{{2, 2}, {5, 0}});
  print("two that overlap on one line:", Segment{{0, 0}, {4, 4}}, Segment{{2, 2}, {6, 6}});
  print("two on one line, apart:", Segment{{0, 0}, {1, 1}}, Segment{{2, 2}, {6, 6}});

  cookbook::Picture<2> picture("rays and segments");
  picture.add(box, "box");
  picture.add(Ray{{-6, 2}, {1, 0}}, "along the side");
  picture.add(Ray{{-7, -4}, {5, 1}});
  picture.add(Segment{{-6, 4}, {-3, 7}});
  picture.add(Segment{{-6, 7}, {-3, 4}});
  picture.add(Segment{{-1, 4}, {2, 7}});
  picture.add(Segment{{0.5F, 5.5F}, {3, 4}});
  picture.add(Segment{{5, 4}, {6.5F, 5.5F}}, "on one line, apart");
  picture.add(Segment{{7, 6}, {8, 7}});
  return picture.save(argc, argv);
}
