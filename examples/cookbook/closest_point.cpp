// SPDX-License-Identifier: MIT
// The nearest point of a shape: three formulas, and where their usual versions fail.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <graze/graze.hpp>
#include <graze/query/closest_point.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// A common error: y is clamped between the x coordinates of the corners.
Point naive_on_box(const graze::Aabb<2>& box, const Point& p) {
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.x, box.max.x)};
}

// Does not check that the segment's length is positive.
Point naive_on_segment(const graze::Segment<2>& s, const Point& p) {
  const Point edge = s.end - s.start;
  return s.start + edge * std::clamp(dot(p - s.start, edge) / dot(edge, edge), 0.0F, 1.0F);
}

void print(const char* what, const Point& answer, const Point& naive) {
  std::printf("%s (%g, %g), naively ", what, answer.x, answer.y);
  std::isnan(naive.x) ? std::printf("not a number\n") : std::printf("(%g, %g)\n", naive.x, naive.y);
}

int main(int argc, char** argv) {
  const graze::Aabb<2> box{{-4, -1}, {4, 1}};
  const graze::Circle<> disc{{8, 1}, 2};
  const graze::Segment<2> segment{{-8, -3}, {-6, 3}};
  const graze::Segment<2> spot{{0, -4}, {0, -4}};
  print("box, from (1, 3):     ", graze::closest_point(box, {1, 3}), naive_on_box(box, {1, 3}));
  print("segment of length 0:  ", graze::closest_point(spot, {3, 0}), naive_on_segment(spot, {3, 0}));
  print("box, from inside:     ", graze::closest_point(box, {-2, 0}), naive_on_box(box, {-2, 0}));

  cookbook::Picture<2> picture("closest points");
  picture.draw(box, "box");
  picture.draw(disc, "disc");
  picture.draw(segment, "segment");
  const auto show = [&picture](const auto& shape, const Point& p) {
    const Point closest = graze::closest_point(shape, p);
    picture.connect(p, closest);
    if (closest != p) picture.draw(p);
  };
  for (const Point& p : {Point(1, 3), Point(-5, 2), Point(5, 3), Point(2, -3), Point(-2, 0)}) show(box, p);
  for (const Point& p : {Point(11, 4), Point(8, -3), Point(8.5F, 1.5F)}) show(disc, p);
  for (const Point& p : {Point(-9, 1), Point(-7, 4), Point(-7, -4)}) show(segment, p);
  return picture.save(argc, argv);
}
