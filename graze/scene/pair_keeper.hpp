// SPDX-License-Identifier: MIT
// The pairs of a scene from update to update.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/object_index.hpp>
#include <graze/scene/pair_graph.hpp>
#include <graze/scene/shared_slots.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// How an update looks for candidates. The pairs never depend on it.
enum class PairPlan {
  automatic,  ///< By the share of objects that have changed.
  anew,       ///< All boxes at once by the batch method.
  mend,       ///< Each changed object asks the index for its neighbours.
};

/// The touching pairs of slots, kept up to date. Exact tests are made for pairs of which one has changed; what was
/// known of the others still holds. An update is `find`, which may fail, and `commit`, which cannot; in between the
/// caller does what may fail on his side.
template <Dim N, class T>
class PairKeeper {
 public:
  using Slots = SharedSlots<Object<N, T>>;

  PairKeeper() = default;
  PairKeeper(PairKeeper&&) noexcept = default;
  PairKeeper& operator=(PairKeeper&&) noexcept = default;
  ~PairKeeper() = default;

  /// A copy knows the same, but has to find out again where the boxes lie.
  PairKeeper(const PairKeeper& other)
      : boxes_(other.boxes_),
        filters_(other.filters_),
        kinds_(other.kinds_),
        live_(other.live_),
        choosy_(other.choosy_),
        largest_(other.largest_),
        touching_(other.touching_),
        graph_(other.graph_),
        is_listed_(other.is_listed_),
        is_linked_(other.is_linked_),
        changed_(other.changed_),
        changes_(other.changes_) {}

  PairKeeper& operator=(const PairKeeper& other) {
    if (this != &other) *this = PairKeeper(other);
    return *this;
  }

  /// Makes room for so many slots, so that `note` cannot fail.
  void reserve(std::size_t slots);

  /// An object has come into the slot.
  void note_new(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// The slot's object has moved, or has another shape.
  void note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept;

  /// Asks for what is written of a slot.
  void prefetch_slot(std::uint32_t slot) const { prefetch(&boxes_[slot]); }

  /// The slot's object has gone.
  void note_gone(std::uint32_t slot) noexcept;

  /// Finds what touches now by this plan, and returns which of the two it was. Throws what the executor and the memory
  /// throw. Until `commit` nothing has changed that can be seen.
  PairPlan find(const Slots& slots, const ObjectIndex<N, T>& index, const Executor& executor,
                PairPlan plan = PairPlan::automatic);

  /// After `mend`: the pairs that have begun and ended since the last update, ascending. One of which a slot has
  /// another object now is in both if those in it touch as well.
  std::span<const Pair> began() const { return {began_.data(), began_.size()}; }
  std::span<const Pair> ended() const { return {ended_.data(), ended_.size()}; }

  /// After `anew`: all pairs that touch, ascending.
  std::span<const Pair> found() const { return {found_.data(), found_.size()}; }

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

  static Kind kind_of(const Object<N, T>& object);
  void set(std::uint32_t slot, const Aabb<N, T>& box, Kind kind, Change change) noexcept;
  void set_filter(std::uint32_t slot, const PairFilter& filter) noexcept;
  bool has_changed(std::uint32_t slot) const { return changes_[slot] != Change::none; }
  bool is_replaced(std::uint32_t slot) const { return changes_[slot] == Change::replaced; }
  bool has_changed(const Pair& pair) const { return has_changed(pair.a) || has_changed(pair.b); }
  bool is_seen_from_there(std::uint32_t slot, std::uint32_t other) const { return has_changed(other) && other < slot; }
  bool have_all_changed() const;
  bool is_admitted(const Pair& pair) const { return choosy_ == 0 || may_touch(filters_[pair.a], filters_[pair.b]); }

  void find_anew(std::size_t slots, const Executor& executor);
  void find_around_changed(const SlotIndex<N, T>& index, const Executor& executor);
  void keep_touching(const Slots& slots, const Executor& executor);
  void merge_with_unchanged();
  void list_pairs();
  void link_pairs();
  void compare_with_known();

  std::vector<Aabb<N, T>> boxes_;    // by slot, grown as SlotIndex grows them
  std::vector<PairFilter> filters_;  // by slot
  std::vector<Kind> kinds_;          // by slot
  std::size_t live_ = 0;             // kinds that are
  std::size_t choosy_ = 0;           // filters that do not admit all
  T largest_ = 0;                    // no coordinate of a box not yet grown was ever more, infinite ones aside

  // What touched at the last update, as a list, as a graph, or as both.
  std::vector<Pair> touching_;
  PairGraph graph_;
  bool is_listed_ = true;
  bool is_linked_ = false;

  std::vector<std::uint32_t> changed_;
  std::vector<Change> changes_;  // by slot

  // What the present update has found, and room for it.
  PairPlan plan_ = PairPlan::mend;
  std::vector<Pair> found_;  // candidates, of which those that touch are left
  std::vector<Pair> merged_;
  std::vector<Pair> began_;
  std::vector<Pair> ended_;
  std::vector<std::uint32_t> ended_edges_;
  std::vector<std::uint32_t> marks_;  // by slot: the last one that knew it as touching
  std::uint32_t mark_ = 0;            // of whom
  PairFinder<N, T> finder_;
};

extern template class PairKeeper<2, float>;
extern template class PairKeeper<3, float>;
extern template class PairKeeper<2, double>;
extern template class PairKeeper<3, double>;

}  // namespace graze::detail
