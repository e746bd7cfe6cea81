// SPDX-License-Identifier: MIT
// The pairs of a scene from update to update.
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
#include <graze/scene/storage/shared_slots.hpp>
#include <graze/scene/storage/slot_list.hpp>
#include <graze/scene/update/candidates.hpp>

namespace graze::detail {

/// How an update looks for candidates. The pairs never depend on it.
enum class PairPlan {
  automatic,  ///< By the share of objects that have changed.
  anew,       ///< A list of all candidates is gone through.
  mend,       ///< Each changed object looks at its own candidates.
};

/// The touching pairs of slots, kept up to date. Exact tests are made for pairs of which one has changed; what was
/// known of the others still holds. An update is `find`, which may fail, and `commit`, which cannot; in between the
/// caller does what may fail on his side.
template <Dim N, class T>
class PairKeeper {
 public:
  using Slots = SharedSlots<Object<N, T>>;

  /// Makes room for so many slots, so that `note` cannot fail.
  void reserve(std::size_t slots);

  /// An object has come into the slot.
  void note_new(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// The slot's object has moved, or has another shape.
  void note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// Whether the slot's object was a box along the axes that has points when it was noted last.
  bool is_box(std::uint32_t slot) const { return kinds_[slot].is_box; }

  /// What is such a box has moved, and still is.
  void note_moved_box(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
    candidates_.move(slot, box);
    set_changed(slot, Change::moved);
  }

  /// Asks for what is written of a slot.
  void prefetch_slot(std::uint32_t slot) const { candidates_.prefetch_slot(slot); }

  /// Whether each of so many objects, which are all that were noted, was a box along the axes with points in it.
  bool holds_nothing_but_boxes(std::size_t objects) const { return live_ == objects && others_ == 0; }

  /// Some of such boxes have moved, and still are.
  void note_moved_boxes(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept;

  /// The slot's object has gone.
  void note_gone(std::uint32_t slot) noexcept;

  /// Finds what touches now by this plan, and returns which of the two it was. Throws what the executor and the memory
  /// throw. Until `commit` nothing has changed that can be seen.
  PairPlan find(const Slots& slots, const Executor& executor, PairPlan plan = PairPlan::automatic);

  /// After `mend`: the pairs that have begun and ended since the last update, ascending. One of which a slot has
  /// another object now is in both if those in it touch as well.
  std::span<const Pair> began() const { return {began_.data(), began_.size()}; }
  std::span<const Pair> ended() const { return {ended_.data(), ended_.size()}; }

  /// After `anew`: all pairs that touch, ascending.
  std::span<const Pair> found() const { return {found_.data(), found_.size()}; }

  /// The same beside what touched at the last update, where all candidates were gone through then and now, and are the
  /// same.
  std::optional<ListedPairs> listed() const;

  /// Takes over what was found. Between this and `find` nothing may be noted.
  void commit() noexcept;

  /// Whether nothing was noted since the last update.
  bool is_current() const { return changed_.empty(); }

 private:
  /// What of an object is looked at before its shape.
  struct Kind {
    bool is_live = false;  ///< There is one, and it has points.
    bool is_box = false;   ///< It is a box along the axes, and nothing but that.
  };

  /// What became of a slot since the last update.
  enum class Change : std::uint8_t { none, moved, replaced };

  /// A pair of which one has changed, that one first, its number in the graph, and whether it touched.
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

  void find_anew(const Slots& slots, const Executor& executor);
  void find_around_changed(const Slots& slots, const Executor& executor);
  void gather_near();
  void compare_with_known();
  void judge(std::span<const Pair> pairs, const Slots& slots, const Executor& executor);
  T certain_depth() const;
  void merge_with_unchanged();
  void list_pairs();
  void keep_touching(std::span<const Pair> pairs);

  Candidates<N, T> candidates_;
  PageVector<Kind> kinds_;  // by slot
  std::size_t live_ = 0;    // kinds that are
  std::size_t others_ = 0;  // and are no boxes

  // What touched at the last update, as a list, or as the graph of candidates has it, or both.
  BlankVector<Pair> touching_;
  bool is_listed_ = true;

  // Where the last update has gone through all candidates: the number of their list, or none, and what of it touched.
  std::uint64_t list_ = no_list;
  BlankVector<std::uint32_t> places_;
  BlankVector<char> touched_;

  SlotList changed_;
  PageVector<Change> changes_;  // by slot

  // What the present update has found, and room for it.
  PairPlan plan_ = PairPlan::mend;
  BlankVector<Pair> found_;
  std::uint64_t found_list_ = no_list;       // as list_
  BlankVector<std::uint32_t> found_places_;  // as places_
  BlankVector<char> touches_;                // by candidate
  BlankVector<Pair> merged_;
  PageVector<NearPair> near_;
  PageVector<Pair> near_pairs_;
  std::vector<Pair> began_;
  std::vector<Pair> ended_;
  std::vector<std::uint32_t> began_edges_;
  std::vector<NearPair> ended_edges_;
};

extern template class PairKeeper<2, float>;
extern template class PairKeeper<3, float>;
extern template class PairKeeper<2, double>;
extern template class PairKeeper<3, double>;

}  // namespace graze::detail
