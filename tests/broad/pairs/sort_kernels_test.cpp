// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/sort_kernels.hpp>

#include "broad/simd_targets.hpp"

namespace graze::detail::sort_kernels_test {
namespace {

/// Pairs of rows of 64 and more, as codes.
template <class Code>
std::vector<Code> codes_of(const std::vector<Pair>& pairs, PairCode form) {
  std::vector<Code> codes;
  for (const Pair& pair : pairs) codes.push_back(form.of<Code>(pair));
  return codes;
}

/// The greatest second index that codes with up to 32 rows can hold.
template <class Code>
constexpr PairCode form_of{.row_bits = 5, .second_bits = sizeof(Code) == sizeof(std::int32_t) ? 26U : 32U};

template <class Code>
class SortCodes : public testing::Test {};
using CodeTypes = testing::Types<std::int32_t, std::int64_t>;
TYPED_TEST_SUITE(SortCodes, CodeTypes);

TYPED_TEST(SortCodes, PutPairsOfShortRowsInTheirPlacesAndLeaveOutTheOthers) {
  constexpr PairCode form = form_of<TypeParam>;
  constexpr std::uint32_t rows = 32;
  constexpr std::uint32_t last = 0xFFFFFFFFU >> (32 - form.second_bits);
  constexpr Pair untouched{7, 7};
  std::mt19937 random(5);
  std::vector<Pair> sorted;
  std::vector<std::uint32_t> begins = {0};
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t length = row < 20 ? row : 0;  // 17 to 19 are not short
    for (std::uint32_t k = 0; k < length; ++k) sorted.push_back({64 + row, last - 1000 * (length - k)});
    begins.push_back(static_cast<std::uint32_t>(sorted.size()));
  }
  std::vector<std::uint32_t> seconds;
  for (const Pair& pair : sorted) seconds.push_back(pair.b);
  for (std::uint32_t row = 0; row < rows; ++row) {
    std::shuffle(seconds.begin() + begins[row], seconds.begin() + begins[row + 1], random);
  }
  seconds.resize(seconds.size() + short_row);
  std::vector<Pair> pairs = sorted;
  std::shuffle(pairs.begin(), pairs.end(), random);
  const std::vector<TypeParam> codes = codes_of<TypeParam>(pairs, form);
  std::vector<Pair> expected = sorted;
  for (std::uint32_t k = begins[17]; k < begins[20]; ++k) expected[k] = untouched;
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    std::vector<Pair> placed(sorted.size(), untouched);
    sort_kernels().of<TypeParam>().place(codes.data(), codes.size(), {form, 64}, begins.data(), seconds.data(),
                                         placed.data());
    EXPECT_EQ(placed, expected) << hwy::TargetName(target);
  }
}

TEST(SortKernels, PutRowsInTheirPlacesAndWriteNothingBehindThem) {
  constexpr std::uint32_t rows = 100;
  constexpr Pair untouched{7, 7};
  std::mt19937 random(8);
  for (std::uint32_t last = 0; last <= placed_row; ++last) {
    std::vector<Pair> expected;
    std::vector<std::uint32_t> begins = {0};
    for (std::uint32_t row = 0; row < rows; ++row) {
      const std::uint32_t length = row + 1 == rows ? last : row * 11 % (placed_row + 2);  // 33 is too long
      for (std::uint32_t k = 0; k < length; ++k) expected.push_back({1024 + row, 0xFFFFFFFFU - 0x07000001U * k});
      begins.push_back(static_cast<std::uint32_t>(expected.size()));
    }
    std::vector<std::uint32_t> seconds;
    for (const Pair& pair : expected) seconds.push_back(pair.b);
    for (std::uint32_t row = 0; row < rows; ++row) {
      std::sort(expected.begin() + begins[row], expected.begin() + begins[row + 1]);
      std::shuffle(seconds.begin() + begins[row], seconds.begin() + begins[row + 1], random);
    }
    expected.insert(expected.end(), placed_row, untouched);
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      std::vector<Pair> placed(expected.size(), untouched);
      sort_kernels().place_rows(begins.data(), rows, 1024, seconds.data(), placed.data());
      for (std::uint32_t row = 0; row < rows; ++row) {
        if (begins[row + 1] - begins[row] <= placed_row) continue;
        std::copy(expected.begin() + begins[row], expected.begin() + begins[row + 1], placed.begin() + begins[row]);
      }
      EXPECT_EQ(placed, expected) << hwy::TargetName(target) << ", the last row of " << last;
    }
  }
}

TYPED_TEST(SortCodes, PutKeysOfVeryShortRowsInTheirPlacesAndLongerOnesWhereTheyBelong) {
  constexpr PairCode form = form_of<TypeParam>;
  constexpr std::uint32_t first = 0xFFFFF000U;
  constexpr std::uint32_t last = 0xFFFFFFFFU >> (32 - form.second_bits);
  constexpr std::uint32_t long_row = 15;
  std::mt19937 random(6);
  std::vector<Pair> expected;
  std::vector<TypeParam> keys(very_short_row, std::numeric_limits<TypeParam>::min());
  for (std::uint32_t row = 0; row < form.rows(); ++row) {
    const std::uint32_t length = row == long_row ? 40 : (row * 7 + row / 9) % (very_short_row + 1);
    for (std::uint32_t k = 0; k < length; ++k) {
      expected.push_back({first + row, last - last / 50 * k});
      keys.push_back(form.of<TypeParam>(expected.back()));
    }
    std::shuffle(keys.end() - length, keys.end(), random);
  }
  std::sort(expected.begin(), expected.end());
  keys.insert(keys.end(), very_short_row, std::numeric_limits<TypeParam>::max());
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    std::vector<Pair> placed(expected.size());
    sort_kernels().of<TypeParam>().place_keys(keys.data() + very_short_row, placed.size(), {form, first},
                                              placed.data());
    for (std::size_t k = 0; k < placed.size(); ++k) {
      if (expected[k].a == first + long_row) {
        placed[k] = expected[k];  // longer rows: only guaranteed to stay within range
      }
    }
    EXPECT_EQ(placed, expected) << hwy::TargetName(target);
  }
}

}  // namespace
}  // namespace graze::detail::sort_kernels_test
