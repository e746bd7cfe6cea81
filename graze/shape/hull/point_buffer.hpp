// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

#include <graze/shape/hull/frame.hpp>

namespace graze::detail {

/// Memory for points that are written before they are read. Where a stack of all points has to have room, but few come
/// to lie on it, the system need not clear the pages that none comes to: a vector would write them all.
class HullPointBuffer {
 public:
  /// Room for at least so many, the first `kept` of which stay what they are. Where there was too little there is then
  /// half as much again.
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
