// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/shape/capsule.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::capsule_test {
namespace {

template <class S>
class CapsuleIn : public testing::Test {};
TYPED_TEST_SUITE(CapsuleIn, test::Spaces);

TYPED_TEST(CapsuleIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(test::expect_defects(Capsule<N, T>{}, test::finite("has an a that is not finite"),
                                 test::finite("has a b that is not finite"),
                                 test::finite_size("has a radius that is not finite", "has a negative radius")),
            (2 * N + 1) * 11);
}

TYPED_TEST(CapsuleIn, ThatIsASphereASegmentOrAPointIsValid) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Vec<N, T> a(T(1));
  EXPECT_TRUE(is_valid(Capsule<N, T>{a, a, 2}));
  EXPECT_TRUE(is_valid(Capsule<N, T>{a, a * T(2), 0}));
  EXPECT_TRUE(is_valid(Capsule<N, T>{a, a, 0}));
  EXPECT_EQ(support(Capsule<N, T>{a, a, 0}, unit_axis<N>(0)), (Vec<N, double>(1)));
  EXPECT_EQ(support(Capsule<N, T>{a, a * T(2), 0}, unit_axis<N>(0)), (Vec<N, double>(2)));
  EXPECT_EQ(support(Capsule<N, T>{a, a, 2}, unit_axis<N>(0) * 8.0), (Vec<N, double>(1) + 2.0 * unit_axis<N>(0)));
}

TEST(Capsule, DefaultsToAnUprightOne) {
  EXPECT_EQ((Capsule<3>{}.a), (Vec<3, float>(0, -1, 0)));
  EXPECT_EQ((Capsule<3>{}.b), (Vec<3, float>(0, 1, 0)));
  EXPECT_EQ((Capsule<3>{}.radius), 1.0F);
}

TEST(Capsule, IsBuiltAroundASegment) {
  const Segment<2, float> segment = axis(Capsule<2, float>{{1, 2}, {3, 4}, 5});
  EXPECT_EQ(segment.start, (Vec<2, float>(1, 2)));
  EXPECT_EQ(segment.end, (Vec<2, float>(3, 4)));
}

TEST(Capsule, HasItsSupportAtTheRadiusFromTheFartherEnd) {
  const Capsule<2, float> capsule{{0, 0}, {10, 0}, 5};
  EXPECT_EQ(support(capsule, {3, 4}), (Vec<2, double>(13, 4)));
  EXPECT_EQ(support(capsule, {-30, 40}), (Vec<2, double>(-3, 4)));
  EXPECT_EQ(support(capsule, {0, -1}), (Vec<2, double>(0, -5)));
}

TEST(Capsule, MovesWithItsEndsAndKeepsItsRadius) {
  const Pose<2, double> pose{rotation_matrix(-90), {0, 10}};
  const Capsule<2, double> moved = transformed(Capsule<2, double>{{1, 0}, {0, 2}, 0.1}, pose);
  EXPECT_EQ(moved.a, (Vec<2, double>(0, 9)));
  EXPECT_EQ(moved.b, (Vec<2, double>(2, 10)));
  EXPECT_EQ(moved.radius, 0.1);
}

}  // namespace
}  // namespace graze::capsule_test
