// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/broad/memory/scratch_arena.hpp>

#include "broad/thread_executor.hpp"

namespace graze::detail::lent_memory_test {
namespace {

constexpr std::size_t piece = ScratchArena::piece;

TEST(ScratchArena, IsTakenPieceByPieceEachWithinWhatWasGivenAndApartFromTheOthers) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t sizes[] = {*rc::gen::inRange<std::size_t>(0, 5 * piece),
                                 *rc::gen::inRange<std::size_t>(0, 5 * piece)};
    const auto offset = *rc::gen::inRange<std::size_t>(0, 5000);
    std::vector<std::byte> memory(10 * piece + 5000);
    const std::span<std::byte> first(memory.data() + offset, sizes[0]);
    const std::span<std::byte> second(memory.data() + offset + sizes[0], sizes[1]);
    ScratchArena lent;
    lent.give(first);
    lent.give(second);
    std::vector<std::byte*> taken;
    while (std::byte* const one = lent.take()) taken.push_back(one);
    const std::size_t most = sizes[0] / piece + sizes[1] / piece;
    RC_ASSERT(taken.size() <= most);
    RC_ASSERT(taken.size() + 2 >= most);  // alignment loses at most one piece of each
    std::sort(taken.begin(), taken.end());
    for (std::size_t k = 0; k < taken.size(); ++k) {
      RC_ASSERT(reinterpret_cast<std::uintptr_t>(taken[k]) % ScratchArena::alignment == 0);
      if (k > 0) RC_ASSERT(taken[k] - taken[k - 1] >= static_cast<std::ptrdiff_t>(piece));
      const auto is_in = [&](std::span<std::byte> part) {
        return taken[k] >= part.data() && taken[k] + piece <= part.data() + part.size();
      };
      RC_ASSERT(is_in(first) || is_in(second));
      RC_ASSERT(lent.has(taken[k]) && lent.has(taken[k] + piece - 1));
    }
    RC_ASSERT(!lent.has(memory.data() + offset + sizes[0] + sizes[1]));
    lent.clear();
    if (!taken.empty()) RC_ASSERT(!lent.has(taken[0]));
  }));
}

TEST(ScratchArena, GivesNoPieceToTwoThreads) {
  constexpr std::size_t pieces = 200;
  std::vector<std::byte> memory(pieces * piece + ScratchArena::alignment);
  ScratchArena lent;
  lent.give(memory);
  std::vector<std::byte*> taken(2 * pieces);
  test::ThreadExecutor(4).parallel_for(taken.size(), [&](std::size_t k) { taken[k] = lent.take(); });
  const std::set<std::byte*> different(taken.begin(), taken.end());
  EXPECT_EQ(different.size(), pieces + 1) << "null, when none was left";
}

}  // namespace
}  // namespace graze::detail::lent_memory_test
