// SPDX-License-Identifier: MIT
// The world in which the indexes of bench/bvh.cpp race.
#pragma once

#include <cstddef>
#include <vector>

#include <graze/broad/worlds.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace bench {

using Box = graze::Aabb<3, float>;
using Point = graze::Vec<3, float>;
using Ray = graze::Ray<3, float>;

constexpr std::size_t questions = 100'000;

/// Two frames of a world that end as they began, so that everything can move to and fro, and what is asked of it.
struct Course {
  explicit Course(std::size_t count) {
    graze::MovingBoxes<3, float> boxes(graze::World::brownian, count, 1);
    first.assign(boxes.boxes().begin(), boxes.boxes().end());
    graze::MovingBoxes<3, float> elsewhere(graze::World::brownian, count, 2);
    boxes.step();
    second.assign(boxes.boxes().begin(), boxes.boxes().end());
    for (std::size_t k = 0; k < questions; ++k) {
      const Point from = elsewhere.boxes()[k * 7919 % count].center();
      const Point towards = elsewhere.boxes()[(k * 104'729 + 1) % count].center();
      points.push_back(from);
      regions.push_back(Box::from_center(from, Point(static_cast<float>(k % 5))));
      rays.push_back({from, normalize(towards - from)});
    }
  }

  const std::vector<Box>& at(std::size_t frame) const { return frame % 2 == 0 ? first : second; }

  std::vector<Box> first;
  std::vector<Box> second;
  std::vector<Point> points;
  std::vector<Box> regions;
  std::vector<Ray> rays;
};

}  // namespace bench
