// SPDX-License-Identifier: MIT
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <graze/broad/pairs/box_set.hpp>

namespace graze::detail::box_set_test {
namespace {

std::string refusal(std::size_t box, BoxSet set) {
  try {
    refuse_nan(box, set);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(BoxSet, IsNamedWhereThereAreTwo) {
  EXPECT_EQ(refusal(3, BoxSet::only), "overlapping_pairs: box 3 has a coordinate that is NaN");
  EXPECT_EQ(refusal(0, BoxSet::first), "overlapping_pairs: box 0 of the first set has a coordinate that is NaN");
  EXPECT_EQ(refusal(17, BoxSet::second), "overlapping_pairs: box 17 of the second set has a coordinate that is NaN");
}

}  // namespace
}  // namespace graze::detail::box_set_test
