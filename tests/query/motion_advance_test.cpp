// SPDX-License-Identifier: MIT
// What the way from one parting plane to the next rests on; time_of_impact_laws_test.cpp judges where it leads.
#include <gtest/gtest.h>

#include <graze/query/motion_advance.hpp>

namespace graze::test::motion_advance_test {
namespace {

TEST(MotionAdvance, TheLeastBetweenTwoGapsIsThatOfTheParabola) {
  EXPECT_EQ(detail::least_between(1, 2, 0), 1);
  EXPECT_EQ(detail::least_between(2, 1, 0), 1);
  EXPECT_EQ(detail::least_between(1, 1, 2), 0.5);  // 1 - 2 s + 2 s^2 at s = 1/2
  EXPECT_EQ(detail::least_between(4, 0, 1), 0);    // 4 - 5 s + s^2 falls all the way
}

}  // namespace
}  // namespace graze::test::motion_advance_test
