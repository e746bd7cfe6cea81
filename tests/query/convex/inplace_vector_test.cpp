// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/convex/inplace_vector.hpp>

namespace graze::detail::inplace_vector_test {
namespace {

using Few = InplaceVector<int, 4>;

std::vector<int> all_of(const Few& few) { return {few.begin(), few.end()}; }

TEST(InplaceVector, KeepsWhatWasPutInInOrder) {
  Few few;
  EXPECT_TRUE(few.empty());
  for (const int i : {7, 5, 6}) few.push_back(i);
  EXPECT_EQ(all_of(few), (std::vector<int>{7, 5, 6}));
  EXPECT_EQ(std::vector<int>(few.rbegin(), few.rend()), (std::vector<int>{6, 5, 7}));
  EXPECT_EQ(few.size(), 3U);
  EXPECT_EQ(few.back(), 6);
  few[0] = 1;
  EXPECT_EQ(few[0], 1);
  few.pop_back();
  EXPECT_EQ(all_of(few), (std::vector<int>{1, 5}));
}

TEST(InplaceVector, IsFullAtItsRoom) {
  Few few(std::array{1, 2, 3});
  EXPECT_FALSE(few.is_full());
  few.push_back(4);
  EXPECT_TRUE(few.is_full());
  few.pop_back();
  EXPECT_FALSE(few.is_full());
}

TEST(InplaceVector, IsCutLikeAnyRow) {
  Few few(std::array{3, 1, 3, 2});
  std::sort(few.begin(), few.end());
  few.end_at(std::unique(few.begin(), few.end()));
  EXPECT_EQ(all_of(few), (std::vector<int>{1, 2, 3}));
  few.end_at(few.begin());
  EXPECT_TRUE(few.empty());
}

TEST(InplaceVector, IsCopiedAsFarAsItIsFilled) {
  const Few two(std::array{1, 2});
  Few few(std::array{5, 6, 7});
  Few copy = few;
  few = two;
  EXPECT_EQ(all_of(few), (std::vector<int>{1, 2}));
  EXPECT_EQ(all_of(copy), (std::vector<int>{5, 6, 7}));
  const Few& same = copy;
  copy = same;
  EXPECT_EQ(all_of(copy), (std::vector<int>{5, 6, 7}));
}

}  // namespace
}  // namespace graze::detail::inplace_vector_test
