// SPDX-License-Identifier: MIT
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/ray/corners_in_frame.hpp>

namespace graze::detail::seen_corners_test {
namespace {

using Point = Vec<3, double>;

/// On a small lattice, so that many are equally far, and no product is rounded.
std::vector<Vec<3>> corners_on_lattice(std::mt19937& engine, std::size_t count) {
  std::uniform_int_distribution<int> step(-3, 3);
  std::vector<Vec<3>> corners(count);
  for (Vec<3>& corner : corners) {
    corner = {static_cast<float>(step(engine)), static_cast<float>(step(engine)), static_cast<float>(step(engine))};
  }
  return corners;
}

TEST(CornersInFrame, FarthestIsTheFirstOfTheFarthestForEveryCount) {
  std::mt19937 engine(20261123);
  std::uniform_int_distribution<int> step(-2, 2);
  const Point origin(5, -7, 0.5);
  for (std::size_t count = 1; count <= CornersInFrame::room; ++count) {
    const std::vector<Vec<3>> corners = corners_on_lattice(engine, count);
    const CornersInFrame seen(std::span<const Vec<3>>(corners), origin);
    for (int i = 0; i < 50; ++i) {
      const Point direction(step(engine), step(engine), step(engine));
      Point expected = Point(corners[0]) - origin;
      for (const Vec<3>& corner : corners) {
        const Point candidate = Point(corner) - origin;
        if (dot(candidate, direction) > dot(expected, direction)) expected = candidate;
      }
      EXPECT_EQ(seen.farthest(direction), expected) << count;
    }
  }
}

TEST(CornersInFrame, BoundsHoldAllOfThemAndNoMore) {
  std::mt19937 engine(20261124);
  const Point origin(-0.25, 2, 9);
  for (std::size_t count = 1; count <= CornersInFrame::room; ++count) {
    const std::vector<Vec<3>> corners = corners_on_lattice(engine, count);
    Aabb<3, double> expected{Point(corners[0]) - origin, Point(corners[0]) - origin};
    for (const Vec<3>& corner : corners) expected.grow(Point(corner) - origin);
    const Aabb<3, double> box = CornersInFrame(std::span<const Vec<3>>(corners), origin).bounds();
    EXPECT_EQ(box.min, expected.min) << count;
    EXPECT_EQ(box.max, expected.max) << count;
  }
}

}  // namespace
}  // namespace graze::detail::seen_corners_test
