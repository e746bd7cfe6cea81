// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <graze/query/impact.hpp>

namespace graze::test::impact_test {
namespace {

TEST(Impact, RoundsItsTimeDownAndItsNumbersToNearest) {
  const detail::CastHit<2> cast_hit{1.0 / 3, {1.0 / 3, -0.0}, {0.6, 0.8}, Status::best_bound, 1e-9};
  const Impact<2, float> impact = detail::rounded_impact<float>(cast_hit);
  EXPECT_LT(static_cast<double>(impact.t), 1.0 / 3);
  EXPECT_GT(static_cast<double>(std::nextafter(impact.t, 1.0F)), 1.0 / 3);
  EXPECT_EQ(impact.point, (Vec<2>{static_cast<float>(1.0 / 3), 0}));
  EXPECT_FALSE(std::signbit(impact.point.y));
  EXPECT_EQ(impact.normal, (Vec<2>{0.6F, 0.8F}));
  EXPECT_EQ(impact.status, Status::best_bound);
  EXPECT_EQ(impact.error, 1e-9);
  EXPECT_EQ((detail::rounded_impact<double>(cast_hit).t), 1.0 / 3);
}

TEST(Impact, IsNeverBeforeTheStart) {
  const Impact<3, float> impact = detail::rounded_impact<float>(detail::CastHit<3>{-1e-60, {}, {1, 0, 0}});
  EXPECT_EQ(impact.t, 0.0F);
  EXPECT_FALSE(std::signbit(impact.t));
}

TEST(Impact, OfShapesThatMeetAtTheStartIsTheirContact) {
  const detail::Penetration<2> contact{{0, 1}, 0.5, {1, 3}, {1, 2.5}, Status::converged, 1e-15};
  const detail::CastHit<2> cast_hit = detail::cast_hit_at_start(contact);
  EXPECT_EQ(cast_hit.t, 0);
  EXPECT_EQ(cast_hit.point, (Vec<2, double>{1, 2.75}));
  EXPECT_EQ(cast_hit.normal, (Vec<2, double>{0, 1}));
  EXPECT_EQ(cast_hit.error, 1e-15);
}

TEST(Impact, OfSeveralTheEarliestIsKeptAndOfEqualOnesTheFirst) {
  using CastHit = std::optional<detail::CastHit<2>>;
  CastHit first;
  detail::keep_earlier(first, CastHit());
  EXPECT_FALSE(first.has_value());
  detail::keep_earlier(first, CastHit(detail::CastHit<2>{0.5, {1, 0}}));
  detail::keep_earlier(first, CastHit(detail::CastHit<2>{0.5, {2, 0}}));
  detail::keep_earlier(first, CastHit(detail::CastHit<2>{0.75, {3, 0}}));
  EXPECT_EQ(first->point.x, 1);
  detail::keep_earlier(first, CastHit(detail::CastHit<2>{0.25, {4, 0}}));
  EXPECT_EQ(first->point.x, 4);
}

}  // namespace
}  // namespace graze::test::impact_test
