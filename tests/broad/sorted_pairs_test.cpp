// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/sorted_pairs.hpp>

#include "box_worlds.hpp"

namespace graze::sorted_pairs_test {
namespace {

/// All pairs, and the largest batch.
struct Visited {
  std::vector<Pair> pairs;
  std::size_t most = 0;
};

template <Dim N, class T>
Visited visited(const std::vector<Aabb<N, T>>& boxes, std::size_t most, const PairOptions& options = {}) {
  Visited result;
  const auto take = [&result](std::span<const Pair> pairs) {
    EXPECT_FALSE(pairs.empty());
    result.pairs.insert(result.pairs.end(), pairs.begin(), pairs.end());
    result.most = std::max(result.most, pairs.size());
    return true;
  };
  detail::visit_sorted_pairs<N, T>(boxes, take, options, most);
  return result;
}

template <Dim N, class T>
void expect_the_pairs_of_all_at_once() {
  for (const std::size_t count : {0U, 1U, 2U, 9U, 65U, 700U, 2500U}) {
    for (const auto& [name, boxes] : test::box_worlds<N, T>(count, 7)) {
      SCOPED_TRACE(name + " of " + std::to_string(count));
      for (const double margin : {0.0, 0.25}) {
        const PairOptions options{.margin = margin};
        const std::vector<Pair> expected = overlapping_pairs(boxes, options);
        for (const std::size_t most : {0U, 6000U}) {
          const Visited found = visited<N, T>(boxes, most, options);
          EXPECT_TRUE(found.pairs == expected);
          EXPECT_LE(found.most, std::max(most, 2 * count));
        }
      }
    }
  }
}

TEST(SortedPairs, are_those_of_all_at_once_in_the_plane) { expect_the_pairs_of_all_at_once<2, double>(); }
TEST(SortedPairs, are_those_of_all_at_once_in_space) { expect_the_pairs_of_all_at_once<3, float>(); }

TEST(SortedPairs, of_boxes_at_one_place_come_a_few_at_a_time) {
  const std::size_t count = 2000;
  const std::vector<Aabb<2, double>> boxes(count, Aabb<2, double>{{0, 0}, {1, 1}});
  const Visited found = visited<2, double>(boxes, 0);
  EXPECT_LE(found.most, 2 * count);
  ASSERT_EQ(found.pairs.size(), count * (count - 1) / 2);
  EXPECT_EQ(found.pairs, overlapping_pairs(boxes));
}

TEST(SortedPairs, grow_fewer_and_more_again_along_the_boxes) {
  // A cluster, then boxes that touch nothing, then another cluster.
  std::vector<Aabb<2, double>> boxes(400, Aabb<2, double>{{0, 0}, {1, 1}});
  for (int i = 0; i < 3000; ++i) boxes.push_back({{10.0 + 2 * i, 0}, {11.0 + 2 * i, 1}});
  boxes.insert(boxes.end(), 400, Aabb<2, double>{{-5, 0}, {-4, 1}});
  EXPECT_EQ((visited<2, double>(boxes, 0).pairs), overlapping_pairs(boxes));
}

TEST(SortedPairs, stop_when_the_visitor_has_enough) {
  const std::vector<Aabb<2, double>> boxes(500, Aabb<2, double>{{0, 0}, {1, 1}});
  std::size_t calls = 0;
  const auto refuse = [&calls](std::span<const Pair>) {
    ++calls;
    return false;
  };
  detail::visit_sorted_pairs<2, double>(boxes, refuse, {}, 0);
  EXPECT_EQ(calls, 1U);
  visit_sorted_pairs<2, double>(boxes, refuse);
  EXPECT_EQ(calls, 2U);
}

TEST(SortedPairs, refuse_what_overlapping_pairs_refuses) {
  const auto ignore = [](std::span<const Pair>) { return true; };
  std::vector<Aabb<2, double>> boxes(100, Aabb<2, double>{{0, 0}, {1, 1}});
  EXPECT_THROW((visit_sorted_pairs<2, double>({}, ignore, {.margin = -1})), std::invalid_argument);
  EXPECT_THROW((visit_sorted_pairs<2, double>(boxes, ignore, {.margin = -1})), std::invalid_argument);
  boxes[70].min.x = std::numeric_limits<double>::quiet_NaN();
  try {
    detail::visit_sorted_pairs<2, double>(boxes, ignore, {}, 0);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("70"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace graze::sorted_pairs_test
