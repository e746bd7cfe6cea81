// SPDX-License-Identifier: MIT
// Slots that can be shared with unchanging copies: writing copies only the chunk that is written to.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>

namespace graze::detail {

/// Numbered slots, each with an item or none, stored in chunks. `share` returns a copy at the cost of a pointer for
/// each chunk; afterwards the first change to a chunk on this side copies it. Shared copies are read-only: one thread
/// may change the original while others read them.
///
/// Chunks are allocated in groups, as many as exist already, up to the size of a large page, which reduces TLB misses.
/// The memory of a group is freed when none of its chunks is in use.
template <class Item>
class SharedSlots {
 public:
  SharedSlots() = default;
  SharedSlots(SharedSlots&&) noexcept = default;
  SharedSlots& operator=(SharedSlots&&) noexcept = default;
  ~SharedSlots() = default;

  /// A copy that shares nothing.
  SharedSlots(const SharedSlots& other) : size_(other.size_), is_own_(other.is_own_.size(), true) {
    add_chunks(other.chunks_.size());
    for (std::size_t k = 0; k < chunks_.size(); ++k) *chunks_[k] = *other.chunks_[k];
  }

  SharedSlots& operator=(const SharedSlots& other) {
    if (this != &other) *this = SharedSlots(other);
    return *this;
  }

  std::size_t size() const { return size_; }

  const std::optional<Item>& operator[](std::size_t slot) const {
    return (*chunks_[slot / chunk_size])[slot % chunk_size];
  }

  /// Prefetches the first bytes of a slot's content.
  template <std::size_t bytes>
  void prefetch_first_of(std::size_t slot) const {
    prefetch_first<bytes>(&(*chunks_[slot / chunk_size])[slot % chunk_size]);
  }

  /// A slot for writing. May throw std::bad_alloc, or what copying an item throws, before anything has changed.
  std::optional<Item>& change(std::size_t slot) {
    if (!is_own_[slot / chunk_size]) copy_chunk(slot / chunk_size);
    return own(slot);
  }

  /// Whether no slot is shared, so that `change` copies nothing.
  bool is_all_own() const { return foreign_ == 0; }

  /// A slot for writing that `change` was called for, and that was not shared since.
  std::optional<Item>& own(std::size_t slot) { return (*chunks_[slot / chunk_size])[slot % chunk_size]; }

  /// Makes sure that this many slots exist; new ones have no item.
  void grow(std::size_t size) {
    while (chunks_.size() * chunk_size < size) add_chunks(std::clamp<std::size_t>(chunks_.size(), 1, most_in_slab));
    if (size > size_) size_ = size;
  }

  /// A read-only copy of the current content.
  SharedSlots share() {
    SharedSlots copy;
    copy.chunks_ = chunks_;
    copy.size_ = size_;
    copy.is_own_.assign(chunks_.size(), false);
    is_own_.assign(chunks_.size(), false);
    copy.foreign_ = foreign_ = chunks_.size();
    return copy;
  }

 private:
  static constexpr std::size_t chunk_size = 64;
  using Chunk = std::array<std::optional<Item>, chunk_size>;
  using Slab = std::vector<Chunk, PageAllocator<Chunk>>;
  static constexpr std::size_t most_in_slab = (std::size_t{2} << 20U) / sizeof(Chunk);
  static_assert(most_in_slab > 0);

  /// Allocates one block of memory for each few megabytes. May throw std::bad_alloc, before anything has changed.
  void add_chunks(std::size_t count) {
    chunks_.reserve(chunks_.size() + count);
    is_own_.reserve(chunks_.size() + count);
    while (count > 0) {
      const std::size_t some = std::min(count, most_in_slab);
      const auto slab = std::make_shared<Slab>(some);
      for (Chunk& chunk : *slab) chunks_.emplace_back(slab, &chunk);
      count -= some;
    }
    is_own_.resize(chunks_.size(), true);
  }

  /// A separate function, so that `change` is short in the common case, where nothing is shared.
  [[gnu::noinline]] void copy_chunk(std::size_t number) {
    chunks_[number] = std::make_shared<Chunk>(*chunks_[number]);
    is_own_[number] = true;
    --foreign_;
  }

  std::vector<std::shared_ptr<Chunk>> chunks_;
  std::size_t size_ = 0;
  std::vector<bool> is_own_;  // by chunk: not shared
  std::size_t foreign_ = 0;   // number of shared chunks
};

}  // namespace graze::detail
