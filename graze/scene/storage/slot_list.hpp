// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <graze/broad/memory/buffer.hpp>

namespace graze::detail {

/// Slots in the order in which they were added. Memory is reserved in advance, in copies too, so that adding one cannot
/// fail.
class SlotList {
 public:
  SlotList() = default;
  SlotList(const SlotList&) = default;
  SlotList& operator=(const SlotList&) = default;
  SlotList(SlotList&& other) noexcept : slots_(std::exchange(other.slots_, {})), size_(std::exchange(other.size_, 0)) {}
  SlotList& operator=(SlotList&& other) noexcept {
    slots_ = std::exchange(other.slots_, {});
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  ~SlotList() = default;

  /// Reserves memory for this many in total. May throw.
  void reserve(std::size_t room) {
    if (slots_.size() < room) slots_.resize(room);
  }

  /// Requires reserved memory.
  void add(std::uint32_t slot) noexcept { slots_[size_++] = slot; }

  /// Removes the last one.
  void drop_last() noexcept { --size_; }

  void clear() noexcept { size_ = 0; }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t i) const { return slots_[i]; }
  std::span<const std::uint32_t> all() const { return {slots_.data(), size_}; }

 private:
  PageVector<std::uint32_t> slots_;  // only the first size_ are in use
  std::size_t size_ = 0;
};

}  // namespace graze::detail
