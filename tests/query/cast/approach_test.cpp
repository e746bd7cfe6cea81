// SPDX-License-Identifier: MIT
// Whether shapes pass each other along a motion, and whether a motion approaches a touch: by hand, and against the
// depth of the same shapes made as long as the motion.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/shape_cast.hpp>

#include "catalogue.hpp"

namespace graze::test::approach_test {
namespace {

template <Dim N, class A, class B>
bool pass(const A& a, const Vec<N, double>& motion, const B& b, double radius = 0, double slack = 0) {
  return detail::do_pass<double, double>(detail::Passing<N>{detail::ConvexView<N>(a)}, motion,
                                         detail::Passing<N>{detail::ConvexView<N>(b)}, radius, slack);
}

TEST(Approach, BoxesPassAtAnEdgeAndMeetAboveIt) {
  const Aabb<3, double> mover{{0, 0, 0}, {1, 1, 1}};
  const Vec<3, double> right(3, 0, 0);
  EXPECT_TRUE(pass(mover, right, Aabb<3, double>{{5, -1, 0}, {6, 0, 1}}));
  EXPECT_TRUE(pass(mover, right, Aabb<3, double>{{5, 1, 1}, {6, 2, 2}}));
  EXPECT_TRUE(pass(mover, right, Aabb<3, double>{{5, 4, 0}, {6, 5, 1}}));
  EXPECT_FALSE(pass(mover, right, Aabb<3, double>{{5, -1, 0}, {6, 0.001, 1}}));
  EXPECT_TRUE(pass(mover, right, Aabb<3, double>{{5, -1, 0}, {6, 0.001, 1}}, 0, 0.002)) << "by less than the slack";
  EXPECT_FALSE(pass(mover, right, Aabb<3, double>{{5, -1, 0}, {6, -1, 1}}, 2)) << "with a radius";
  EXPECT_TRUE(pass(mover, right, Aabb<3, double>{{5, -1, 0}, {6, -1, 1}}, 1));
}

TEST(Approach, PolygonsPassOnEitherSide) {
  const Aabb<2, double> mover{{0, 0}, {1, 1}};
  EXPECT_TRUE(pass(mover, Vec<2, double>(0, 1e-200), Aabb<2, double>{{1, 5}, {2, 6}}));
  EXPECT_TRUE(pass(mover, Vec<2, double>(0, 1e200), Aabb<2, double>{{-2, 5}, {0, 6}}));
  EXPECT_FALSE(pass(mover, Vec<2, double>(0, 1), Aabb<2, double>{{-2, 5}, {0.5, 6}}));
  EXPECT_TRUE(pass(mover, Vec<2, double>(1, 1), Aabb<2, double>{{1, -1}, {2, 0}})) << "corners on one line";
}

TEST(Approach, WhatIsCrossedBetweenItsEndsIsMet) {
  const Segment<2, double> wall{{1, -1}, {1, 1}};
  EXPECT_FALSE(pass(Vec<2, double>(0, 0), Vec<2, double>(1, 0), wall));
  EXPECT_TRUE(pass(Vec<2, double>(0, 1), Vec<2, double>(1, 0), wall)) << "at its end";
  const Triangle<3, double> sail{{1, -1, -1}, {1, 1, -1}, {1, 0, 1}};
  EXPECT_FALSE(pass(Vec<3, double>(0, 0, 0), Vec<3, double>(1, 0, 0), sail));
  EXPECT_TRUE(pass(Vec<3, double>(0, 0, 1), Vec<3, double>(1, 0, 0), sail)) << "at its tip";
  EXPECT_TRUE(pass(Vec<3, double>(0, 0, -1), Vec<3, double>(1, 0, 0), sail)) << "at its edge";
}

/// A box that is as long as its path overlaps whatever it does not pass.
TEST(Approach, ALongBoxOverlapsWhatTheBoxDoesNotPass) {
  check_property([] {
    const auto whole_number = [] { return static_cast<double>(*rc::gen::inRange(-4, 5)); };
    const auto any_box = [&] {
      Aabb<3, double> box;
      for (Dim i = 0; i < 3; ++i) {
        box.min[i] = whole_number();
        box.max[i] = box.min[i] + 1 + std::fabs(whole_number());
      }
      return box;
    };
    const Aabb<3, double> mover = any_box();
    const Aabb<3, double> other = any_box();
    const auto axis = static_cast<Dim>(*rc::gen::inRange(0, 3));
    Aabb<3, double> way = mover;
    way.min[axis] = -100;
    way.max[axis] = 100;
    const bool overlaps = relation(way, other) == Relation::overlapping;
    RC_ASSERT(pass(mover, unit_axis<3>(axis), other) == !overlaps);
    RC_ASSERT(pass(other, -unit_axis<3>(axis), mover) == !overlaps);
  });
}

TEST(Approach, ARayIsSeenUpToBeyondTheTouch) {
  const Ray<2, double> ray{{0, 0}, {1e-3, 0}};
  const Segment<2, double> seen = detail::core_near(ray, Vec<2, double>(50, 0), 7);
  EXPECT_EQ(seen.start, (Vec<2, double>(0, 0)));
  EXPECT_EQ(seen.end, (Vec<2, double>(57, 0)));
}

/// They cross three thousand lengths away.
TEST(Approach, ARayThatLeadsAcrossTheMotionDoesNotPass) {
  const Ray<2, double> mover{{1, 0}, {-1e-6, 0.003}};
  const Ray<2, double> other{{0, 5}, {0, 0.3}};
  const Vec<2, double> up(0, 1);
  const CastOptions past_touches{true, 0};
  const auto found = shape_cast(mover, up, other, past_touches);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->t, 0);
  EXPECT_TRUE(shape_cast(other, -up, mover, past_touches));
  EXPECT_FALSE(shape_cast(mover, -up, other, past_touches)) << "it moves out";
  EXPECT_FALSE(shape_cast(Ray<2, double>{{1, 0}, {0, 1}}, up, other, past_touches)) << "parallel";
}

TEST(Approach, ANormalAgainstTheMotionEndsTheQuestion) {
  const Sphere<2, double> ball{{0, 1}, 1};
  const HalfSpace<2, double> floor{{0, 1}, 0};
  detail::CastHit<2> touch;
  touch.normal = {0, -1};
  EXPECT_FALSE(detail::is_approached(ball, Vec<2, double>(1, 0), floor, 0, touch));
  EXPECT_FALSE(detail::is_approached(ball, Vec<2, double>(1, -0x1p-41), floor, 0, touch));
  EXPECT_TRUE(detail::is_approached(ball, Vec<2, double>(1, -0x1p-38), floor, 0, touch));
  const Sphere<2, float> small{{0, 1}, 1};
  const HalfSpace<2, float> ground{{0, 1}, 0};
  EXPECT_FALSE(detail::is_approached(small, Vec<2, double>(1, -0x1p-22), ground, 0, touch));
  EXPECT_TRUE(detail::is_approached(small, Vec<2, double>(1, -0x1p-20), ground, 0, touch));
}

}  // namespace
}  // namespace graze::test::approach_test
