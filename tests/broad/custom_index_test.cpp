// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/custom_index.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/shape/capsule.hpp>

#include "spatial_index_laws.hpp"

namespace graze::test::custom_index_test {
namespace {

/// Finds the boxes that do not end left of a region, ordered by right sides. Rejects boxes wider than `widest`.
template <Dim N, class T>
class ByRightSide {
 public:
  using Box = Aabb<N, T>;

  explicit ByRightSide(T widest = std::numeric_limits<T>::infinity()) : widest_(widest) {}

  void add(std::uint32_t number, const Box& box) {
    if (box.max[0] - box.min[0] > widest_) throw std::runtime_error("too wide");
    numbers_.insert({box.max[0], number});
  }
  void remove(std::uint32_t number, const Box& box) { numbers_.erase({box.max[0], number}); }
  void candidates(const Box& region, auto&& visit) const {
    for (auto at = numbers_.lower_bound({region.min[0], 0}); at != numbers_.end() && visit(at->second); ++at) {
    }
  }

  std::size_t size() const { return numbers_.size(); }

 private:
  std::set<std::pair<T, std::uint32_t>> numbers_;
  T widest_;
};

/// Finds no unnecessary boxes, so a reach that is too small is detected.
template <Dim N, class T>
class JustThese {
 public:
  using Box = Aabb<N, T>;

  void add(std::uint32_t number, const Box& box) { boxes_.emplace(number, box); }
  void remove(std::uint32_t number, const Box&) { boxes_.erase(number); }
  void candidates(const Box& region, auto&& visit) const {
    for (const auto& [number, box] : boxes_) {
      if (detail::boxes_overlap_at_once(region, box) && !visit(number)) return;
    }
  }

 private:
  std::map<std::uint32_t, Box> boxes_;
};

using Tested = testing::Types<CustomIndex<ByRightSide<2, float>>, CustomIndex<ByRightSide<3, double>>,
                              CustomIndex<JustThese<2, float>>, CustomIndex<JustThese<3, double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Custom, SpatialIndexLaws, Tested);

TEST(CustomIndex, WantsAFinderOfBoxes) {
  EXPECT_TRUE((BoxFinder<ByRightSide<2, float>>));
  EXPECT_FALSE(BoxFinder<int>);
  EXPECT_FALSE((BoxFinder<BruteForce<2>>));
}

TEST(CustomIndex, StaysAsItWasWhenItsFinderThrows) {
  using Index = CustomIndex<ByRightSide<2, float>>;
  Index index(ByRightSide<2, float>(2));
  const Key key = index.insert({{0, 0}, {1, 1}});
  EXPECT_THROW(index.insert({{0, 0}, {3, 1}}), std::runtime_error);
  EXPECT_THROW(index.update(key, {{0, 0}, {3, 1}}), std::runtime_error);
  EXPECT_EQ(index.size(), 1U);
  EXPECT_EQ(index.finder().size(), 1U);
  EXPECT_EQ(index.box(key), (Aabb<2>{{0, 0}, {1, 1}}));
  EXPECT_EQ(count(index, Aabb<2>{{1, 1}, {5, 5}}), 1U);
  EXPECT_EQ(count(index, Aabb<2>{{2, 0}, {5, 5}}), 0U);
  EXPECT_EQ(index.insert({{4, 4}, {5, 5}}).index, 1U);
}

TEST(CustomIndex, ItsFinderHoldsWhatItHolds) {
  CustomIndex<ByRightSide<2, float>> index;
  std::vector<Key> keys = insert_row(index, 50);
  for (std::size_t k = 0; k < 20; ++k) index.erase(keys[k]);
  EXPECT_EQ(index.finder().size(), 30U);
  index.clear();
  EXPECT_EQ(index.finder().size(), 0U);
}

/// Whether a region touches depends on the rounding of the larger object, so a finder must know the largest box.
TEST(CustomIndex, FindsWhatTouchesByTheRoundingOfALargeBox) {
  const Capsule<2, double> region{{0, 0}, {-1.125, 2.75}, 1};
  std::size_t found_apart = 0;
  for (int k = 0; k < 200; ++k) {
    const Aabb<2, double> box{{1 + k * 1e-9, -1e9 + k * 4e6}, {1e9, 1e9}};
    CustomIndex<JustThese<2, double>> index;
    BruteForce<2, double> judge;
    index.insert(box);
    judge.insert(box);
    EXPECT_EQ(count(index, region), count(judge, region)) << k;
    if (box.min[0] > detail::RegionProbe(region).reach(0).max[0]) found_apart += count(judge, region);
  }
  EXPECT_GT(found_apart, 0U) << "or nothing was queried";
}

TEST(CustomIndex, FindsTheNearestAtEveryScale) {
  for (const double unit : {1e-200, 1e-30, 1.0, 1e30, 1e200}) {
    CustomIndex<JustThese<2, double>> index;
    BruteForce<2, double> judge;
    for (int k = 0; k < 40; ++k) {
      const Vec<2, double> corner = Vec<2, double>(k % 7 - 3, k % 11) * unit;
      const Aabb<2, double> box{corner, corner + unit * (k % 3)};
      index.insert(box);
      judge.insert(box);
    }
    for (const std::size_t wanted : {1U, 3U, 40U, 60U}) {
      const auto found = index.nearest({unit / 3, -unit}, wanted);
      const auto expected = judge.nearest({unit / 3, -unit}, wanted);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].key.index, expected[k].key.index);
        EXPECT_EQ(found[k].distance_squared, expected[k].distance_squared);
      }
    }
  }
}

}  // namespace
}  // namespace graze::test::custom_index_test
