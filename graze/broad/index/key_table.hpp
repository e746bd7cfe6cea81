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

/// Which slots of an index are taken, and by which key.
class KeyTable {
 public:
  /// The generation of a slot that is never taken again: the last one that is even.
  static constexpr std::uint32_t used_up = std::numeric_limits<std::uint32_t>::max() - 1;

  /// With more than `most` slots the table is full.
  explicit KeyTable(std::uint32_t most = std::numeric_limits<std::uint32_t>::max());

  /// The key that `take` will give. After it `take` cannot fail; throws std::length_error when the table is full.
  Key prepare();

  /// Takes the slot that `prepare` named.
  Key take() noexcept;

  /// Takes as many slots as `prepare` and `take` would one after another, and writes down which. Throws
  /// std::length_error, and takes none, when there are fewer.
  void take_many(std::span<std::uint32_t> slots);

  /// The keys of slots that are taken.
  std::vector<Key> keys_of(std::span<const std::uint32_t> slots) const;

  /// Frees a slot that is taken. A slot whose generations are used up is never taken again.
  void release(std::uint32_t slot) noexcept;

  /// The same for all slots that are taken, the first one first.
  void release_all() noexcept;

  /// For a table that never held anything: it comes to be as if the keys `next`, in this order, were the next that
  /// `take` gives, and then places that are free, used from the back. Of a free one the generation is even: zero where
  /// none was ever taken, as of a place that is planned, `used_up` where none will be. Owners do not count. Throws
  /// std::logic_error when the table is not new; std::invalid_argument unless the places are the first ones, each once,
  /// and generations are odd, up to that of the last key of a place, and even.
  void plan(std::span<const Key> next, std::span<const Key> free);

  /// The places that are free, as `plan` takes them: first those that are used up. Those that were planned and are not
  /// taken yet are among them.
  std::vector<Key> free_keys() const;

  /// Whether `prepare` would throw that it is full.
  bool is_full() const { return room() == 0; }

  bool contains(const Key& key) const {
    return key.owner == owner_ && key.index < generations_.size() && (key.generation & 1U) != 0 &&
           generations_[key.index] == key.generation;
  }

  /// Of many keys, or what has an index, a generation and an owner as they have: whether it contains each. No branches.
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

  /// The slot of a key. Throws std::out_of_range, naming the key, when it names none.
  std::uint32_t slot_of(const Key& key) const;

  bool is_taken(std::uint32_t slot) const { return (generations_[slot] & 1U) != 0; }
  Key key_of(std::uint32_t slot) const { return {slot, generations_[slot], owner_}; }

  /// Asks for what key_of will read.
  void prefetch_key(std::uint32_t slot) const { prefetch(&generations_[slot]); }

  /// By slot; those of the slots that are taken are odd.
  std::span<const std::uint32_t> generations() const { return generations_; }

  /// How many slots were ever taken: all slots are below it.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(generations_.size()); }
  std::size_t size() const { return size_; }
  std::uint32_t owner() const { return owner_; }

  /// Counts changes, so that whoever visits can see that there was one. `take` and `release` count themselves.
  std::uint64_t changes() const { return changes_; }
  void count_change() { ++changes_; }

  /// The memory that is held, in bytes.
  std::size_t bytes() const { return (generations_.capacity() + free_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::size_t room() const { return free_.size() + (most_ - generations_.size()); }
  [[noreturn]] void throw_full() const;

  PageVector<std::uint32_t> generations_;  // odd: taken
  PageVector<std::uint32_t> free_;         // room for all slots, so that `release` cannot fail
  std::size_t size_ = 0;
  std::uint64_t changes_ = 0;
  std::uint32_t most_;
  std::uint32_t owner_;
};

}  // namespace detail
}  // namespace graze
