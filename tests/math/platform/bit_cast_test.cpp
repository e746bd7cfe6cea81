// SPDX-License-Identifier: MIT
#include <cstdint>

#include <gtest/gtest.h>

#include <graze/math/platform/bit_cast.hpp>

namespace graze::bit_cast_test {
namespace {

TEST(BitCast, GivesTheBitsOfANumber) {
  static_assert(bit_cast<std::uint32_t>(1.0F) == 0x3f800000U);
  static_assert(bit_cast<std::uint64_t>(-2.0) == 0xc000000000000000U);
  EXPECT_EQ(bit_cast<std::uint64_t>(-0.0), 0x8000000000000000U);
}

TEST(BitCast, GivesTheNumberOfTheBits) {
  EXPECT_EQ(bit_cast<float>(std::uint32_t{0x40490fdb}), 3.14159274F);
  EXPECT_EQ(bit_cast<double>(std::uint64_t{1}), 4.9406564584124654e-324);
}

}  // namespace
}  // namespace graze::bit_cast_test
