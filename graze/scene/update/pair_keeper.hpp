// SPDX-License-Identifier: MIT
// The touching pairs of a scene, kept from update to update.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/pair_exceptions.hpp>
#include <graze/scene/storage/shared_slots.hpp>
#include <graze/scene/storage/slot_list.hpp>
#include <graze/scene/update/candidates.hpp>

namespace graze::detail {

/// How an update searches for candidates. The resulting pairs never depend on it.
enum class PairPlan {
  automatic,  ///< By the share of objects that have changed.
  anew,       ///< Tests all candidates in a list.
  mend,       ///< Tests the candidates of each changed object.
};

/// The touching pairs of slots, kept up to date. Only pairs with a changed object are tested again. An update consists
/// of `find`, which may fail, and `commit`, which cannot; in between, the caller does everything on its side that may
/// fail.
template <Dim N, class T>
class PairKeeper {
 public:
  using Slots = SharedSlots<Object<N, T>>;

  /// Reserves memory for this many slots, so that `note` cannot fail.
  void reserve(std::size_t slots);

  /// An object was added in the slot.
  void note_new(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// The slot's object has moved or has another shape.
  void note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// Whether the slot's object was a nonempty Aabb when it was last noted.
  bool is_box(std::uint32_t slot) const { return kinds_[slot].is_box; }

  /// A nonempty Aabb has moved, and is still one.
  void note_moved_box(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
    candidates_.move(slot, box);
    set_changed(slot, Change::moved);
  }

  /// Prefetches what is written for a slot.
  void prefetch_slot(std::uint32_t slot) const { candidates_.prefetch_slot(slot); }

  /// Whether all objects, `count` in number and all of them noted, are nonempty Aabbs.
  bool holds_nothing_but_boxes(std::size_t objects) const { return live_ == objects && others_ == 0; }

  /// Some such boxes have moved, and still are nonempty Aabbs.
  void note_moved_boxes(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept;

  /// The slot's object was removed.
  void note_gone(std::uint32_t slot) noexcept;

  /// The excepted pairs of the slot's object have changed: it is now in one, or in none.
  void note_exceptions(std::uint32_t slot, bool has_exceptions) noexcept {
    candidates_.set_exceptions(slot, has_exceptions);
    set_changed(slot, Change::moved);
  }

  /// Finds the touching pairs with this plan, without the excepted ones, and returns which of the two was used. Throws
  /// what the executor and allocation throw. Nothing visible changes before `commit`.
  PairPlan find(const Slots& slots, const Executor& executor, PairPlan plan = PairPlan::automatic,
                const PairExceptions& exceptions = {});

  /// After `mend`: the pairs that began and ended since the last update, ascending. A pair with a replaced object that
  /// touches again is in both.
  std::span<const Pair> began() const { return {began_.data(), began_.size()}; }
  std::span<const Pair> ended() const { return {ended_.data(), ended_.size()}; }

  /// After `anew`: all pairs that touch, ascending.
  std::span<const Pair> found() const { return {found_.data(), found_.size()}; }

  /// The same together with the pairs at the last update, if all candidates were tested both times and their lists are
  /// equal.
  std::optional<ListedPairs> listed() const;

  /// Takes over what was found. Nothing may be noted between `find` and this.
  void commit() noexcept;

  /// Whether nothing was noted since the last update.
  bool is_current() const { return changed_.empty(); }

 private:
  /// Properties of an object that are tested before its shape.
  struct Kind {
    bool is_live = false;  ///< There is an object with points.
    bool is_box = false;   ///< It is an Aabb.
  };

  /// The change of a slot since the last update.
  enum class Change : std::uint8_t { none, moved, replaced };

  /// A pair with a changed slot, which comes first, its number in the graph, and whether it touched.
  struct NearPair {
    Pair pair;
    std::uint32_t edge;
    bool was;
  };

  static constexpr std::uint64_t no_list = 0;

  static Kind kind_of(const Object<N, T>& object);
  void set_kind(std::uint32_t slot, Kind kind) noexcept;
  void set_changed(std::uint32_t slot, Change change) noexcept {
    if (!has_changed(slot)) changed_.add(slot);
    changes_[slot] = std::max(changes_[slot], change);
  }
  bool has_changed(std::uint32_t slot) const { return changes_[slot] != Change::none; }
  bool is_replaced(std::uint32_t slot) const { return changes_[slot] == Change::replaced; }
  bool has_changed(const Pair& pair) const { return has_changed(pair.a) || has_changed(pair.b); }
  bool is_seen_from_there(std::uint32_t slot, std::uint32_t other) const { return has_changed(other) && other < slot; }
  bool have_all_changed(std::size_t slots) const;

  void find_anew(const Slots& slots, const Executor& executor, const PairExceptions& exceptions);
  void find_around_changed(const Slots& slots, const Executor& executor, const PairExceptions& exceptions);
  void gather_near();
  void compare_with_known(const PairExceptions& exceptions);
  void judge(std::span<const Pair> pairs, const Slots& slots, const Executor& executor);
  T certain_depth() const;
  void merge_with_unchanged();
  void list_pairs();
  void keep_touching(std::span<const Pair> pairs);

  Candidates<N, T> candidates_;
  PageVector<Kind> kinds_;  // by slot
  std::size_t live_ = 0;    // number of live kinds
  std::size_t others_ = 0;  // number of live kinds other than boxes

  // The touching pairs at the last update, as a list, in the graph of candidates, or both.
  BlankVector<Pair> touching_;
  bool is_listed_ = true;

  // If the last update tested all candidates: the number of their list, or none, and which of them touched.
  std::uint64_t list_ = no_list;
  BlankVector<std::uint32_t> places_;
  BlankVector<char> touched_;

  SlotList changed_;
  PageVector<Change> changes_;  // by slot

  // The results of the current update, and reserved memory.
  PairPlan plan_ = PairPlan::mend;
  BlankVector<Pair> found_;
  std::uint64_t found_list_ = no_list;       // like list_
  BlankVector<std::uint32_t> found_places_;  // like places_
  BlankVector<char> touches_;                // by candidate
  BlankVector<Pair> merged_;
  PageVector<NearPair> near_;
  PageVector<Pair> near_pairs_;
  std::vector<Pair> began_;
  std::vector<Pair> ended_;
  std::vector<std::uint32_t> began_edges_;
  std::vector<NearPair> ended_edges_;
};

}  // namespace graze::detail
