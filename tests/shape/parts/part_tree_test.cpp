// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/part_tree.hpp>

#include "catalogue.hpp"

namespace graze::test::part_tree_test {
namespace {

template <class SpaceType>
class PartTreeIn : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Box = Aabb<N, T>;
  using Tree = detail::PartTree<N, T>;

  /// Boxes that overlap another, from left to right.
  struct OverlapByKey {
    double key(const Box& box) const {
      return boxes_overlap(box, wanted) ? static_cast<double>(box.min[0]) : std::numeric_limits<double>::quiet_NaN();
    }
    bool admits(double key) const { return !std::isnan(key); }
    bool operator()(const Box& box) const { return admits(key(box)); }

    Box wanted;
  };

  /// Distances from a point below the least of the boxes visited so far.
  struct NearestByKey {
    double key(const Box& box) const {
      ++tests;
      const Vec<N, T> off = clamp(point, box.min, box.max) - point;
      return static_cast<double>(dot(off, off));
    }
    bool admits(double key) const { return key < least; }
    bool operator()(const Box& box) const { return admits(key(box)); }

    Vec<N, T> point;
    double least = std::numeric_limits<double>::infinity();
    mutable int tests = 0;
  };

  /// Boxes with whole coordinates, many of them equal; some are infinite or empty.
  static std::vector<Box> draw_boxes(std::size_t count, std::mt19937& random) {
    std::vector<Box> result;
    while (result.size() < count) {
      Vec<N, T> center;
      for (Dim i = 0; i < N; ++i) center[i] = static_cast<T>(random() % 40);
      Box box = Box::from_center(center, Vec<N, T>(static_cast<T>(random() % 3)));
      if (random() % 30 == 0) box.max[0] = std::numeric_limits<T>::infinity();
      if (random() % 30 == 0) box = Box::nothing();
      result.push_back(box);
    }
    return result;
  }

  static std::vector<std::size_t> counts() {
    std::vector<std::size_t> result;
    for (std::size_t count = 0; count <= 70; ++count) result.push_back(count);
    for (const std::size_t count : {255U, 256U, 257U, 1023U, 1025U, 2000U}) result.push_back(count);
    return result;
  }

  static void expect_visits() {
    std::mt19937 random(45);
    for (const std::size_t count : counts()) {
      const std::vector<Box> boxes = draw_boxes(count, random);
      const Tree tree(boxes, Box::everything(), true);
      for (const Box& wanted : draw_boxes(20, random)) {
        const auto matters = [&wanted](const Box& box) { return boxes_overlap(box, wanted); };
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
          if (is_finite(boxes[i].min) && is_finite(boxes[i].max) && matters(boxes[i])) expected.push_back(i);
        }
        std::vector<std::uint32_t> found;
        const auto visit = [&found](std::uint32_t part, std::size_t /*place*/) {
          found.push_back(part);
          return true;
        };
        tree.visit(matters, detail::InAnyOrder(), visit);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << count;
        found.clear();
        tree.visit(OverlapByKey{wanted}, detail::ByKey(), visit);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << count;
      }
    }
  }

  static void expect_unbounded() {
    std::mt19937 random(46);
    std::vector<Box> boxes = draw_boxes(500, random);
    boxes[7].min[0] = std::numeric_limits<T>::quiet_NaN();
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (!is_finite(boxes[i].min) || !is_finite(boxes[i].max)) expected.push_back(i);
    }
    const Tree tree(boxes, Box::everything(), true);
    EXPECT_EQ(std::vector<std::uint32_t>(tree.unbounded().begin(), tree.unbounded().end()), expected);
    EXPECT_EQ(tree.bounds(), Box::everything());
    EXPECT_TRUE(tree.has_usual_lengths());
  }

  static void expect_stop() {
    std::mt19937 random(47);
    const Tree tree(draw_boxes(300, random), Box::nothing(), true);
    int visits = 0;
    tree.visit([](const Box&) { return true; }, detail::InAnyOrder(),
               [&visits](std::uint32_t, std::size_t) { return ++visits < 5; });
    EXPECT_EQ(visits, 5);
  }

  static void expect_few_tests() {
    std::vector<Box> boxes;
    const int side = N == 2 ? 100 : 22;
    for (int i = 0; i < 10'000; ++i) {
      Vec<N, T> center(T(0));
      center[0] = static_cast<T>(i % side);
      center[1] = static_cast<T>(i / side % side);
      center[N - 1] = static_cast<T>(N == 2 ? i / side : i / (side * side));
      boxes.push_back(Box::from_center(center, Vec<N, T>(T(0.25))));
    }
    const Tree tree(boxes, Box::everything(), true);
    for (const double from : {-50.0, 5.125, 11.0, 17.375}) {
      const Vec<N, T> point(static_cast<T>(from));
      const auto distance = [&point](const Box& box) {
        const Vec<N, T> off = clamp(point, box.min, box.max) - point;
        return static_cast<double>(dot(off, off));
      };
      double expected = std::numeric_limits<double>::infinity();
      for (const Box& box : boxes) expected = std::min(expected, distance(box));
      NearestByKey by_key{point};
      tree.visit(by_key, detail::ByKey(), [&](std::uint32_t part, std::size_t /*place*/) {
        by_key.least = distance(boxes[part]);
        return true;
      });
      EXPECT_EQ(by_key.least, expected);
      EXPECT_LT(by_key.tests, 300);  // none is tested again when its turn comes
    }
  }
};
TYPED_TEST_SUITE(PartTreeIn, Spaces);

TYPED_TEST(PartTreeIn, VisitsTheBoxesThatMatterOnceAndNoOthers) { TestFixture::expect_visits(); }

TYPED_TEST(PartTreeIn, ListsTheUnboundedBoxes) { TestFixture::expect_unbounded(); }

TYPED_TEST(PartTreeIn, StopsWhenAskedTo) { TestFixture::expect_stop(); }

// A search for the nearest box enters few others, whether it looks from inside or from far away.
TYPED_TEST(PartTreeIn, FindsTheFirstInTimeLogarithmicInTheNumber) { TestFixture::expect_few_tests(); }

}  // namespace
}  // namespace graze::test::part_tree_test
