// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "query/point_agreement.hpp"

namespace graze::test {
namespace {

TEST(PointAgreementInThePlane, InFloatEveryAnswerIsWithinAFewUlpOfTheExactOne) {
  expect_exact_answers_of_every_type<2, float>();
}

}  // namespace
}  // namespace graze::test
