// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/grid/table.hpp>

namespace graze::detail::grid_table_test {
namespace {

GridPlace<2> place_number(int number) { return {number % 3, {number % 5 - 2, number / 15}}; }

RC_GTEST_PROP(GridTable, FindsWhatIsThereAndNothingElse, ()) {
  GridTable<2> table;
  std::vector<GridGroup<2>> groups(64);
  std::vector<bool> present(64);
  std::size_t count = 0;
  for (const int number : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 64))) {
    const auto group = static_cast<std::uint32_t>(number);
    groups[group].place = place_number(number);
    if (present[group]) {
      table.remove(groups[group].place, group);
    } else {
      table.prepare(1);
      table.add(groups[group].place, group);
    }
    present[group] = !present[group];
    count = present[group] ? count + 1 : count - 1;
    RC_ASSERT(table.size() == count);
    for (std::uint32_t k = 0; k < 64; ++k) {
      RC_ASSERT(table.find(place_number(static_cast<int>(k)), groups) == (present[k] ? k : no_index));
    }
  }
}

TEST(GridTable, PreparesForMany) {
  GridTable<3> table;
  std::vector<GridGroup<3>> groups;
  EXPECT_EQ(table.find({0, {1, 2, 3}}, groups), no_index);
  table.prepare(1000);
  const std::size_t bytes = table.bytes();
  for (std::uint32_t k = 0; k < 1000; ++k) {
    groups.push_back({{-7, {k, -std::int64_t{k} * k, std::int64_t{1} << 39U}}, 0});
    table.add(groups.back().place, k);
  }
  EXPECT_EQ(table.bytes(), bytes);
  for (std::uint32_t k = 0; k < 1000; ++k) EXPECT_EQ(table.find(groups[k].place, groups), k);
  table.clear();
  EXPECT_EQ(table.size(), 0U);
  EXPECT_EQ(table.find(groups[5].place, groups), no_index);
}

/// Neighbouring cells, which are common, rarely share a hash.
TEST(GridTable, HashesTellNeighboursApart) {
  std::map<std::uint32_t, int> met;
  for (std::int64_t x = -20; x < 20; ++x) {
    for (std::int64_t y = -20; y < 20; ++y) {
      for (const int level : {-1, 0, 1, 2}) ++met[GridTable<2>::hash_of({level, {x, y}}) & 0xFFFFU];
    }
  }
  int most = 0;
  for (const auto& [hash, count] : met) most = count > most ? count : most;
  EXPECT_GT(met.size(), 6000U);  // of 6400 in 65536 buckets; 6098 expected by chance
  EXPECT_LE(most, 5);
}

}  // namespace
}  // namespace graze::detail::grid_table_test
