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
        live_(other.live_),
        touching_(other.touching_),
        changed_(other.changed_),
        is_changed_(other.is_changed_) {}

  PairKeeper& operator=(const PairKeeper& other) {
    if (this != &other) *this = PairKeeper(other);
    return *this;
  }

  /// Makes room for so many slots, so that `note` cannot fail.
  void reserve(std::size_t slots);

  /// The slot's object has come, moved (then with its box) or gone (then with the box that is nothing).
  void note(std::uint32_t slot, const Aabb<N, T>& box) noexcept;

  /// The pairs that touch, ascending, found by this plan. Throws what the executor and the memory throw; then nothing
  /// has changed.
  const std::vector<Pair>& update(const Slots& slots, const ObjectIndex<N, T>& index, const Executor& executor,
                                  PairPlan plan = PairPlan::automatic);

  /// Whether nothing was noted since the last update.
  bool is_current() const { return changed_.empty(); }

 private:
  bool has_changed(const Pair& pair) const { return is_changed_[pair.a] || is_changed_[pair.b]; }

  void offer(const Slots& slots, std::uint32_t a, std::uint32_t b, std::vector<Pair>& candidates) const;
  std::vector<Pair> candidates_anew(const Slots& slots, const Executor& executor);
  std::vector<Pair> candidates_around_changed(const Slots& slots, const SlotIndex<N, T>& index,
                                              const Executor& executor) const;
  std::vector<Pair> with_unchanged(const std::vector<Pair>& found) const;

  std::vector<Aabb<N, T>> boxes_;  // by slot, grown as SlotIndex grows them
  std::size_t live_ = 0;           // boxes that are not nothing
  std::vector<Pair> touching_;
  std::vector<std::uint32_t> changed_;
  std::vector<bool> is_changed_;  // by slot
  PairFinder<N, T> finder_;
};

extern template class PairKeeper<2, float>;
extern template class PairKeeper<3, float>;
extern template class PairKeeper<2, double>;
extern template class PairKeeper<3, double>;

}  // namespace graze::detail
