// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// No index.
inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A box and its slot.
template <Dim N, class T>
struct Entry {
  Aabb<N, T> box;
  std::uint32_t slot;
};

/// The number of entries in a block of a pool.
inline constexpr std::uint32_t entries_per_block = 8;

/// A block in memory: everything that is read together, aligned to a cache line. Unused boxes are NaN, which meets
/// nothing, so a reader need not know the count.
template <Dim N, class T>
struct alignas(64) EntryPage {
  Aabb<N, T> boxes[entries_per_block];
  std::uint32_t slots[entries_per_block];
  std::uint32_t next;  ///< The next block of the list, or of the free list.
};

template <Dim N, class T>
Aabb<N, T> no_entry() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  return {Vec<N, T>(nan), Vec<N, T>(nan)};
}

/// A list in a pool. Its first block may be partly filled; all others are full.
struct EntryList {
  std::uint32_t head = no_index;
  std::uint32_t count = 0;
};

/// A block of a list: its number and its count of entries.
struct EntryBlock {
  std::uint32_t index;
  std::uint32_t filled;

  bool is_none() const { return index == no_index; }
};

/// Lists of entries in one array: each is a chain of blocks of eight, so that entries of a list are adjacent in memory,
/// and adding and removing take constant time. Each list has a number, its owner.
template <Dim N, class T>
class EntryPool {
 public:
  static constexpr std::uint32_t block_size = entries_per_block;
  using Page = EntryPage<N, T>;

  /// Ensures this many free blocks, so that as many calls of `add` cannot fail. May throw.
  void prepare(std::size_t blocks = 1) {
    while (free_count_ < blocks) make_block();
  }

  /// Reserves memory for this many blocks, so that adding them moves nothing. May throw.
  void reserve(std::size_t blocks) {
    pages_.reserve(blocks);
    owners_.reserve(blocks);
  }

  /// The number of blocks of a list with this many entries.
  static std::size_t blocks_of(std::size_t count) { return (count + block_size - 1) / block_size; }

  /// Adds an entry to a list and returns its position, which is valid until this or another entry of the list is
  /// removed.
  std::uint32_t add(EntryList& list, std::uint32_t owner, const Entry<N, T>& entry) {
    if (list.count % block_size == 0) open_block(list, owner, 1);
    const std::uint32_t position = last_position(list.head, ++list.count);
    Page& page = pages_[position / block_size];
    page.boxes[position % block_size] = entry.box;
    page.slots[position % block_size] = entry.slot;
    return position;
  }

  /// Adds a block for `count` entries, from one to block_size, to a list that is empty or has only full blocks, and
  /// returns the position of the first. The caller must write their boxes and slots immediately.
  std::uint32_t add_block(EntryList& list, std::uint32_t owner, std::uint32_t count) {
    open_block(list, owner, count);
    list.count += count;
    return list.head * block_size;
  }
  Page& page(std::uint32_t position) { return pages_[position / block_size]; }

  /// Removes the entry at a position from its list and moves the last entry there. Returns the slot of the moved entry,
  /// or of the removed one if it was the last.
  std::uint32_t remove(EntryList& list, std::uint32_t position) {
    const std::uint32_t last = last_position(list.head, list.count);
    const std::uint32_t moved = slot(last);
    box(position) = box(last);
    pages_[position / block_size].slots[position % block_size] = moved;
    box(last) = no_entry<N, T>();
    if (--list.count % block_size == 0) close_block(list);
    return moved;
  }

  void release(EntryList& list) {
    while (list.head != no_index) close_block(list);
    list.count = 0;
  }

  /// Removes all lists and keeps the memory.
  void clear() {
    pages_.clear();
    owners_.clear();
    free_ = no_index;
    free_count_ = 0;
  }

  Aabb<N, T>& box(std::uint32_t position) { return pages_[position / block_size].boxes[position % block_size]; }
  const Aabb<N, T>& box(std::uint32_t position) const {
    return pages_[position / block_size].boxes[position % block_size];
  }
  std::uint32_t slot(std::uint32_t position) const {
    return pages_[position / block_size].slots[position % block_size];
  }

  /// All blocks, by number.
  const Page* pages() const { return pages_.data(); }

  /// Changes the owner of a list.
  void set_owner(const EntryList& list, std::uint32_t owner) {
    for (std::uint32_t block = list.head; block != no_index; block = pages_[block].next) owners_[block] = owner;
  }

  /// The owner of the list that contains the entry at a position.
  std::uint32_t owner(std::uint32_t position) const { return owners_[position / block_size]; }

