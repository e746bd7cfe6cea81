// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/aabb.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::aabb_test {
namespace {

static_assert(std::is_same_v<Rect<double>, Aabb<2, double>> && std::is_same_v<Rect<>, Aabb<2>>);

template <class S>
class AabbIn : public testing::Test {};
TYPED_TEST_SUITE(AabbIn, test::Spaces);

TYPED_TEST(AabbIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto min_below_one = [](T value, Dim) -> std::string_view {
    if (!std::isfinite(value)) return "has a min that is not finite";
    return value > T(1) ? "has a min above its max" : "";
  };
  const auto max_above_minus_one = [](T value, Dim) -> std::string_view {
    if (!std::isfinite(value)) return "has a max that is not finite";
    return value < T(-1) ? "has a min above its max" : "";
  };
  EXPECT_EQ(test::expect_defects(Aabb<N, T>{}, min_below_one, max_above_minus_one), 2 * N * 11);
}

TYPED_TEST(AabbIn, OfNoSizeIsValidAndItsOwnSupport) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Aabb<N, T> point{Vec<N, T>(T(2)), Vec<N, T>(T(2))};
  EXPECT_TRUE(is_valid(point));
  EXPECT_FALSE(is_nothing(point));
  EXPECT_EQ(support(point, unit_axis<N>(0)), (Vec<N, double>(2)));
}

TYPED_TEST(AabbIn, FromCornersSortsThemWhateverTheirOrder) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Aabb<N, T> box = *test::any<Aabb<N, T>>();
    for (int swaps = 0; swaps < (1 << N); ++swaps) {
      Vec<N, T> a = box.min;
      Vec<N, T> b = box.max;
      for (Dim i = 0; i < N; ++i) {
        if ((swaps >> i) % 2 == 1) std::swap(a[i], b[i]);
      }
      RC_ASSERT((Aabb<N, T>::from_corners(a, b)) == box);
    }
  });
}

TYPED_TEST(AabbIn, OverlapsExactlyWhenNoCoordinateSeparates) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Aabb<N, T>, Aabb<N, T>>();
    bool apart = false;
    for (Dim i = 0; i < N; ++i) apart = apart || a.max[i] < b.min[i] || b.max[i] < a.min[i];
    RC_ASSERT(boxes_overlap(a, b) == !apart);
    RC_ASSERT(boxes_overlap(b, a) == !apart);
  });
}

TEST(Aabb, DefaultsToHalfExtentsOneAtTheOrigin) {
  EXPECT_EQ((Aabb<3>{}.min), (Vec<3, float>(-1, -1, -1)));
  EXPECT_EQ((Aabb<3>{}.max), (Vec<3, float>(1, 1, 1)));
  EXPECT_EQ((Aabb<2, double>{}.half_extents()), (Vec<2, double>(1, 1)));
  EXPECT_EQ((Aabb<2, double>{}.center()), (Vec<2, double>(0, 0)));
}

TEST(Aabb, FromCenterReachesTheHalfExtentsBothWays) {
  const Rect<> box = Rect<>::from_center({1, 2}, {3, 0.5F});
  EXPECT_EQ(box, (Rect<>{{-2, 1.5F}, {4, 2.5F}}));
  EXPECT_EQ(box.center(), (Vec<2, float>(1, 2)));
  EXPECT_EQ(box.half_extents(), (Vec<2, float>(3, 0.5F)));
}

TEST(Aabb, CenterAndHalfExtentsOfTheLargestBoxDoNotOverflow) {
  const float huge = std::numeric_limits<float>::max();
  const Rect<> box{{-huge, huge / 2}, {huge, huge}};
  EXPECT_EQ(box.center(), (Vec<2, float>(0, huge * 0.75F)));
  EXPECT_EQ(box.half_extents(), (Vec<2, float>(huge, huge * 0.25F)));
}

TEST(Aabb, GrowsToContainPointsAndBoxes) {
  Rect<> box = Rect<>::nothing();
  box.grow(Vec<2, float>(3, -1));
  EXPECT_EQ(box, (Rect<>{{3, -1}, {3, -1}}));
  box.grow(Vec<2, float>(1, 5));
  EXPECT_EQ(box, (Rect<>{{1, -1}, {3, 5}}));
  box.grow(Rect<>{{2, 2}, {9, 3}});
  EXPECT_EQ(box, (Rect<>{{1, -1}, {9, 5}}));
  box.grow(Rect<>::nothing());
  EXPECT_EQ(box, (Rect<>{{1, -1}, {9, 5}}));
  box.grow(Rect<>::everything());
  EXPECT_EQ(box, Rect<>::everything());
}

TEST(Aabb, NothingContainsNothingAndEverythingEverything) {
  EXPECT_TRUE(is_nothing(Rect<>::nothing()));
  EXPECT_FALSE(is_nothing(Rect<>::everything()));
  EXPECT_TRUE(is_nothing(Rect<>{{0, 1}, {1, 0}}));
  EXPECT_FALSE(is_nothing(Rect<>{}));
  EXPECT_FALSE(is_valid(Rect<>::nothing()));
  EXPECT_FALSE(is_valid(Rect<>::everything()));
  EXPECT_TRUE(boxes_overlap(Rect<>::everything(), Rect<>::everything()));
  EXPECT_TRUE(boxes_overlap(Rect<>::everything(), Rect<>{}));
  EXPECT_FALSE(boxes_overlap(Rect<>::nothing(), Rect<>{}));
}

TEST(Aabb, TouchingBoxesOverlap) {
  const Rect<> box{{0, 0}, {1, 1}};
  const float above = std::nextafter(1.0F, 2.0F);
  EXPECT_TRUE(boxes_overlap(box, Rect<>{{1, 0}, {2, 1}}));
  EXPECT_TRUE(boxes_overlap(box, Rect<>{{1, 1}, {2, 2}}));
  EXPECT_TRUE(boxes_overlap(box, Rect<>{{0.5F, -3}, {0.5F, 0}}));
  EXPECT_FALSE(boxes_overlap(box, Rect<>{{above, 0}, {2, 1}}));
  EXPECT_FALSE(boxes_overlap(box, Rect<>{{0, above}, {1, 2}}));
}

TEST(Aabb, ABoxWithNanOverlapsNothing) {
  for (Dim i = 0; i < 2; ++i) {
    Rect<> low;
    Rect<> high;
    low.min[i] = std::numeric_limits<float>::quiet_NaN();
    high.max[i] = std::numeric_limits<float>::quiet_NaN();
    for (const Rect<>& box : {low, high}) {
      EXPECT_FALSE(boxes_overlap(box, Rect<>{}));
      EXPECT_FALSE(boxes_overlap(Rect<>{}, box));
      EXPECT_FALSE(boxes_overlap(box, Rect<>::everything()));
    }
  }
}

TEST(Aabb, HasACornerAsSupport) {
  const Aabb<3, float> box{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(support(box, {1, -1, 1e-9}), (Vec<3, double>(4, 2, 6)));
  EXPECT_EQ(support(box, {-1, 0, 0}), (Vec<3, double>(1, 2, 3)));  // of equally far corners the lower one
}

}  // namespace
}  // namespace graze::aabb_test
