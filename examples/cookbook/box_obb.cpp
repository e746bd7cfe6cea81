// SPDX-License-Identifier: MIT
// An axis-aligned box against an oriented one: they are apart when an axis separates them.
#include <cmath>
#include <cstdio>

#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Box = graze::Aabb<2>;
using Tilted = graze::OrientedRect<>;

// Uses the oriented box's bounding box instead.
bool by_bounds(const Box& box, const Tilted& tilted) { return graze::boxes_overlap(box, graze::bounds(tilted)); }

int main(int argc, char** argv) {
  const Box crate{{-2, -2}, {2, 2}};
  const graze::Mat<2> turn(graze::rotation_matrix(45));
  const Tilted near{{4, 4}, {3, 1}, turn * graze::Mat<2>(graze::rotation_matrix(90))};
  const Tilted leaning{{-3, 2}, {3, 1}, turn};
  std::printf("near: %s, its bounds: %s\n", graze::name_of(graze::relation(crate, near)).data(),
              by_bounds(crate, near) ? "touching" : "apart");
  std::printf("leaning: %s\n", graze::name_of(graze::relation(crate, leaning)).data());

  int touching = 0;
  int by_box = 0;
  for (int x = -80; x <= 80; ++x) {
    for (int y = -80; y <= 80; ++y) {
      const Tilted plank{{0.1F * static_cast<float>(x), 0.1F * static_cast<float>(y)}, {4, 0.5F}, turn};
      touching += graze::intersects(crate, plank) ? 1 : 0;
      by_box += by_bounds(crate, plank) ? 1 : 0;
    }
  }
  std::printf("a plank touches at %d positions, its bounds at %d\n", touching, by_box);

  // The gap along an axis of the oriented box: the distance of the centers minus the extents of both boxes.
  const graze::Vec<2> axis = near.axes[1];
  const float reach = std::fabs(axis.x) * 2 + std::fabs(axis.y) * 2 + near.half_extents.y;
  std::printf("gap along the second axis of near: %.3f\n", std::fabs(dot(near.center, axis)) - reach);

  cookbook::Picture<2> picture("a box and oriented boxes");
  picture.add(crate, "crate");
  picture.add(near, "near");
  picture.add(leaning, "leaning");
  picture.draw(graze::bounds(near), "bounds of near");
  picture.draw(graze::Plane<2>{{1, 1}, 5.2F});
  return picture.save(argc, argv);
}
