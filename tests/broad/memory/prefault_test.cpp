// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/memory/prefault.hpp>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

#include "broad/thread_executor.hpp"

namespace graze::detail::populate_test {
namespace {

constexpr std::size_t large = std::size_t{9} << 20U;

TEST(Populate, LeavesWhatWasWritten) {
  const test::ThreadExecutor two(2);
  std::vector<std::uint32_t> numbers(large / sizeof(std::uint32_t));
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<std::uint32_t>(k * 2'654'435'761U);
  const std::vector<std::uint32_t> before = numbers;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}, std::size_t{1'000'003}}) {
    prefault(numbers.data() + first, (numbers.size() - first) * sizeof(std::uint32_t), two);
  }
  prefault(numbers.data(), 1, two);
  prefault(nullptr, 0, two);
  EXPECT_EQ(numbers, before);
}

#if defined(__linux__) && defined(MADV_POPULATE_WRITE)

/// Memory that has never been written.
class FreshMemory {
 public:
  FreshMemory() : memory_(mmap(nullptr, large, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {}
  ~FreshMemory() { munmap(memory_, large); }
  FreshMemory(const FreshMemory&) = delete;
  FreshMemory& operator=(const FreshMemory&) = delete;

  char* data() const { return static_cast<char*>(memory_); }
  bool exists() const { return memory_ != MAP_FAILED; }

  std::size_t pages_in_memory() const {
    std::vector<unsigned char> there(large / page());
    if (mincore(memory_, large, there.data()) != 0) return 0;
    return static_cast<std::size_t>(std::count_if(there.begin(), there.end(), [](unsigned char c) { return c & 1U; }));
  }

  /// Whether the system fetches pages on demand, and tells it: an emulator may only pretend to.
  bool can_be_fetched() const { return madvise(memory_, page(), MADV_POPULATE_WRITE) == 0 && pages_in_memory() == 1; }

  static std::size_t page() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

 private:
  void* memory_;
};

TEST(Populate, FetchesAllWholePagesForTwoThreadsAndNoneForOne) {
  const FreshMemory memory;
  ASSERT_TRUE(memory.exists());
  prefault(memory.data(), large, serial_executor());
  EXPECT_EQ(memory.pages_in_memory(), 0U);
  if (!memory.can_be_fetched()) GTEST_SKIP() << "not supported on this system";
  prefault(memory.data() + 1, large - 2, test::ThreadExecutor(2));
  EXPECT_EQ(memory.pages_in_memory(), large / FreshMemory::page() - 1) << "the last page is not whole";
}

TEST(Populate, FetchesTheWholePagesOfAnyMemoryOnTheCallingThread) {
  const FreshMemory memory;
  ASSERT_TRUE(memory.exists());
  if (!memory.can_be_fetched()) GTEST_SKIP() << "not supported on this system";
  prefault(memory.data() + 1, FreshMemory::page());
  EXPECT_EQ(memory.pages_in_memory(), 1U) << "there is no whole page";
  prefault(memory.data() + 1, 3 * FreshMemory::page());
  EXPECT_EQ(memory.pages_in_memory(), 3U);
}

#endif

}  // namespace
}  // namespace graze::detail::populate_test
