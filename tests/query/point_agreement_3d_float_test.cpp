// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "query/point_agreement.hpp"

namespace graze::test::point_agreement_3d_float_test {
namespace {

TEST(PointAgreementInSpace, InFloatEveryAnswerIsWithinAFewUlpOfTheExactOne) {
  expect_exact_answers_of_every_type<3, float>();
}

}  // namespace
}  // namespace graze::test::point_agreement_3d_float_test
