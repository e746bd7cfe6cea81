// SPDX-License-Identifier: MIT
#include "memory_floor.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>

namespace graze::cli {
namespace {

/// The exclusive or of all bytes in eight lanes, which compilers vectorise.
std::uint64_t fold(std::span<const std::byte> bytes) {
  std::array<std::uint64_t, 8> lanes{};
  while (bytes.size() >= sizeof lanes) {
    std::array<std::uint64_t, 8> words;
    std::memcpy(words.data(), bytes.data(), sizeof words);
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] ^= words[i];
    bytes = bytes.subspan(sizeof lanes);
  }
  std::uint64_t result = bytes.size();
  for (const std::uint64_t lane : lanes) result ^= lane;
  return result;
}

}  // namespace

double MemoryFloor::measure(std::span<const std::byte> boxes, std::size_t pairs) {
  pairs_.resize(std::max(pairs_.size(), pairs));
  std::array<double, 5> milliseconds{};
  for (double& time : milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    const auto value = static_cast<std::uint32_t>(fold(boxes));
    std::fill_n(pairs_.begin(), pairs, Pair{value, value});
    time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    // Used, so that neither loop is optimised away.
    const volatile std::uint32_t seen = pairs == 0 ? value : pairs_[value % pairs].a;
    static_cast<void>(seen);
  }
  std::nth_element(milliseconds.begin(), milliseconds.begin() + 2, milliseconds.end());
  return milliseconds[2];
}

}  // namespace graze::cli
