// SPDX-License-Identifier: MIT
// Many slots that can be shared with copies that stay as they are: whoever writes copies only what he writes to, and
// what stands next to it.
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

/// Slots by number, each with an item or none, in chunks. `share` gives a copy at the price of a pointer for each
/// chunk; after it, the first change to a chunk on this side copies that chunk. A copy that was shared is for reading
/// alone: one thread may change the original while others read what was shared.
///
/// Chunks are made many at a time, as many as there are already, up to what fills a large page of the system: in such
/// pages they are sooner found. What they hold together is given back when nobody has any of them.
template <class Item>
class SharedSlots {
 public:
  SharedSlots() = default;
  SharedSlots(SharedSlots&&) noexcept = default;
  SharedSlots& operator=(SharedSlots&&) noexcept = default;
  ~SharedSlots() = default;

  /// A copy with nothing in common.
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

  /// Asks for the first bytes of what a slot holds.
  template <std::size_t bytes>
  void prefetch_first_of(std::size_t slot) const {
    prefetch_first<bytes>(&(*chunks_[slot / chunk_size])[slot % chunk_size]);
  }

  /// The slot, to be changed. May throw std::bad_alloc, or what copying an item throws, before anything has changed.
  std::optional<Item>& change(std::size_t slot) {
    if (!is_own_[slot / chunk_size]) copy_chunk(slot / chunk_size);
    return own(slot);
  }

  /// Whether nobody else reads any slot, so that `change` copies nothing.
  bool is_all_own() const { return foreign_ == 0; }

  /// A slot that was to be changed before, and was not shared since.
  std::optional<Item>& own(std::size_t slot) { return (*chunks_[slot / chunk_size])[slot % chunk_size]; }

  /// Sees to it that there are so many slots, new ones without an item.
  void grow(std::size_t size) {
    while (chunks_.size() * chunk_size < size) add_chunks(std::clamp<std::size_t>(chunks_.size(), 1, most_in_slab));
    if (size > size_) size_ = size;
  }

  /// What is here now, for reading.
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

  /// Of one piece of memory for each few megabytes. May throw std::bad_alloc, before anything has changed.
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

  /// In a function of its own: where nothing is shared, as mostly, `change` is a few steps.
  [[gnu::noinline]] void copy_chunk(std::size_t number) {
    chunks_[number] = std::make_shared<Chunk>(*chunks_[number]);
    is_own_[number] = true;
    --foreign_;
  }

  std::vector<std::shared_ptr<Chunk>> chunks_;
  std::size_t size_ = 0;
  std::vector<bool> is_own_;  // by chunk: nobody else reads it
  std::size_t foreign_ = 0;   // chunks that somebody else reads
};

}  // namespace graze::detail
