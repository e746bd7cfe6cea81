// SPDX-License-Identifier: MIT
// The boxes and queries of bench/bvh.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace bench {

using graze::Dim;

template <Dim N>
using Box = graze::Aabb<N, float>;
template <Dim N>
using Point = graze::Vec<N, float>;
template <Dim N>
using Ray = graze::Ray<N, float>;

constexpr std::size_t questions = 100'000;

/// Unit cubes that drift, frame by frame, and the queries on them: regions that meet up to about a hundred boxes, rays
/// from one center to another, and points.
template <Dim N>
struct Trajectory {
  explicit Trajectory(std::size_t count) {
    graze::MovingBoxes<N, float> boxes(graze::World::brownian, count, 1);
    graze::MovingBoxes<N, float> elsewhere(graze::World::brownian, count, 2);
    for (std::vector<Box<N>>& place : places) {
      place.assign(boxes.boxes().begin(), boxes.boxes().end());
      boxes.step();
    }
    for (const Box<N>& box : first()) centers.push_back({box.center(), box.center()});
    for (std::size_t k = 0; k < questions; ++k) {
      const Point<N> from = elsewhere.boxes()[k * 7919 % count].center();
      const Point<N> towards = elsewhere.boxes()[(k * 104'729 + 1) % count].center();
      const std::size_t reach = k % 5 * (N == 2 ? 3 : 1);
      points.push_back(from);
      regions.push_back(Box<N>::from_center(from, Point<N>(static_cast<float>(reach))));
      rays.push_back({from, normalize(towards - from)});
    }
  }

  const std::vector<Box<N>>& first() const { return places.front(); }
  const std::vector<Box<N>>& last() const { return places.back(); }

  std::array<std::vector<Box<N>>, 5> places;
  std::vector<Box<N>> centers;  ///< Of the initial boxes, as boxes without extent.
  std::vector<Point<N>> points;
  std::vector<Box<N>> regions;
  std::vector<Ray<N>> rays;
};

}  // namespace bench
