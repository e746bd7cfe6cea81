// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/memory/buffer.hpp>

namespace graze::detail::buffer_test {
namespace {

TEST(Buffer, StartsEmptyAndHoldsWhatWasAskedFor) {
  Buffer<std::uint32_t> buffer;
  EXPECT_EQ(buffer.capacity(), 0U);
  EXPECT_EQ(buffer.bytes(), 0U);
  buffer.require(10);
  EXPECT_EQ(buffer.capacity(), 10U);
  EXPECT_EQ(buffer.bytes(), 40U);
  buffer.require(3);  // capacity suffices
  EXPECT_EQ(buffer.capacity(), 10U);
}

TEST(Buffer, BeginsAtACacheLineOrALargePage) {
  Buffer<std::uint8_t> small;
  small.require(1);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.data()) % 64, 0U);
  Buffer<std::uint8_t> large;
  large.require(std::size_t{5} << 20U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % (1U << 21U), 0U);
  large[(std::size_t{5} << 20U) - 1] = 7;  // the last byte is usable
  EXPECT_EQ(large[(std::size_t{5} << 20U) - 1], 7);
}

TEST(Buffer, ExtendingKeepsTheFirstValues) {
  Buffer<int> buffer;
  buffer.require(4);
  std::iota(buffer.data(), buffer.data() + 4, 1);
  buffer.extend(5, 3);
  EXPECT_EQ(buffer.capacity(), 6U);  // half more
  EXPECT_EQ(buffer[0], 1);
  EXPECT_EQ(buffer[1], 2);
  EXPECT_EQ(buffer[2], 3);
  buffer.extend(100, 2);
  EXPECT_EQ(buffer.capacity(), 100U);
  EXPECT_EQ(buffer[1], 2);
}

TEST(Buffer, MovesWithItsMemory) {
  Buffer<int> first;
  first.require(2);
  first[0] = 42;
  const int* const memory = first.data();
  Buffer<int> second = std::move(first);
  EXPECT_EQ(second.data(), memory);
  Buffer<int> third;
  third = std::move(second);
  EXPECT_EQ(third.data(), memory);
  EXPECT_EQ(third[0], 42);
  EXPECT_EQ(third.capacity(), 2U);
}

TEST(BlankVector, KeepsWhatWasWritten) {
  BlankVector<int> numbers(3);
  std::iota(numbers.begin(), numbers.end(), 1);
  numbers.resize(1000);
  numbers.push_back(4);
  EXPECT_EQ(numbers[2], 3);
  EXPECT_EQ(numbers[1000], 4);
  const BlankVector<int> copy = numbers;
  EXPECT_EQ(copy[1], 2);
  EXPECT_EQ(copy.size(), 1001U);
  EXPECT_EQ(BlankVector<int>(5, 7).back(), 7);
}

TEST(BlankVector, BeginsAtACacheLineOrALargePage) {
  const BlankVector<std::uint8_t> small(1);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.data()) % 64, 0U);
  BlankVector<std::uint8_t> large(std::size_t{5} << 20U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % (1U << 21U), 0U);
  large.back() = 7;  // the last byte is usable
  EXPECT_EQ(large.back(), 7);
}

TEST(BlankVector, RefusesMoreThanThereIs) {
  BlankVector<double> numbers;
  EXPECT_THROW(numbers.get_allocator().allocate(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
}

TEST(PageVector, MakesWhatHasNoValueAsAnyVectorDoes) {
  PageVector<int> numbers(1000);
  EXPECT_EQ(numbers, PageVector<int>(1000, 0));
  numbers.assign(1000, 7);
  numbers.clear();
  numbers.resize(1000);
  EXPECT_EQ(numbers, PageVector<int>(1000, 0));
}

TEST(Pages, AdviceChangesNothingButTheTime) {
  std::vector<std::uint8_t> bytes(std::size_t{9} << 20U, 3);
  advise_large_pages(bytes.data() + 1, bytes.size() - 1);
  advise_large_pages(bytes.data(), 1);
  advise_large_pages(nullptr, 0);
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), std::uint8_t{3}), std::ptrdiff_t{9} << 20U);
}

}  // namespace
}  // namespace graze::detail::buffer_test
