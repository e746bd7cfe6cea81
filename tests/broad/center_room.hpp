// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/bvh/build_kernels.hpp>

namespace graze::test {

/// Memory for lists of centers, with guard values before and after each that must not be overwritten.
template <Dim N, class T>
class CenterRoom {
 public:
  explicit CenterRoom(std::size_t count)
      : count_(count), at_(N * (count + 2 * guard), mark), slots_(count + 2 * guard, mark) {}

  detail::CenterLists<N, T> lists() {
    detail::CenterLists<N, T> lists;
    for (Dim i = 0; i < N; ++i) lists.at[i] = at_.data() + first(i);
    lists.slots = slots_.data() + guard;
    return lists;
  }
  void set(std::size_t k, const Vec<N, T>& center, std::uint32_t slot) {
    for (Dim i = 0; i < N; ++i) at_[first(i) + k] = center[i];
    slots_[guard + k] = slot;
  }
  Vec<N, T> center(std::size_t k) const {
    Vec<N, T> center;
    for (Dim i = 0; i < N; ++i) center[i] = at_[first(i) + k];
    return center;
  }
  std::uint32_t slot(std::size_t k) const { return slots_[guard + k]; }

  bool is_untouched_around() const {
    const auto is_mark = [](const auto& value) { return value == mark; };
    bool untouched = std::all_of(slots_.begin(), slots_.begin() + guard, is_mark) &&
                     std::all_of(slots_.end() - guard, slots_.end(), is_mark);
    for (std::size_t i = 0; i < N; ++i) {
      const auto begin = at_.begin() + static_cast<std::ptrdiff_t>(i * (count_ + 2 * guard));
      const auto end = begin + static_cast<std::ptrdiff_t>(count_ + 2 * guard);
      untouched = untouched && std::all_of(begin, begin + guard, is_mark) && std::all_of(end - guard, end, is_mark);
    }
    return untouched;
  }

 private:
  static constexpr int guard = 16;
  static constexpr std::uint32_t mark = 123'456;

  std::size_t first(Dim i) const { return static_cast<std::size_t>(i) * (count_ + 2 * guard) + guard; }

  std::size_t count_;
  std::vector<T> at_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace graze::test
