// SPDX-License-Identifier: MIT
// Pairs of boxes in one tree or two, and trees that are fitted to other boxes, against brute force.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/parts/box_tree.hpp>
#include <graze/shape/parts/part_tree.hpp>

#include "catalogue.hpp"

namespace graze::test::box_tree_test {
namespace {

using PartPair = std::pair<std::uint32_t, std::uint32_t>;

template <class SpaceType>
class BoxTreeIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Box = Aabb<dimension, Number>;
  using Boxes = std::vector<Box>;
  using Tree = detail::BoxTree<dimension, Number, detail::BoxLeaves<dimension, Number>>;

  static Tree tree_of(const Boxes& boxes) {
    return Tree(detail::OneByOne(), std::span<const Box>(boxes), std::span<const Box>(boxes));
  }

  /// Boxes with whole coordinates, many of them equal; some are infinite.
  static Boxes draw_boxes(std::size_t count, std::mt19937& random, unsigned side, bool is_finite = false) {
    Boxes boxes;
    while (boxes.size() < count) {
      Vec<dimension, Number> center;
      for (Dim i = 0; i < dimension; ++i) center[i] = static_cast<Number>(random() % side);
      boxes.push_back(Box::from_center(center, Vec<dimension, Number>(static_cast<Number>(random() % 3))));
      if (!is_finite && random() % 40 == 0) boxes.back().max[0] = std::numeric_limits<Number>::infinity();
    }
    return boxes;
  }

  /// Where the boxes are: moved by whole numbers.
  struct Moved {
    Box operator()(const Box& box) const { return {box.min + by, box.max + by}; }
    const detail::BoxBlock<dimension, Number>& operator()(const detail::BoxBlock<dimension, Number>& block,
                                                          detail::BoxBlock<dimension, Number>& placed) const {
      for (std::size_t lane = 0; lane < detail::row_length; ++lane) placed.set(lane, (*this)(block.box(lane)));
      return placed;
    }

    Vec<dimension, Number> by;
  };

  /// Pairs up to a squared distance.
  struct UpTo {
    bool admits(Number squared) const { return static_cast<double>(squared) <= most; }
    detail::LaneMask lanes(const detail::BoxBlock<dimension, Number>& block, const Box& box,
                           detail::Row<Number>& squared) const {
      return detail::squared_distances(block, box, static_cast<Number>(most), squared);
    }

    const double& most;
  };

  static Moved moved_by(int by) { return {Vec<dimension, Number>(static_cast<Number>(by))}; }

  static double squared_distance(const Box& a, const Box& b) {
    double sum = 0;
    for (Dim i = 0; i < dimension; ++i) {
      const double gap =
          std::max({0.0, static_cast<double>(a.min[i] - b.max[i]), static_cast<double>(b.min[i] - a.max[i])});
      sum += gap * gap;
    }
    return sum;
  }

  static std::vector<std::size_t> counts() { return {0, 1, 5, 16, 17, 100, 300}; }
};
TYPED_TEST_SUITE(BoxTreeIn, Spaces);

TYPED_TEST(BoxTreeIn, VisitsThePairsThatOverlapOnce) {
  std::mt19937 random(1);
  for (const std::size_t count : TestFixture::counts()) {
    for (const std::size_t other_count : TestFixture::counts()) {
      const auto boxes = TestFixture::draw_boxes(count, random, 20);
      const auto others = TestFixture::draw_boxes(other_count, random, 20);
      const auto place = TestFixture::moved_by(3);
      const auto place_others = TestFixture::moved_by(-2);
      std::vector<PartPair> expected;
      for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = 0; j < other_count; ++j) {
          const bool is_unbounded = !is_finite(boxes[i].max) || !is_finite(others[j].max);
          if (is_unbounded || boxes_overlap(place(boxes[i]), place_others(others[j]))) expected.emplace_back(i, j);
        }
      }
      std::vector<PartPair> found;
      const auto tree = TestFixture::tree_of(boxes);
      const bool is_whole =
          tree.visit_pairs(TestFixture::tree_of(others), place, place_others, [&](std::uint32_t i, std::uint32_t j) {
            found.emplace_back(i, j);
            return true;
          });
      EXPECT_TRUE(is_whole);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << count << " and " << other_count;
    }
  }
}

TYPED_TEST(BoxTreeIn, VisitsItsOwnPairsOnce) {
  std::mt19937 random(2);
  for (const std::size_t count : TestFixture::counts()) {
    const auto boxes = TestFixture::draw_boxes(count, random, 20);
    std::vector<PartPair> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        const bool is_unbounded = !is_finite(boxes[i].max) || !is_finite(boxes[j].max);
        if (is_unbounded || boxes_overlap(boxes[i], boxes[j])) expected.emplace_back(i, j);
      }
    }
    std::vector<PartPair> found;
    TestFixture::tree_of(boxes).visit_own_pairs(TestFixture::moved_by(4), [&](std::uint32_t i, std::uint32_t j) {
      found.emplace_back(std::min(i, j), std::max(i, j));
      return true;
    });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << count;
  }
}

