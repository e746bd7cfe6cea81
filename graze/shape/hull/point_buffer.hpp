// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

#include <graze/shape/hull/frame.hpp>

namespace graze::detail {

/// Uninitialised memory for a stack of points. Capacity for all points is needed, but usually few are written, and the
/// system need not clear pages that are never touched; a vector would write them all.
class HullPointBuffer {
 public:
  /// Ensures the capacity for `count` points, keeping the first `kept`. Grows to at least half as much again.
  void make_room(std::size_t count, std::size_t kept) {
    if (count <= size_) return;
    const std::size_t size = std::max(count, size_ + size_ / 2);
    Memory memory(std::allocator<HullPoint>().allocate(size), Free{size});
    std::copy_n(memory_.get(), kept, memory.get());
    memory_ = std::move(memory);
    size_ = size;
  }

  HullPoint& operator[](std::size_t place) { return memory_.get()[place]; }
  const HullPoint* at(std::size_t place) const { return memory_.get() + place; }

 private:
  static_assert(std::is_trivially_copyable_v<HullPoint> && std::is_trivially_destructible_v<HullPoint>);

  struct Free {
    std::size_t size;
    void operator()(HullPoint* memory) const { std::allocator<HullPoint>().deallocate(memory, size); }
  };
  using Memory = std::unique_ptr<HullPoint, Free>;

  Memory memory_{nullptr, Free{0}};
  std::size_t size_ = 0;
};

}  // namespace graze::detail
