// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/shape/segment.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::segment_test {
namespace {

template <class S>
class SegmentIn : public testing::Test {};
TYPED_TEST_SUITE(SegmentIn, test::Spaces);

TYPED_TEST(SegmentIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(test::expect_defects(Segment<N, T>{}, test::finite("has a start that is not finite"),
                                 test::finite("has an end that is not finite")),
            2 * N * 11);
}

TYPED_TEST(SegmentIn, OfLengthZeroIsValidAndItsOwnSupport) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Segment<N, T> point{Vec<N, T>(T(3)), Vec<N, T>(T(3))};
  EXPECT_TRUE(is_valid(point));
  EXPECT_EQ(length(point), 0);
  EXPECT_EQ(support(point, unit_axis<N>(1)), (Vec<N, double>(3)));
}

TEST(Segment, DefaultsToTheUnitSegmentAlongX) {
  EXPECT_EQ((Segment<2>{}.start), (Vec<2, float>(0, 0)));
  EXPECT_EQ((Segment<2>{}.end), (Vec<2, float>(1, 0)));
  EXPECT_EQ((Segment<3, double>{}.end), (Vec<3, double>(1, 0, 0)));
}

TEST(Segment, HasALength) {
  const Segment<3, float> segment{{1, 1, 1}, {3, 4, 7}};  // edge (2, 3, 6)
  EXPECT_EQ(length_squared(segment), 49);
  EXPECT_EQ(length(segment), 7);
}

TEST(Segment, LengthIsCalculatedInDouble) {
  // In float 1e30 squared is infinite.
  EXPECT_DOUBLE_EQ(length(Segment<2, float>{{-1e30F, 0}, {1e30F, 0}}), 2.0 * 1e30F);
  EXPECT_EQ(length(Segment<2, float>{{16777216, 0}, {-1, 0}}), 16777217);
}

TEST(Segment, HasTheFartherEndAsSupport) {
  const Segment<2, float> segment{{1, 2}, {5, -1}};
  EXPECT_EQ(support(segment, {1, 0}), (Vec<2, double>(5, -1)));
  EXPECT_EQ(support(segment, {-1e-9, 0}), (Vec<2, double>(1, 2)));
  EXPECT_EQ(support(segment, {0, 7}), (Vec<2, double>(1, 2)));
  EXPECT_EQ(support(segment, {3, 4}), (Vec<2, double>(1, 2)));  // 11 against 11: always the start
}

TEST(Segment, MovesWithBothEnds) {
  const Pose<2, float> pose{Mat<2, float>(rotation_matrix(90)), {10, 0}};
  const Segment<2, float> moved = transformed(Segment<2, float>{{1, 0}, {0, 2}}, pose);
  EXPECT_EQ(moved.start, (Vec<2, float>(10, 1)));
  EXPECT_EQ(moved.end, (Vec<2, float>(8, 0)));
}

}  // namespace
}  // namespace graze::segment_test
