// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/broad/prefetch.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Takes the place of an index where there is none.
inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A box in the slot of its key.
template <Dim N, class T>
struct Entry {
  Aabb<N, T> box;
  std::uint32_t slot;
};

/// A list in a pool. Its first block may be partly filled, all others are full.
struct EntryList {
  std::uint32_t head = no_index;
  std::uint32_t count = 0;
};

/// A block of a list: where it is, and how many of its places are filled.
struct EntryBlock {
  std::uint32_t index;
  std::uint32_t filled;

  bool is_none() const { return index == no_index; }
};

/// Lists of entries in one array: each is a chain of blocks of eight, so that entries of a list lie side by side, and
/// adding and removing cost the same however long it is. Each list has a number, its owner.
template <Dim N, class T>
class EntryPool {
 public:
  static constexpr std::uint32_t block_size = 8;

  /// Sees to so many free blocks: as many calls of `add` cannot fail, more if they share blocks. May throw.
  void prepare(std::size_t blocks = 1) {
    while (free_count_ < blocks) add_block();
  }

  /// Makes room for so many blocks, so that adding them moves nothing. May throw.
  void reserve(std::size_t blocks) {
    entries_.reserve(blocks * block_size);
    blocks_.reserve(blocks);
  }

  /// How many blocks a list of so many entries fills.
  static std::size_t blocks_of(std::size_t count) { return (count + block_size - 1) / block_size; }

  /// Adds an entry to a list and gives its position, which it keeps until it, or another entry of its list, is removed.
  std::uint32_t add(EntryList& list, std::uint32_t owner, const Entry<N, T>& entry) {
    if (list.count % block_size == 0) open_block(list, owner);
    const std::uint32_t position = last_position(list.head, ++list.count);
    entries_[position] = entry;
    return position;
  }

  /// Takes the entry at a position out of its list and puts the last one in its place. Returns the slot of that one,
  /// which is the removed one's own if it was last.
  std::uint32_t remove(EntryList& list, std::uint32_t position) {
    const std::uint32_t last = last_position(list.head, list.count);
    entries_[position] = entries_[last];
    if (--list.count % block_size == 0) close_block(list);
    return entries_[position].slot;
  }

  /// Removes all entries of a list.
  void release(EntryList& list) {
    while (list.head != no_index) close_block(list);
    list.count = 0;
  }

  /// Forgets all lists and keeps the memory.
  void clear() {
    entries_.clear();
    blocks_.clear();
    free_ = no_index;
    free_count_ = 0;
  }

  Entry<N, T>& operator[](std::uint32_t position) { return entries_[position]; }
  const Entry<N, T>& operator[](std::uint32_t position) const { return entries_[position]; }

  /// Gives a list another number.
  void set_owner(const EntryList& list, std::uint32_t owner) {
    for (std::uint32_t block = list.head; block != no_index; block = blocks_[block].next) blocks_[block].owner = owner;
  }

  /// The number of the list that holds the entry at a position.
  std::uint32_t owner(std::uint32_t position) const { return blocks_[position / block_size].owner; }

  /// Calls visit(entry) for each entry of a list until it returns false. Returns whether it never did.
  template <class Visit>
  bool visit(const EntryList& list, const Visit& visit) const {
    if (list.count == 0) return true;
    std::uint32_t filled = (list.count - 1) % block_size + 1;
    for (std::uint32_t block = list.head; block != no_index; block = blocks_[block].next) {
      const std::uint32_t first = block * block_size;
      for (std::uint32_t position = first; position < first + filled; ++position) {
        if (!visit(entries_[position])) return false;
      }
      filled = block_size;
    }
    return true;
  }

  /// Calls visit(slot) for each entry whose box passes a test until it returns false. Returns whether it never did. A
  /// block is tested as a whole first: which boxes pass is hard to predict, and a wrong guess costs more than the test.
  template <class Test, class Visit>
  bool visit_where(const EntryList& list, const Test& test, const Visit& visit) const {
    if (list.count == 0) return true;
    std::uint32_t filled = (list.count - 1) % block_size + 1;
    for (std::uint32_t block = list.head; block != no_index; block = blocks_[block].next) {
      const Entry<N, T>* const first = entries_.data() + std::size_t{block} * block_size;
      std::array<std::uint32_t, block_size> passed;  // NOLINT(*-member-init): only what was written is read
      std::size_t count = 0;
      for (std::uint32_t k = 0; k < filled; ++k) {
        passed[count] = first[k].slot;
        count += test(first[k].box) ? 1U : 0U;
      }
      for (std::size_t k = 0; k < count; ++k) {
        if (!visit(passed[k])) return false;
      }
      filled = block_size;
    }
    return true;
  }

  /// The first block of a list, with the number of its entries. A list without entries has none.
  EntryBlock first_block(const EntryList& list) const {
    return {list.head, list.count == 0 ? 0 : (list.count - 1) % block_size + 1};
  }

  /// The one behind a block.
  EntryBlock next_block(const EntryBlock& block) const { return {blocks_[block.index].next, block_size}; }

  /// Writes the slots of those entries of a block whose boxes pass a test, without a branch on it, and returns how many
  /// they are. There must be room for block_size slots.
  template <class Test>
  std::size_t write_where(const EntryBlock& block, const Test& test, std::uint32_t* slots) const {
    const Entry<N, T>* const first = entries_.data() + std::size_t{block.index} * block_size;
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < block_size; ++k) {  // those that are no more are not counted
      slots[count] = first[k].slot;
      count += static_cast<unsigned>(k < block.filled) & static_cast<unsigned>(test(first[k].box));
    }
    return count;
  }

  /// Asks for a block.
  void prefetch_block(const EntryBlock& block) const {
    prefetch_all(std::span(entries_.data() + std::size_t{block.index} * block_size, block_size));
  }

  template <class Use>
  void for_each(const EntryList& list, const Use& use) const {
    visit(list, [&use](const Entry<N, T>& entry) {
      use(entry);
      return true;
    });
  }

  /// The memory that is held, in bytes.
  std::size_t bytes() const { return entries_.capacity() * sizeof(Entry<N, T>) + blocks_.capacity() * sizeof(Block); }

 private:
  struct Block {
    std::uint32_t next = no_index;
    std::uint32_t owner = no_index;
  };

  static std::uint32_t last_position(std::uint32_t head, std::uint32_t count) {
    return head * block_size + (count - 1) % block_size;
  }

  void add_block() {
    const auto block = static_cast<std::uint32_t>(blocks_.size());
    entries_.resize((blocks_.size() + 1) * block_size);
    blocks_.push_back({free_, no_index});
    free_ = block;
    ++free_count_;
  }

  void open_block(EntryList& list, std::uint32_t owner) {
    prepare();
    const std::uint32_t block = free_;
    free_ = blocks_[block].next;
    --free_count_;
    blocks_[block] = {list.head, owner};
    list.head = block;
  }

  void close_block(EntryList& list) {
    const std::uint32_t block = list.head;
    list.head = blocks_[block].next;
    blocks_[block] = {free_, no_index};
    free_ = block;
    ++free_count_;
  }

  std::vector<Entry<N, T>> entries_;  // block k holds the entries from 8 k on
  std::vector<Block> blocks_;
  std::uint32_t free_ = no_index;  // a chain, too
  std::size_t free_count_ = 0;
};

}  // namespace graze::detail
