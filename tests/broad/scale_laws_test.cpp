// SPDX-License-Identifier: MIT
// Scale invariance of batch queries: objects scaled by 2^k have the same pairs, verdicts and hits, from the smallest to
// the largest numbers, and batches still give the answers of single calls bit for bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/random/linear_congruential.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/manifold.hpp>

#include "broad/same_manifolds.hpp"
#include "broad/simd_targets.hpp"
#include "catalogue.hpp"
#include "query/case_maker.hpp"
#include "query/pairs.hpp"
#include "query/scaled_shapes.hpp"

namespace graze::test::broad_scale_laws_test {
namespace {

/// Numbers up to 2^4, in quarters, are exact when multiplied by these.
template <class T>
constexpr auto exponents() {
  if constexpr (std::is_same_v<T, float>) {
    return std::array{-147, -140, -126, -60, 60, 100, 120};
  } else {
    return std::array{-1072, -1060, -1022, -600, -120, 120, 600, 1015};
  }
}

template <class Space>
class ScaleLawOfMany : public testing::Test {};
TYPED_TEST_SUITE(ScaleLawOfMany, Spaces);

/// Shapes with small integer coordinates, two of every pair of types, and their pairs.
template <Dim N, class T>
struct Cases {
  std::vector<AnyShape<N, T>> shapes;
  std::vector<Pair> pairs;
};

/// Those whose numbers are all exact when scaled by 2^exponent.
template <Dim N, class T>
Cases<N, T> exact_cases(int exponent) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, T>>;
  Cases<N, T> cases;
  for (std::size_t i = 0; i < types; ++i) {
    for (std::size_t j = 0; j < types; ++j) {
      CaseMaker<N, T> maker(i, j, 31 * i + j);
      for (int k = 0; k < 3; ++k) {
        for (const auto& [a, b] : maker.make(CaseKind::grid)) {
          if (!scales_exactly<N, T>(a, exponent) || !scales_exactly<N, T>(b, exponent)) continue;
          const auto at = static_cast<std::uint32_t>(cases.shapes.size());
          cases.shapes.insert(cases.shapes.end(), {a, b});
          cases.pairs.push_back({at, at + 1});
        }
      }
    }
  }
  return cases;
}

template <Dim N, class T>
std::vector<AnyShape<N, T>> scaled_all(const std::vector<AnyShape<N, T>>& shapes, int exponent) {
  std::vector<AnyShape<N, T>> result;
  for (const AnyShape<N, T>& shape : shapes) result.push_back(scaled<N, T>(shape, exponent));
  return result;
}

TYPED_TEST(ScaleLawOfMany, HoldsForTheVerdictsAndContactsOfBatches) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const int exponent : exponents<T>()) {
    const Cases<N, T> cases = exact_cases<N, T>(exponent);
    EXPECT_GT(cases.pairs.size(), 100U);
    const std::vector<AnyShape<N, T>> large = scaled_all<N, T>(cases.shapes, exponent);
    for (const std::int64_t target : simd_targets()) {
      const ForcedTarget forced(target);
      const auto touching = relations<N, T>(large, cases.pairs);
      const auto touches = contacts<N, T>(large, cases.pairs);
      std::size_t met = 0;
      for (std::size_t i = 0; i < cases.pairs.size(); ++i) {
        const auto [a, b] = cases.pairs[i];
        SCOPED_TRACE((to_source<N, T>(cases.shapes[a]) + ", " + to_source<N, T>(cases.shapes[b]) + " times 2^" +
                      std::to_string(exponent)));
        EXPECT_EQ(touching[i], (relation_of<N, T>(cases.shapes[a], cases.shapes[b])));
        EXPECT_EQ(touching[i], (relation_of<N, T>(large[a], large[b])));
        if (touching[i] == Relation::apart) continue;
        ASSERT_LT(met, touches.size());
        EXPECT_EQ(touches[met].pair, cases.pairs[i]);
        EXPECT_TRUE(same_manifolds(touches[met].manifold, manifold(large[a], large[b])));
        ++met;
      }
      EXPECT_EQ(met, touches.size());
    }
  }
}

