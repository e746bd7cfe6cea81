// SPDX-License-Identifier: MIT
// A circle around points: the smallest, a fast approximation, and the usual one from the centroid.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include <graze/query/bounding.hpp>
#include <graze/query/contains.hpp>

#include "picture.hpp"

using Points = std::vector<graze::Vec<2>>;

// The usual method: the centroid, and the distance to the point farthest from it.
graze::Circle<> naive_circle(const Points& points) {
  graze::Vec<2> sum(0);
  for (const auto& point : points) sum += point;
  graze::Circle<> circle{sum / static_cast<float>(points.size()), 0};
  for (const auto& point : points) circle.radius = std::fmax(circle.radius, length(point - circle.center));
  return circle;
}

bool holds_all(const graze::Circle<>& circle, const Points& points) {
  for (const auto& point : points) {
    if (!graze::contains(circle, point)) return false;
  }
  return true;
}

int main(int argc, char** argv) {
  const Points points{{0, 0}, {1, 1}, {1, -1}, {0.5F, 0.5F}, {0, 1}, {0, -1}, {1, 0}, {0.5F, -0.5F}, {10, 0}};
  const auto smallest = graze::bounding_sphere(points);
  const auto fast = graze::bounding_sphere_fast(points);
  const auto naive = naive_circle(points);
  std::printf("radius: smallest %.4f, fast %.4f, from the centroid %.4f\n", smallest.radius, fast.radius, naive.radius);

  // A thousand sets of three points: does the circle contain the points that it was made from?
  std::mt19937 random(1);
  const auto coordinate = [&random] { return static_cast<float>(random() % 1000) / 10; };
  int naive_losses = 0;
  int losses = 0;
  for (int i = 0; i < 1000; ++i) {
    Points three(3);
    for (auto& point : three) point = {coordinate(), coordinate()};
    naive_losses += holds_all(naive_circle(three), three) ? 0 : 1;
    losses += holds_all(graze::bounding_sphere(three), three) ? 0 : 1;
  }
  std::printf("circles that leave out a point: smallest %d, from the centroid %d of 1000\n", losses, naive_losses);

  cookbook::Picture<2> picture("a circle around points");
  picture.draw(naive, "from the centroid");
  picture.draw(smallest, "smallest");
  for (const auto& point : points) picture.connect(point, point);
  return picture.save(argc, argv);
}
