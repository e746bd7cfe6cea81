// SPDX-License-Identifier: MIT
// A sphere touches a box if the point of the box closest to its center is within the radius.
#include <cstdio>

#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

// Uses the sphere's bounding box instead.
bool naive(const graze::Circle<>& disc, const graze::Aabb<2>& box) {
  return graze::boxes_overlap(graze::bounds(disc), box);
}

int main(int argc, char** argv) {
  const graze::Aabb<2> box{{-4, -2}, {4, 2}};
  int positions = 0;
  int touching = 0;
  int naive_touching = 0;
  for (int x = -70; x <= 70; ++x) {
    for (int y = -50; y <= 50; ++y) {
      const graze::Circle<> disc{{0.1F * static_cast<float>(x), 0.1F * static_cast<float>(y)}, 2};
      ++positions;
      touching += graze::intersects(disc, box) ? 1 : 0;
      naive_touching += naive(disc, box) ? 1 : 0;
    }
  }
  std::printf("%d positions, %d touch, %d by the box around the disc\n", positions, touching, naive_touching);

  const graze::Circle<> at_edge{{7, 0}, 3};
  const graze::Circle<> at_corner{{7, 6}, 5};
  const graze::Circle<> beyond_corner{{-6, 4}, 2.7F};
  for (const auto& disc : {at_edge, at_corner, beyond_corner}) {
    std::printf("disc at (%g, %g), radius %g: %s, naively %s\n", disc.center.x, disc.center.y, disc.radius,
                graze::name_of(graze::relation(disc, box)).data(), naive(disc, box) ? "touching" : "apart");
  }

  cookbook::Picture<2> picture("discs and a box");
  picture.add(box, "box");
  picture.add(at_edge, "at the edge");
  picture.add(at_corner, "at the corner");
  picture.add(beyond_corner, "beyond the corner");
  picture.draw(graze::bounds(beyond_corner));
  picture.draw(graze::Segment<2>{beyond_corner.center, graze::closest_point(box, beyond_corner.center)});
  return picture.save(argc, argv);
}
