// SPDX-License-Identifier: MIT
// The pairs of a scene from update to update.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/object_index.hpp>
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
/// known of the others still holds.
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
        changed_(other.changed_),
        is_changed_(other.is_changed_) {}

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

  /// The slot's object has gone.
  void note_gone(std::uint32_t slot) noexcept;

  /// The pairs that touch, ascending, found by this plan. Throws what the executor and the memory throw; then nothing
  /// has changed.
  const std::vector<Pair>& update(const Slots& slots, const ObjectIndex<N, T>& index, const Executor& executor,
                                  PairPlan plan = PairPlan::automatic);

  /// Whether nothing was noted since the last update.
  bool is_current() const { return changed_.empty(); }

 private:
  /// What of an object is looked at before its shape.
  struct Kind {
    bool is_live = false;  ///< There is one, and it has points.
    bool is_box = false;   ///< It is a box along the axes, and nothing but that.
  };

  void set(std::uint32_t slot, const Aabb<N, T>& box, Kind kind) noexcept;
  void set_filter(std::uint32_t slot, const PairFilter& filter) noexcept;
  bool has_changed(const Pair& pair) const { return is_changed_[pair.a] || is_changed_[pair.b]; }
  bool have_all_changed() const;
  bool is_admitted(const Pair& pair) const { return choosy_ == 0 || may_touch(filters_[pair.a], filters_[pair.b]); }

  void find_anew(std::size_t slots, const Executor& executor);
  void find_around_changed(const SlotIndex<N, T>& index, const Executor& executor);
  void keep_touching(const Slots& slots, const Executor& executor);
  void merge_with_unchanged();

  std::vector<Aabb<N, T>> boxes_;    // by slot, grown as SlotIndex grows them
  std::vector<PairFilter> filters_;  // by slot
  std::vector<Kind> kinds_;          // by slot
  std::size_t live_ = 0;             // kinds that are
  std::size_t choosy_ = 0;           // filters that do not admit all
  T largest_ = 0;                    // no coordinate of a box was ever more, infinite ones aside
  std::vector<Pair> touching_;
  std::vector<Pair> found_;   // room for candidates, of which those that touch are left,
  std::vector<Pair> merged_;  // and for these and those that were known
  std::vector<std::uint32_t> changed_;
  std::vector<bool> is_changed_;  // by slot
  PairFinder<N, T> finder_;
};

extern template class PairKeeper<2, float>;
extern template class PairKeeper<3, float>;
extern template class PairKeeper<2, double>;
extern template class PairKeeper<3, double>;

}  // namespace graze::detail
