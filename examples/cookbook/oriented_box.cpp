// SPDX-License-Identifier: MIT
// The oriented box of minimum area around points, and the usual one along their principal axes.
#include <cmath>
#include <cstdio>
#include <vector>

#include <graze/query/bounding.hpp>

#include "picture.hpp"

using Points = std::vector<graze::Vec<2>>;

// The usual method: the eigenvectors of the covariance matrix are the axes.
graze::OrientedRect<> naive_box(const Points& points) {
  graze::Vec<2> mean(0);
  for (const auto& point : points) mean += point / static_cast<float>(points.size());
  float xx = 0;
  float xy = 0;
  float yy = 0;
  for (const auto& point : points) {
    const graze::Vec<2> off = point - mean;
    xx += off.x * off.x;
    xy += off.x * off.y;
    yy += off.y * off.y;
  }
  const float angle = std::atan2(2 * xy, xx - yy) / 2;
  const graze::Vec<2> along(std::cos(angle), std::sin(angle));
  const graze::Vec<2> across = graze::perpendicular(along);
  graze::Aabb<2> extent = graze::Aabb<2>::nothing();
  for (const auto& point : points) extent.grow(graze::Vec<2>(dot(point, along), dot(point, across)));
  const graze::Mat<2> axes(along, across);
  return {axes * extent.center(), extent.half_extents(), axes};
}

float area(const graze::Vec<2>& half_extents) { return 4 * half_extents.x * half_extents.y; }

int main(int argc, char** argv) {
  Points points{{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  for (int i = 1; i < 40; ++i) points.emplace_back(0.15F * static_cast<float>(i), 0.1F * static_cast<float>(i));
  for (auto& point : points) point = {0.8F * point.x - 0.6F * point.y, 0.6F * point.x + 0.8F * point.y};

  const graze::OrientedRect<> best = graze::bounding_obb(points);
  const graze::OrientedRect<> naive = naive_box(points);
  std::printf("area along the coordinates:    %.2f\n", area(graze::bounding_box(points).half_extents()));
  std::printf("area along the principal axes: %.2f\n", area(naive.half_extents));
  std::printf("least area:                    %.2f\n", area(best.half_extents));

  cookbook::Picture<2> picture("an oriented box around points");
  picture.draw(naive, "along the principal axes");
  picture.draw(best, "bounding_obb");
  for (const auto& point : points) picture.connect(point, point);
  return picture.save(argc, argv);
}