  /// Calls visit(entry) for each entry of a list until it returns false. Returns false if it did.
  template <class Visit>
  bool visit(const EntryList& list, const Visit& visit) const {
    if (list.count == 0) return true;
    std::uint32_t filled = (list.count - 1) % block_size + 1;
    std::uint32_t next = no_index;
    for (std::uint32_t block = list.head; block != no_index; block = next) {
      const Page& page = pages_[block];
      next = page.next;  // visit may move entries to other lists, but pages do not move
      for (std::uint32_t k = 0; k < filled; ++k) {
        if (!visit(Entry<N, T>{page.boxes[k], page.slots[k]})) return false;
      }
      filled = block_size;
    }
    return true;
  }

  /// Calls visit(slot) for each entry whose box passes a test until it returns false. Returns false if it did. A block
  /// is tested as a whole first, because the outcome is unpredictable and a misprediction costs more than the test.
  template <class Test, class Visit>
  bool visit_where(const EntryList& list, const Test& test, const Visit& visit) const {
    if (list.count == 0) return true;
    std::uint32_t filled = (list.count - 1) % block_size + 1;
    for (std::uint32_t block = list.head; block != no_index; block = pages_[block].next) {
      const Page& page = pages_[block];
      std::array<std::uint32_t, block_size> passed;  // NOLINT(*-member-init): only what was written is read
      std::size_t count = 0;
      for (std::uint32_t k = 0; k < filled; ++k) {
        passed[count] = page.slots[k];
        count += test(page.boxes[k]) ? 1U : 0U;
      }
      for (std::size_t k = 0; k < count; ++k) {
        if (!visit(passed[k])) return false;
      }
      filled = block_size;
    }
    return true;
  }

  /// The first block of a list and its count of entries, which is 0 for an empty list.
  EntryBlock first_block(const EntryList& list) const {
    return {list.head, list.count == 0 ? 0 : (list.count - 1) % block_size + 1};
  }

  /// The block after a block.
  EntryBlock next_block(const EntryBlock& block) const { return {pages_[block.index].next, block_size}; }

  /// Writes the slots of the entries of a block whose boxes pass a test, branch-free, and returns their number. The
  /// output needs space for block_size slots. The test is also called for NaN boxes of unused entries.
  template <class Test>
  std::size_t write_where(const EntryBlock& block, const Test& test, std::uint32_t* slots) const {
    const Page& page = pages_[block.index];
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < block_size; ++k) {  // unused ones are not counted
      slots[count] = page.slots[k];
      count += static_cast<unsigned>(k < block.filled) & static_cast<unsigned>(test(page.boxes[k]));
    }
    return count;
  }

  void prefetch_block(const EntryBlock& block) const { prefetch_whole(pages_.data() + block.index); }

  template <class Use>
  void for_each(const EntryList& list, const Use& use) const {
    visit(list, [&use](const Entry<N, T>& entry) {
      use(entry);
      return true;
    });
  }

  /// The memory held, in bytes.
  std::size_t bytes() const { return pages_.capacity() * sizeof(Page) + owners_.capacity() * sizeof(std::uint32_t); }

 private:
  static std::uint32_t last_position(std::uint32_t head, std::uint32_t count) {
    return head * block_size + (count - 1) % block_size;
  }

  void make_block() {
    const auto block = static_cast<std::uint32_t>(pages_.size());
    owners_.resize(block + std::size_t{1}, no_index);
    pages_.resize(block + std::size_t{1});
    pages_.back().next = free_;
    free_ = block;
    ++free_count_;
  }

  /// Starts a new block for `count` first entries.
  void open_block(EntryList& list, std::uint32_t owner, std::uint32_t count) {
    prepare();
    const std::uint32_t block = free_;
    Page& page = pages_[block];
    free_ = page.next;
    --free_count_;
    for (std::uint32_t k = count; k < block_size; ++k) page.boxes[k] = no_entry<N, T>();
    page.next = list.head;
    owners_[block] = owner;
    list.head = block;
  }

  void close_block(EntryList& list) {
    const std::uint32_t block = list.head;
    list.head = pages_[block].next;
    pages_[block].next = free_;
    owners_[block] = no_index;
    free_ = block;
    ++free_count_;
  }

  BlankVector<Page> pages_;  // block k holds the entries from 8 k on
  // by block, in an array of its own, because moving a box reads nothing else of the block
  BlankVector<std::uint32_t> owners_;
  std::uint32_t free_ = no_index;  // the first free block
  std::size_t free_count_ = 0;
};

}  // namespace graze::detail
