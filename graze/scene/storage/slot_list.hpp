// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <graze/broad/memory/buffer.hpp>

namespace graze::detail {

/// Slots in the order in which they were added. There is room for as many as were asked for, in copies as well, so that
/// to add one cannot fail.
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

  /// Makes room for so many in all. May throw.
  void reserve(std::size_t room) {
    if (slots_.size() < room) slots_.resize(room);
  }

  /// Room for it was made before.
  void add(std::uint32_t slot) noexcept { slots_[size_++] = slot; }

  /// The last one is out.
  void drop_last() noexcept { --size_; }

  void clear() noexcept { size_ = 0; }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t i) const { return slots_[i]; }
  std::span<const std::uint32_t> all() const { return {slots_.data(), size_}; }

 private:
  PageVector<std::uint32_t> slots_;  // of which the first size_ count
  std::size_t size_ = 0;
};

}  // namespace graze::detail