/// Boxes in quarters, from -8 to 8, many of which touch.
template <Dim N, class T>
std::vector<Aabb<N, T>> boxes_on_a_grid(std::size_t count) {
  detail::LinearCongruential draws(7);
  const auto point = [&] {
    Vec<N, T> v;
    for (Dim i = 0; i < N; ++i) v[i] = static_cast<T>(draws.below(56)) / 4 - 8;
    return v;
  };
  std::vector<Aabb<N, T>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Aabb<N, T> box{point(), Vec<N, T>(T(0))};
    for (Dim k = 0; k < N; ++k) box.max[k] = box.min[k] + static_cast<T>(draws.below(13)) / 4;
    boxes.push_back(box);
  }
  return boxes;
}

template <Dim N, class T>
std::vector<Aabb<N, T>> scaled_boxes(const std::vector<Aabb<N, T>>& boxes, int exponent) {
  std::vector<Aabb<N, T>> result;
  for (const auto& box : boxes) result.push_back({scaled<N, T>(box.min, exponent), scaled<N, T>(box.max, exponent)});
  return result;
}

TYPED_TEST(ScaleLawOfMany, HoldsForTheOverlappingPairsOfBoxes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = boxes_on_a_grid<N, T>(700);
  const std::vector<Pair> expected = overlapping_pairs<N, T>(boxes);
  EXPECT_FALSE(expected.empty());
  for (const int exponent : exponents<T>()) {
    EXPECT_EQ((overlapping_pairs<N, T>(scaled_boxes<N, T>(boxes, exponent))), expected) << "times 2^" << exponent;
  }
}

/// The boxes in an index that a ray and a sphere meet, by index, with their times.
template <class Index>
std::pair<std::vector<std::pair<std::size_t, double>>, std::vector<std::size_t>> met_in(
    const std::vector<typename Index::Box>& boxes, int exponent) {
  constexpr Dim N = dimension_of<typename Index::Box>;
  using T = scalar_of<typename Index::Box>;
  Index index;
  std::vector<Key> keys;
  for (const auto& box : boxes) keys.push_back(index.insert(box));
  const auto place = [&](const Key& key) {
    return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
  };
  std::pair<std::vector<std::pair<std::size_t, double>>, std::vector<std::size_t>> result;
  Vec<N, T> direction(T(2));
  direction[0] = 1;
  const Ray<N, T> ray{scaled<N, T>(Vec<N, T>(T(-7)), exponent), scaled<N, T>(direction, exponent)};
  index.ray_cast(ray, [&](const Key& key, double t) { result.first.push_back({place(key), t}); });
  const Sphere<N, T> region{scaled<N, T>(Vec<N, T>(T(1)), exponent), scaled(T(5), exponent)};
  index.query(region, [&](const Key& key) { result.second.push_back(place(key)); });
  std::sort(result.second.begin(), result.second.end());
  return result;
}

TYPED_TEST(ScaleLawOfMany, HoldsForTheRaysAndRegionsOfEveryIndex) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = boxes_on_a_grid<N, T>(700);
  const auto expected = met_in<BruteForce<N, T>>(boxes, 0);
  EXPECT_GT(expected.first.size(), 2U);
  EXPECT_GT(expected.second.size(), 2U);
  for (const int exponent : exponents<T>()) {
    SCOPED_TRACE("times 2^" + std::to_string(exponent));
    const auto large = scaled_boxes<N, T>(boxes, exponent);
    EXPECT_EQ((met_in<BruteForce<N, T>>(large, exponent)), expected);
    EXPECT_EQ((met_in<Bvh<N, T>>(large, exponent)), expected);
    EXPECT_EQ((met_in<Orthtree<N, T>>(large, exponent)), expected);
    EXPECT_EQ((met_in<Grid<N, T>>(large, exponent)), expected);
  }
}

}  // namespace
}  // namespace graze::test::broad_scale_laws_test
