// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/spatial_order.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::spatial_order_test {
namespace {

template <Dim N, class T>
void expect_order(const std::vector<Aabb<N, T>>& boxes, const Executor& executor, std::vector<std::uint32_t>& order) {
  SpatialOrder<N, T> spatial;
  spatial.sort(boxes, executor);
  std::vector<int> seen(boxes.size());
  std::size_t next = 0;
  for (const SpatialRun& run : spatial.runs()) {
    EXPECT_EQ(run.first, next) << "runs follow each other";
    EXPECT_GE(run.count, 1U);
    EXPECT_LE(run.count, longest_run);
    next += run.count;
    for (std::size_t k = run.first; k < next; ++k) {
      const Aabb<N, T>& box = boxes[spatial.order()[k]];
      ++seen[spatial.order()[k]];
      EXPECT_EQ(is_finite(box.min) && is_finite(box.max), run.finite);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) EXPECT_EQ(seen[k], is_nothing(boxes[k]) ? 0 : 1) << "box " << k;
  order.assign(spatial.order(), spatial.order() + next);
}

TEST(SpatialOrder, HasEveryBoxThatContainsSomethingOnceWhoeverRunsIt) {
  for (const std::size_t count : {1U, 3U, 500U, 40'000U}) {
    for (const auto& world : test::box_worlds<3, float>(count, 11)) {
      SCOPED_TRACE(world.name);
      std::vector<std::uint32_t> alone;
      std::vector<std::uint32_t> together;
      expect_order(world.boxes, serial_executor(), alone);
      expect_order(world.boxes, default_executor(), together);
      EXPECT_EQ(alone, together);
    }
    for (const auto& world : test::box_worlds<2, double>(count, 12)) {
      SCOPED_TRACE(world.name);
      std::vector<std::uint32_t> order;
      expect_order(world.boxes, default_executor(), order);
    }
  }
}

TEST(SpatialOrder, KeepsGiantsOutOfTheRunsOfDwarfs) {
  test::Numbers numbers(3);
  std::vector<Aabb<3, float>> boxes;
  for (int k = 0; k < 20'000; ++k) {
    const bool giant = k % 1000 == 0;
    boxes.push_back(Aabb<3, float>::from_center(numbers.point<3, float>(0, 50), Vec<3>(giant ? 20.0F : 0.5F)));
  }
  SpatialOrder<3, float> spatial;
  spatial.sort(boxes, serial_executor());
  for (const SpatialRun& run : spatial.runs()) {
    const auto is_giant = [&](std::uint32_t k) { return k % 1000 == 0; };
    const auto* const first = spatial.order() + run.first;
    const auto giants = static_cast<std::size_t>(std::count_if(first, first + run.count, is_giant));
    EXPECT_TRUE(giants == 0 || giants == run.count) << giants << " giants among " << run.count;
  }
}

TEST(SpatialOrder, RunsOfEvenlySpreadBoxesAreCompact) {
  test::Numbers numbers(4);
  std::vector<Aabb<2, float>> boxes;
  for (int k = 0; k < 50'000; ++k) {
    boxes.push_back(Aabb<2, float>::from_center(numbers.point<2, float>(0, 100), Vec<2>(0.1F)));
  }
  SpatialOrder<2, float> spatial;
  spatial.sort(boxes, serial_executor());
  for (const SpatialRun& run : spatial.runs()) {
    Rect<float> bounds = Rect<float>::nothing();
    for (std::size_t k = run.first; k < run.first + run.count; ++k) bounds.grow(boxes[spatial.order()[k]].center());
    const Vec<2> side = bounds.max - bounds.min;
    // At most three times the area of as many boxes: a run may turn a corner of the curve.
    EXPECT_LT(side.x * side.y, 3 * 100 * 100 * static_cast<float>(run.count) / 50'000);
  }
}

/// The bounds of most boxes are estimated from a few; the others do not suffer and are included.
TEST(SpatialOrder, RunsAreCompactBesideAFewBoxesFarAway) {
  test::Numbers numbers(5);
  std::vector<Aabb<2, float>> boxes;
  for (int k = 0; k < 50'000; ++k) {
    const auto center = k % 10'000 == 7 ? numbers.point<2, float>(-1e30F, 1e30F) : numbers.point<2, float>(0, 100);
    boxes.push_back(Aabb<2, float>::from_center(center, Vec<2>(0.1F)));
  }
  std::vector<std::uint32_t> order;
  expect_order(boxes, default_executor(), order);
  constexpr std::size_t some = 64;
  double area = 0;
  for (std::size_t k = 0; k + some <= order.size(); k += some) {
    Rect<float> bounds = Rect<float>::nothing();
    for (std::size_t i = k; i < k + some; ++i) bounds.grow(boxes[order[i]].center());
    const Vec<2> side = bounds.max - bounds.min;
    if (side.x <= 100 && side.y <= 100) area += static_cast<double>(side.x) * static_cast<double>(side.y);
  }
  // Any sixty-four of them in a cell of about 1,000 would extend over nearly all of it: 200 squares each, not 10,000.
  EXPECT_LT(area / (50'000.0 / some), 600);
}

TEST(SpatialOrder, SaysWhatItNeedsInPassingToo) {
  constexpr std::size_t count = 60'000;
  std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(count, 9).front().boxes;
  SpatialOrder<3, float> spatial;
  spatial.sort(boxes, serial_executor());
  const std::size_t without_crowds = spatial.bytes();
  // If a tenth is scattered far apart, all others are one cluster, whose boxes are copied.
  for (std::size_t k = 0; k < count; k += 10) {
    boxes[k].min *= 10'000.0F;
    boxes[k].max = boxes[k].min + 1.0F;
  }
  spatial.sort(boxes, serial_executor());
  EXPECT_GE(spatial.bytes(), without_crowds + count * 8 / 10 * (sizeof(boxes[0]) + 2 * sizeof(std::uint32_t)));
}

TEST(SpatialOrder, RefusesNaNByPosition) {
  std::vector<Aabb<2, float>> boxes(200'000);
  for (const std::size_t k : {std::size_t{199'999}, std::size_t{69'999}, std::size_t{70'001}}) {
    boxes[k].max.y = std::numeric_limits<float>::quiet_NaN();
  }
  SpatialOrder<2, float> spatial;
  try {
    spatial.sort(boxes, default_executor());
    FAIL() << "NaN was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("box 69999 "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace graze::detail::spatial_order_test
