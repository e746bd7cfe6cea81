// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/math/platform/export.hpp>

namespace graze {

/// Identifies a box in a spatial index until the box is erased. An index detects the key of an erased box, a key of
/// another index and a default-constructed key; it never takes one for another box. A copy of an index accepts the keys
/// of the original, but cannot distinguish keys that the original returns after the copy was made from its own. Keys
/// are ordered by index.
struct Key {
  std::uint32_t index = 0;       ///< The slot of the box. Slots of erased boxes are reused.
  std::uint32_t generation = 0;  ///< Changes when the slot is reused. Odd in every valid key.
  std::uint32_t owner = 0;       ///< Differs between indexes. Has no other meaning.

  friend auto operator<=>(const Key&, const Key&) = default;
};

namespace detail {

/// Which slots of an index are occupied, and by which key.
class GRAZE_EXPORT KeyTable {
 public:
  /// The generation of a retired slot: the greatest even number.
  static constexpr std::uint32_t used_up = std::numeric_limits<std::uint32_t>::max() - 1;

  /// The table is full when it has `most` slots.
  explicit KeyTable(std::uint32_t most = std::numeric_limits<std::uint32_t>::max());

  /// The key that `take` will return. Afterwards `take` cannot fail. Throws std::length_error if the table is full.
  Key prepare();

  /// Occupies the slot of the key from `prepare`.
  Key take() noexcept;

  /// Occupies as many slots as `slots` has elements, as repeated calls of `prepare` and `take` would, and writes them
  /// there. Throws std::length_error, and occupies none, if there are fewer.
  void take_many(std::span<std::uint32_t> slots);

  /// The keys of occupied slots.
  std::vector<Key> keys_of(std::span<const std::uint32_t> slots) const;

  /// Frees an occupied slot. A slot that has used all its generations is retired.
  void release(std::uint32_t slot) noexcept;

  /// Frees all occupied slots, in ascending order.
  void release_all() noexcept;

  /// Prepares a new table to issue the keys `next`, in this order, and afterwards to use the slots in `free`, from the
  /// back. A key in `free` has an even generation: zero if the slot was never occupied, like a slot in `next`;
  /// `used_up` if it is retired. Owners are ignored. Throws std::logic_error if the table is not new;
  /// std::invalid_argument unless the slots are the first ones, each once, and the generations are odd in `next`, up to
  /// the last key of a slot, and even in `free`.
  void plan(std::span<const Key> next, std::span<const Key> free);

  /// The free slots, in the form that `plan` takes: retired ones first. Includes planned slots that are not occupied
  /// yet.
  std::vector<Key> free_keys() const;

  /// Whether `prepare` would throw because the table is full.
  bool is_full() const { return room() == 0; }

  bool contains(const Key& key) const {
    return key.owner == owner_ && key.index < generations_.size() && (key.generation & 1U) != 0 &&
           generations_[key.index] == key.generation;
  }

  /// Whether the key has been valid here, or still is.
  bool has_issued(const Key& key) const {
    return key.owner == owner_ && key.index < generations_.size() && (key.generation & 1U) != 0 &&
           key.generation <= generations_[key.index];
  }

  /// For many keys, or types with the members of one: whether the table contains each. Branch-free.
  template <class Name>
  bool contains_all(std::span<const Name> names) const {
    if (generations_.empty()) return names.empty();
    const std::uint32_t* const generations = generations_.data();
    const std::uint32_t last = slots() - 1;
    const std::uint32_t owner = owner_;
    std::uint32_t wrong = 0;
    for (const Name& name : names) {
      const std::uint32_t slot = std::min(name.index, last);
      wrong |=
          (name.owner ^ owner) | (name.index ^ slot) | (name.generation ^ generations[slot]) | (~name.generation & 1U);
    }
    return wrong == 0;
  }

  /// The slot of a key. Throws std::out_of_range, naming the key, if the key is not valid here.
  std::uint32_t slot_of(const Key& key) const;

  bool is_taken(std::uint32_t slot) const { return (generations_[slot] & 1U) != 0; }
  Key key_of(std::uint32_t slot) const { return {slot, generations_[slot], owner_}; }

  /// Prefetches what key_of reads.
  void prefetch_key(std::uint32_t slot) const { prefetch(&generations_[slot]); }

  /// By slot; odd for occupied slots.
  std::span<const std::uint32_t> generations() const { return generations_; }

  /// The number of slots ever occupied: all slots are below it.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(generations_.size()); }
  std::size_t size() const { return size_; }
  std::uint32_t owner() const { return owner_; }

  /// Counts changes, so that a visitor can detect them. `take` and `release` increment it.
  std::uint64_t changes() const { return changes_; }
  void count_change() { ++changes_; }

  /// The memory held, in bytes.
  std::size_t bytes() const { return (generations_.capacity() + free_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::size_t room() const { return free_.size() + (most_ - generations_.size()); }
  [[noreturn]] void throw_full() const;

  PageVector<std::uint32_t> generations_;  // odd: occupied
  PageVector<std::uint32_t> free_;         // with capacity for all slots, so that `release` cannot fail
  std::size_t size_ = 0;
  std::uint64_t changes_ = 0;
  std::uint32_t most_;
  std::uint32_t owner_;
};

}  // namespace detail
}  // namespace graze
