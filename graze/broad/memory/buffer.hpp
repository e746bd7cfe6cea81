// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/platform/throw.hpp>

namespace graze::detail {

/// Memory aligned to a cache line, which is also the widest vector; large blocks to a large page of the system, if it
/// has such. Throws std::bad_alloc. Released blocks of 32 KiB or more are kept for later requests, up to a total of 64
/// MiB, or half of what is in use if that is more.
GRAZE_EXPORT void* allocate_pages(std::size_t bytes);
GRAZE_EXPORT void release_pages(void* memory, std::size_t bytes) noexcept;

/// Advises the system to use large pages for the whole ones inside memory that has not been written yet. Does nothing
/// for less, or if the system has none.
GRAZE_EXPORT void advise_large_pages(void* memory, std::size_t bytes) noexcept;

/// Reserves capacity for this many values in an empty vector, with large pages if that is much.
template <class Value>
void reserve_in_large_pages(std::vector<Value>& values, std::size_t count) {
  if (count <= values.capacity()) return;
  values.reserve(count);
  advise_large_pages(values.data(), values.capacity() * sizeof(Value));
}

/// For vectors that may become long: memory from allocate_pages.
template <class Value>
struct PageAllocator : std::allocator<Value> {
  template <class Other>
  struct rebind {  // NOLINT(readability-identifier-naming): as std::allocator_traits names it
    using other = PageAllocator<Other>;
  };

  Value* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(Value)) GRAZE_THROW(std::bad_alloc());
    return static_cast<Value*>(allocate_pages(count * sizeof(Value)));
  }
  void deallocate(Value* values, std::size_t count) noexcept { release_pages(values, count * sizeof(Value)); }
};

template <class Value>
using PageVector = std::vector<Value, PageAllocator<Value>>;

/// The same for values that are written before they are read: default-inserted values are not initialised.
template <class Value>
struct BlankAllocator : PageAllocator<Value> {
  template <class Other>
  struct rebind {  // NOLINT(readability-identifier-naming): as std::allocator_traits names it
    using other = BlankAllocator<Other>;
  };

  template <class Made>
  void construct(Made* /*place*/) noexcept {
    static_assert(std::is_trivially_copyable_v<Made> && std::is_trivially_destructible_v<Made>);
  }
  template <class Made, class... Arguments>
  void construct(Made* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

template <class Value>
using BlankVector = std::vector<Value, BlankAllocator<Value>>;

/// Memory for values that are written before they are read: nothing is initialised, and growing keeps only what is
/// requested.
template <class Value>
class Buffer {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  Buffer() = default;
  Buffer(Buffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~Buffer() { release(); }

  /// Ensures capacity for `count` values; the content is lost if the memory has to grow.
  void require(std::size_t count) {
    if (count <= capacity_) return;
    release();
    data_ = allocate(count);
    capacity_ = count;
  }

  /// Ensures capacity for `count` values, growing by at least half; keeps the first `kept` values.
  void extend(std::size_t count, std::size_t kept) {
    if (count <= capacity_) return;
    Buffer larger;
    const std::size_t half_more = capacity_ + capacity_ / 2;
    larger.require(count > half_more ? count : half_more);
    if (kept > 0) std::memcpy(static_cast<void*>(larger.data_), data_, kept * sizeof(Value));
    *this = std::move(larger);
  }

  Value* data() { return data_; }
  const Value* data() const { return data_; }
  Value& operator[](std::size_t i) { return data_[i]; }
  const Value& operator[](std::size_t i) const { return data_[i]; }

  std::size_t capacity() const { return capacity_; }
  std::size_t bytes() const { return capacity_ * sizeof(Value); }

 private:
  static Value* allocate(std::size_t count) { return static_cast<Value*>(allocate_pages(count * sizeof(Value))); }
  void release() {
    if (data_ != nullptr) release_pages(data_, bytes());
    data_ = nullptr;
    capacity_ = 0;
  }

  Value* data_ = nullptr;
  std::size_t capacity_ = 0;
};

}  // namespace graze::detail