TYPED_TEST(BoxTreeIn, StopsWhenAskedTo) {
  std::mt19937 random(3);
  const auto tree = TestFixture::tree_of(TestFixture::draw_boxes(300, random, 5, true));
  int visits = 0;
  const auto visit = [&visits](std::uint32_t, std::uint32_t) { return ++visits < 5; };
  EXPECT_FALSE(tree.visit_own_pairs(TestFixture::moved_by(0), visit));
  EXPECT_EQ(visits, 5);
  visits = 0;
  EXPECT_FALSE(tree.visit_pairs(tree, TestFixture::moved_by(0), TestFixture::moved_by(0), visit));
  EXPECT_EQ(visits, 5);
}

// With a limit that falls to the least distance so far, the nearest pairs are found, and few others are visited.
TYPED_TEST(BoxTreeIn, VisitsTheNearestPairs) {
  std::mt19937 random(4);
  for (const std::size_t count : TestFixture::counts()) {
    const auto boxes = TestFixture::draw_boxes(count, random, 30, true);
    const auto others = TestFixture::draw_boxes(300, random, 30, true);
    const auto place_others = TestFixture::moved_by(60);
    double least = std::numeric_limits<double>::infinity();
    std::vector<PartPair> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = 0; j < others.size(); ++j) {
        const double squared = TestFixture::squared_distance(boxes[i], place_others(others[j]));
        if (squared < least) expected.clear();
        least = std::min(least, squared);
        if (squared == least) expected.emplace_back(i, j);
      }
    }
    double found_least = std::numeric_limits<double>::infinity();
    std::vector<PartPair> found;
    std::size_t visits = 0;
    const auto tree = TestFixture::tree_of(boxes);
    const auto other_tree = TestFixture::tree_of(others);
    tree.visit_nearest_pairs(other_tree, TestFixture::moved_by(0), place_others,
                             typename TestFixture::UpTo{found_least}, [&](std::size_t place, std::size_t other_place) {
                               ++visits;
                               const std::uint32_t i = tree.part_at(place);
                               const std::uint32_t j = other_tree.part_at(other_place);
                               const double squared = TestFixture::squared_distance(boxes[i], place_others(others[j]));
                               if (squared < found_least) found.clear();
                               found_least = std::min(found_least, squared);
                               if (squared == found_least) found.emplace_back(i, j);
                             });
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << count;
    EXPECT_LE(visits, expected.size() + 50);
  }
}

TYPED_TEST(BoxTreeIn, VisitsPairsOfUnboundedPartsAlone) {
  using T = typename TestFixture::Number;
  std::mt19937 random(5);
  auto boxes = TestFixture::draw_boxes(20, random, 5, true);
  boxes[7].min[0] = -std::numeric_limits<T>::infinity();
  const auto tree = TestFixture::tree_of(boxes);
  std::size_t visits = 0;
  const auto visit = [&visits](std::uint32_t i, std::uint32_t j) {
    EXPECT_TRUE(i == 7 || j == 7);
    return ++visits != 50;
  };
  EXPECT_TRUE(tree.visit_unbounded_pairs(tree, visit));
  EXPECT_EQ(visits, 39U);
  EXPECT_FALSE(tree.visit_unbounded_pairs(tree, visit));
  EXPECT_EQ(visits, 50U);
}

// A fitted tree has the boxes that it was fitted to, in the old order; if they are no neighbours any more, it says so.
TYPED_TEST(BoxTreeIn, IsFittedToOtherBoxes) {
  std::mt19937 random(6);
  const auto boxes = TestFixture::draw_boxes(3000, random, 1000, true);
  const auto tree_of_boxes = TestFixture::tree_of(boxes);
  EXPECT_FALSE(tree_of_boxes.is_outgrown());
  const auto place = TestFixture::moved_by(7);
  auto moved = boxes;
  for (auto& box : moved) box = place(box);
  EXPECT_FALSE(tree_of_boxes.refitted(std::span<const typename TestFixture::Box>(moved)).is_outgrown());
  const auto others = TestFixture::draw_boxes(3000, random, 1000, true);
  const auto tree = tree_of_boxes.refitted(std::span<const typename TestFixture::Box>(others));
  EXPECT_TRUE(tree.is_outgrown());
  std::vector<std::uint32_t> found;
  const auto wanted = others[5];
  tree.visit([&](const auto& box) { return boxes_overlap(box, wanted); }, detail::InAnyOrder(),
             [&](std::uint32_t part, std::size_t place_in_tree) {
               found.push_back(part);
               EXPECT_EQ(tree.leaves().box(place_in_tree), others[part]);
               return true;
             });
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    if (boxes_overlap(others[i], wanted)) expected.push_back(i);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace graze::test::box_tree_test
