// SPDX-License-Identifier: MIT
// A sphere against an oriented box: in the box's frame, this is a sphere against an axis-aligned box.
#include <algorithm>
#include <cstdio>

#include <graze/query/closest_point.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// The matrix maps the box's coordinates to the world's; the inverse is its transpose. Here the transpose is forgotten.
bool naive(const graze::Circle<>& disc, const graze::OrientedRect<>& box) {
  const Point local = box.axes * (disc.center - box.center);
  const Point nearest = clamp(local, -box.half_extents, box.half_extents);
  return dot(local - nearest, local - nearest) <= disc.radius * disc.radius;
}

int main(int argc, char** argv) {
  const graze::OrientedRect<> ramp{{0, 0}, {5, 1}, graze::Mat<2>(graze::rotation_matrix(30))};
  const graze::Circle<> above{{-2, 2.5F}, 1};
  const graze::Circle<> on_top{{3.3F, 4}, 1};
  const graze::Circle<> at_end{{6.4F, 2}, 1.5F};
  for (const auto& disc : {above, on_top, at_end}) {
    std::printf("disc at (%g, %g): %s, naively %s\n", disc.center.x, disc.center.y,
                graze::name_of(graze::relation(disc, ramp)).data(), naive(disc, ramp) ? "touching" : "apart");
  }
  int wrong = 0;
  int positions = 0;
  for (int x = -70; x <= 70; ++x) {
    for (int y = -50; y <= 50; ++y) {
      const graze::Circle<> disc{{0.1F * static_cast<float>(x), 0.1F * static_cast<float>(y)}, 1};
      ++positions;
      wrong += naive(disc, ramp) != graze::intersects(disc, ramp) ? 1 : 0;
    }
  }
  std::printf("%d positions, %d wrong with the matrix the wrong way round\n", positions, wrong);

  cookbook::Picture<2> picture("discs and an oriented box");
  picture.add(ramp, "ramp");
  picture.add(above, "above");
  picture.add(on_top, "on top");
  picture.add(at_end, "at the end");
  for (const auto& disc : {above, on_top, at_end}) {
    picture.draw(graze::Segment<2>{disc.center, graze::closest_point(ramp, disc.center)});
  }
  return picture.save(argc, argv);
}
