// SPDX-License-Identifier: MIT
// Two axis-aligned boxes share a point when their extents overlap along every axis.
#include <array>
#include <cstdio>
#include <utility>

#include <graze/query/contains.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Box = graze::Aabb<2>;
using Point = graze::Vec<2>;

bool has_corner_in(const Box& a, const Box& b) {
  for (const Point& corner : {a.min, a.max, Point(a.min.x, a.max.y), Point(a.max.x, a.min.y)}) {
    if (graze::contains(b, corner)) return true;
  }
  return false;
}

// "Boxes overlap when a corner of one is in the other."
bool naive(const Box& a, const Box& b) { return has_corner_in(a, b) || has_corner_in(b, a); }

int main(int argc, char** argv) {
  const Box floor{{-6, -1}, {6, 1}};
  const Box pillar{{-1, -5}, {1, 5}};
  const Box step{{6, 1}, {9, 4}};
  const Box crate{{-5, 1.5F}, {-3, 3.5F}};
  const std::array<std::pair<const char*, Box>, 3> others{{{"pillar", pillar}, {"step", step}, {"crate", crate}}};
  for (const auto& [name, box] : others) {
    std::printf("floor and %s: %s, by corners %s\n", name, graze::name_of(graze::relation(floor, box)).data(),
                naive(floor, box) ? "they touch" : "apart");
  }
  // Every position of a plank of 10 by 1 and a plank of 1 by 10, on a grid.
  int touching = 0;
  int missed = 0;
  for (int x = -12; x <= 12; ++x) {
    for (int y = -12; y <= 12; ++y) {
      const Point place(x, y);
      const Box lying = Box::from_center({0, 0}, {5, 0.5F});
      const Box standing = Box::from_center(place, {0.5F, 5});
      touching += graze::intersects(lying, standing) ? 1 : 0;
      missed += graze::intersects(lying, standing) && !naive(lying, standing) ? 1 : 0;
    }
  }
  std::printf("planks crosswise: %d positions touch, corners miss %d of them\n", touching, missed);

  cookbook::Picture<2> picture("boxes");
  picture.add(floor, "floor");
  picture.add(crate, "crate");
  for (const auto& [name, box] : others) {
    if (box != crate) picture.add(box, name);
  }
  return picture.save(argc, argv);
}
