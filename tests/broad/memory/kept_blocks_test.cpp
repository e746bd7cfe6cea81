// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/memory/kept_blocks.hpp>

namespace graze::detail::kept_blocks_test {
namespace {

std::vector<void*> given_up;
void give_up(void* block, std::size_t /*bytes*/) noexcept { given_up.push_back(block); }

class KeptBlocksTest : public testing::Test {
 protected:
  KeptBlocksTest() { given_up.clear(); }

  void* block(std::size_t i) { return &memory_[i]; }

  /// Creates a block and returns it.
  void make(KeptBlocks& kept, std::size_t i, std::size_t bytes) {
    kept.note_new(bytes);
    kept.keep(block(i), bytes);
  }

 private:
  std::array<char, 100> memory_{};  // used only for addresses
};

TEST_F(KeptBlocksTest, GiveABlockToWhoNeedsJustAsMuch) {
  KeptBlocks kept(1'000, 2, give_up);
  EXPECT_EQ(kept.take(100), nullptr);
  make(kept, 0, 100);
  make(kept, 1, 200);
  make(kept, 2, 100);
  EXPECT_EQ(kept.bytes(), 400U);
  EXPECT_EQ(kept.take(99), nullptr);
  EXPECT_EQ(kept.take(200), block(1));
  EXPECT_EQ(kept.take(200), nullptr);
  EXPECT_EQ(kept.take(100), block(2));  // the latest
  EXPECT_EQ(kept.take(100), block(0));
  EXPECT_EQ(kept.bytes(), 0U);
  EXPECT_TRUE(given_up.empty());
}

TEST_F(KeptBlocksTest, HoldNoMoreThanTheyMay) {
  KeptBlocks kept(1'000, 2, give_up);
  make(kept, 0, 1'001);
  EXPECT_EQ(given_up, std::vector<void*>({block(0)}));
  make(kept, 1, 400);
  make(kept, 2, 500);
  make(kept, 3, 501);  // the others are released, the oldest first
  EXPECT_EQ(given_up, std::vector<void*>({block(0), block(1), block(2)}));
  EXPECT_EQ(kept.bytes(), 501U);
  make(kept, 4, 499);
  EXPECT_EQ(kept.bytes(), 1'000U);
}

TEST_F(KeptBlocksTest, HoldAShareOfWhatIsInUse) {
  KeptBlocks kept(1'000, 2, give_up);
  kept.note_new(3'000);
  kept.note_new(2'000);
  make(kept, 0, 1'500);
  make(kept, 1, 1'000);
  EXPECT_EQ(kept.bytes(), 2'500U);  // half of 5,000
  EXPECT_EQ(kept.take(1'500), block(0));
  kept.keep(block(2), 3'000);  // 3,500 are left in use
  EXPECT_EQ(given_up, std::vector<void*>({block(2)}));
  kept.keep(block(0), 1'500);  // 2,000 are left in use, half of which is less
  EXPECT_EQ(given_up, std::vector<void*>({block(2), block(0)}));
  EXPECT_EQ(kept.bytes(), 1'000U);
  kept.keep(block(3), 2'000);
  EXPECT_EQ(kept.bytes(), 1'000U);
}

TEST_F(KeptBlocksTest, GiveUpWhatIsTooMuchWhenLessIsInUse) {
  KeptBlocks kept(1'000, 2, give_up);
  kept.note_new(9'000);
  kept.note_new(1'000);
  make(kept, 0, 4'000);
  EXPECT_EQ(kept.bytes(), 4'000U);
  kept.keep(block(1), 9'000);
  EXPECT_EQ(given_up, std::vector<void*>({block(0), block(1)}));
  EXPECT_EQ(kept.bytes(), 0U);
  kept.keep(block(2), 1'000);
  EXPECT_EQ(kept.bytes(), 1'000U);
}

TEST_F(KeptBlocksTest, HoldAFewAlone) {
  KeptBlocks kept(1'000'000, 2, give_up);
  for (std::size_t k = 0; k < 100; ++k) make(kept, k, 10);
  EXPECT_EQ(kept.bytes(), 640U);
  ASSERT_EQ(given_up.size(), 36U);
  EXPECT_EQ(given_up.front(), block(0));
}

TEST_F(KeptBlocksTest, GiveUpWhatNobodyNeedsForLong) {
  KeptBlocks kept(1'000, 2, give_up);
  make(kept, 0, 100);
  for (std::uint64_t k = 0; k < KeptBlocks::patience; ++k) {
    ASSERT_EQ(kept.take(50), nullptr);
    if (k == 3) make(kept, 1, 100);
  }
  EXPECT_TRUE(given_up.empty());
  ASSERT_EQ(kept.take(50), nullptr);
  EXPECT_EQ(given_up, std::vector<void*>({block(0)}));
  EXPECT_EQ(kept.take(100), block(1));
}

TEST_F(KeptBlocksTest, GiveUpAllAtTheEnd) {
  {
    KeptBlocks kept(1'000, 2, give_up);
    make(kept, 0, 100);
    make(kept, 1, 100);
  }
  EXPECT_EQ(given_up, std::vector<void*>({block(0), block(1)}));
}

TEST_F(KeptBlocksTest, LendABlockToOneThreadAtATime) {
  KeptBlocks kept(1'000, 2, give_up);
  std::array<int, 3> uses{};  // each is written to by the thread that has the block
  for (int& number : uses) {
    kept.note_new(sizeof(int));
    kept.keep(&number, sizeof(int));
  }
  const auto work = [&kept] {
    int done = 0;
    while (done < 10'000) {
      auto* const number = static_cast<int*>(kept.take(sizeof(int)));
      if (number == nullptr) continue;
      ++*number;
      kept.keep(number, sizeof(int));
      ++done;
    }
  };
  std::thread first(work);
  std::thread second(work);
  first.join();
  second.join();
  EXPECT_EQ(uses[0] + uses[1] + uses[2], 20'000);
}

}  // namespace
}  // namespace graze::detail::kept_blocks_test
