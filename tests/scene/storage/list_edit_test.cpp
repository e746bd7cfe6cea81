// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/storage/list_edit.hpp>

namespace graze::detail::list_edit_test {
namespace {

using Numbers = std::vector<int>;

/// The list after the edit, which must not allocate.
Numbers edited(Numbers list, const std::vector<std::size_t>& removed, const Numbers& added) {
  ListEdit<int> edit;
  edit.plan(list, removed, added);
  list.reserve(edit.size());
  const int* const place = list.data();
  edit.apply(list, added);
  EXPECT_EQ(list.data(), place);
  EXPECT_EQ(list.size(), edit.size());
  return list;
}

TEST(ListEdit, TakesOutAndPutsIn) {
  EXPECT_EQ(edited({}, {}, {}), (Numbers{}));
  EXPECT_EQ(edited({}, {}, {1, 2}), (Numbers{1, 2}));
  EXPECT_EQ(edited({1, 2}, {0, 1}, {}), (Numbers{}));
  EXPECT_EQ(edited({1, 3, 5, 7}, {1}, {4, 6}), (Numbers{1, 4, 5, 6, 7}));
  EXPECT_EQ(edited({1, 3, 5, 7}, {0, 1}, {8}), (Numbers{5, 7, 8}));
  EXPECT_EQ(edited({5, 7}, {1}, {0, 1, 2, 3}), (Numbers{0, 1, 2, 3, 5}));
  EXPECT_EQ(edited({5, 7}, {1}, {7}), (Numbers{5, 7}));
}

TEST(ListEdit, PositionsAreThoseOfTheFirstThatIsNotBefore) {
  const Numbers list{1, 3, 3, 5, 7, 9};
  for (std::size_t from = 0; from <= list.size(); ++from) {
    for (std::size_t end = from; end <= list.size(); ++end) {
      for (int item = 0; item <= 10; ++item) {
        const auto first = list.begin() + static_cast<std::ptrdiff_t>(from);
        const auto last = list.begin() + static_cast<std::ptrdiff_t>(end);
        const auto expected = static_cast<std::size_t>(std::lower_bound(first, last, item) - list.begin());
        EXPECT_EQ(position_of<int>(list, item, from, end), expected);
      }
    }
  }
}

RC_GTEST_PROP(ListEdit, MakesAnyListAnyOther, (const std::set<int>& before, const std::set<int>& after)) {
  const Numbers list(before.begin(), before.end());
  std::vector<std::size_t> removed;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (after.count(list[k]) == 0) removed.push_back(k);
  }
  Numbers added;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
  RC_ASSERT(edited(list, removed, added) == Numbers(after.begin(), after.end()));
}

}  // namespace
}  // namespace graze::detail::list_edit_test
