// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "query/point_agreement.hpp"

namespace graze::test::point_agreement_2d_double_test {
namespace {

TEST(PointAgreementInThePlane, InDoubleEveryAnswerIsWithinItsBandOfTheExactOne) {
  expect_exact_answers_of_every_type<2, double>();
}

}  // namespace
}  // namespace graze::test::point_agreement_2d_double_test
