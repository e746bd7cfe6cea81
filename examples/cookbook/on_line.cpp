// SPDX-License-Identifier: MIT
// Whether a point is on a line, a segment, a ray or a plane: sets without thickness, which contain hardly any points
// with float coordinates.
#include <cmath>
#include <cstdio>

#include <graze/query/contains.hpp>

#include "picture.hpp"

using Point = graze::Vec<2>;

// y = slope * x + intercept, compared with ==.
bool naive_on_segment(const graze::Segment<2>& s, const Point& p) {
  const float slope = (s.end.y - s.start.y) / (s.end.x - s.start.x);
  return p.y == slope * p.x + (s.start.y - slope * s.start.x);
}

// Compares the unit vector to the point with the unit direction: their dot product should be 1.
bool naive_on_ray(const graze::Ray<2>& ray, const Point& p) {
  return dot(normalize(p - ray.origin), normalize(ray.direction)) == 1.0F;
}

int main(int argc, char** argv) {
  const graze::Segment<2> segment{{0.1F, 0.2F}, {7.3F, 3.1F}};
  int naive = 0;
  int ours = 0;
  for (int i = 0; i <= 100; ++i) {
    const Point p = segment.start + (segment.end - segment.start) * (static_cast<float>(i) / 100);
    naive += naive_on_segment(segment, p) ? 1 : 0;
    ours += graze::contains(segment, p) ? 1 : 0;
  }
  std::printf("of 101 points calculated on a segment, contains finds %d, == finds %d\n", ours, naive);
  const graze::Segment<2> upright{{2, 0}, {2, 5}};
  std::printf("the middle of an upright segment: contains %d, == %d\n", graze::contains(upright, Point(2, 3)) ? 1 : 0,
              naive_on_segment(upright, {2, 3}) ? 1 : 0);

  const graze::Ray<2> ray{{0, 0}, {1, 0}};
  for (const float off : {0.3F, 0.2F, 0.1F, 0.0001F, 0.0F}) {
    std::printf("%g beside a ray, 1000 along it: contains %d, dot product %d\n", off,
                graze::contains(ray, Point(1000, off)) ? 1 : 0, naive_on_ray(ray, {1000, off}) ? 1 : 0);
  }
  std::printf("the ray's origin: contains %d, dot product %d\n", graze::contains(ray, Point(0, 0)) ? 1 : 0,
              naive_on_ray(ray, {0, 0}) ? 1 : 0);

  cookbook::Picture<2> picture("points on a segment, as == sees them");
  picture.draw(segment, "segment");
  for (int i = 0; i <= 100; i += 4) {
    const Point p = segment.start + (segment.end - segment.start) * (static_cast<float>(i) / 100);
    naive_on_segment(segment, p) ? picture.connect(p, p) : picture.draw(p);
  }
  return picture.save(argc, argv);
}
