// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include <graze/broad/pairs/pair_code.hpp>

namespace graze::detail::pair_code_test {
namespace {

Pair pair_of(std::size_t bucket, std::int64_t code, PairCode form) {
  const auto first = static_cast<std::uint32_t>(bucket << form.row_bits);
  return {first + form.row_of(code), form.second_of(code)};
}

TEST(PairCode, KeepsAllOfAPairBesideItsBucketAndTheOrderOfPairs) {
  std::mt19937 random(9);
  for (const PairCode form :
       {PairCode{.row_bits = 7, .second_bits = 1}, PairCode{.row_bits = 10, .second_bits = 21},
        PairCode{.row_bits = 7, .second_bits = 32}, PairCode{.row_bits = 22, .second_bits = 32}}) {
    const std::uint32_t most = 0xFFFFFFFFU >> (32 - form.second_bits);
    for (int k = 0; k < 1'000; ++k) {
      const Pair pair{static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random()) & most};
      const Pair other{(pair.a & ~(form.rows() - 1)) | (static_cast<std::uint32_t>(random()) & (form.rows() - 1)),
                       k % 3 == 0 ? most : static_cast<std::uint32_t>(random()) & most};
      const auto code = form.of<std::int64_t>(pair);
      const auto other_code = form.of<std::int64_t>(other);
      EXPECT_GE(code, 0);
      EXPECT_EQ(pair_of(form.bucket_of(pair), code, form), pair);
      EXPECT_EQ(form.bucket_of(pair), form.bucket_of(other));
      EXPECT_EQ(code < other_code, pair < other);
      if (form.narrow()) {
        EXPECT_EQ(form.of<std::int32_t>(pair), code);
      }
    }
  }
}

TEST(PairCode, IsNarrowWhereASignIsLeft) {
  EXPECT_TRUE((PairCode{.row_bits = 10, .second_bits = 21}).narrow());
  EXPECT_FALSE((PairCode{.row_bits = 11, .second_bits = 21}).narrow());
}

}  // namespace
}  // namespace graze::detail::pair_code_test
