// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "query/point_agreement.hpp"

namespace graze::test::point_agreement_2d_float_test {
namespace {

TEST(PointAgreementInThePlane, InFloatEveryAnswerIsWithinAFewUlpOfTheExactOne) {
  expect_exact_answers_of_every_type<2, float>();
}

}  // namespace
}  // namespace graze::test::point_agreement_2d_float_test
