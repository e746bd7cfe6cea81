// SPDX-License-Identifier: MIT
// Many slots that can be shared with copies that stay as they are: whoever writes copies only what he writes to, and
// what stands next to it.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <graze/broad/prefetch.hpp>

namespace graze::detail {

/// Slots by number, each with an item or none, in chunks. `share` gives a copy at the price of a pointer for each
/// chunk; after it, the first change to a chunk on this side copies that chunk. A copy that was shared is for reading
/// alone: one thread may change the original while others read what was shared.
template <class Item>
class SharedSlots {
 public:
  SharedSlots() = default;
  SharedSlots(SharedSlots&&) noexcept = default;
  SharedSlots& operator=(SharedSlots&&) noexcept = default;
  ~SharedSlots() = default;

  /// A copy with nothing in common.
  SharedSlots(const SharedSlots& other) : size_(other.size_), is_own_(other.is_own_.size(), true) {
    chunks_.reserve(other.chunks_.size());
    for (const auto& chunk : other.chunks_) chunks_.push_back(std::make_shared<Chunk>(*chunk));
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

  /// A slot that was to be changed before, and was not shared since.
  std::optional<Item>& own(std::size_t slot) { return (*chunks_[slot / chunk_size])[slot % chunk_size]; }

  /// Sees to it that there are so many slots, new ones without an item.
  void grow(std::size_t size) {
    while (chunks_.size() * chunk_size < size) {
      is_own_.reserve(chunks_.size() + 1);
      chunks_.push_back(std::make_shared<Chunk>());
      is_own_.push_back(true);
    }
    if (size > size_) size_ = size;
  }

  /// What is here now, for reading.
  SharedSlots share() {
    SharedSlots copy;
    copy.chunks_ = chunks_;
    copy.size_ = size_;
    copy.is_own_.assign(chunks_.size(), false);
    is_own_.assign(chunks_.size(), false);
    return copy;
  }

 private:
  static constexpr std::size_t chunk_size = 64;
  using Chunk = std::array<std::optional<Item>, chunk_size>;

  /// In a function of its own: where nothing is shared, as mostly, `change` is a few steps.
  [[gnu::noinline]] void copy_chunk(std::size_t number) {
    chunks_[number] = std::make_shared<Chunk>(*chunks_[number]);
    is_own_[number] = true;
  }

  std::vector<std::shared_ptr<Chunk>> chunks_;
  std::size_t size_ = 0;
  std::vector<bool> is_own_;  // by chunk: nobody else reads it
};

}  // namespace graze::detail
