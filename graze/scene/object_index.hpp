// SPDX-License-Identifier: MIT
// Where the objects of a scene are: a spatial index that catches up with what has moved when it is asked.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <graze/broad/orthtree.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/shared_slots.hpp>

namespace graze::detail {

/// A spatial index by the slots of objects instead of keys: an Orthtree, in which boxes move a little sooner than in a
/// Bvh, though that one answers sooner (bench/bvh.cpp). Each box is grown by what `relation` may
/// forgive, so that no object is missed that an exact test would find.
template <Dim N, class T>
class SlotIndex {
 public:
  using Tree = Orthtree<N, T>;

  const Tree& tree() const { return tree_; }

  std::uint32_t slot_of(const Key& key) const { return slots_[key.index]; }

  /// Takes over what the slot holds: a new object, a moved one, or none. What has no points is in no index.
  void set(std::uint32_t slot, const std::optional<Object<N, T>>& object) {
    if (slot >= keys_.size()) keys_.resize(slot + 1);
    Key& key = keys_[slot];
    const bool is_held = key != Key{};
    if (!object || is_nothing(object->box)) {
      if (is_held) tree_.erase(std::exchange(key, Key{}));
      return;
    }
    const Aabb<N, T> box = touching_bounds(object->box);
    if (is_held) {
      tree_.update(key, box);
      return;
    }
    if (slots_.size() <= tree_.size()) slots_.resize(2 * tree_.size() + 16);
    key = tree_.insert(box);
    slots_[key.index] = slot;
  }

 private:
  Tree tree_;
  std::vector<Key> keys_;             // by slot; the default one where the slot holds nothing
  std::vector<std::uint32_t> slots_;  // by the index of the key
};

/// A SlotIndex and what it does not know yet. Reading is safe from many threads at once, the first of which catches up;
/// `note` and `share` are for one thread while none reads.
template <Dim N, class T>
class ObjectIndex {
 public:
  using Slots = SharedSlots<Object<N, T>>;

  ObjectIndex() = default;
  ObjectIndex(const ObjectIndex& other) { *this = other; }
  ObjectIndex(ObjectIndex&& other) noexcept { *this = std::move(other); }

  ObjectIndex& operator=(const ObjectIndex& other) {
    if (this == &other) return *this;
    const std::lock_guard<std::mutex> lock(other.catching_up_);
    index_ = other.index_ ? std::make_shared<SlotIndex<N, T>>(*other.index_) : nullptr;
    is_shared_ = false;
    pending_ = other.pending_;
    is_pending_ = other.is_pending_;
    is_current_.store(index_ != nullptr && pending_.empty(), std::memory_order_relaxed);
    return *this;
  }

  ObjectIndex& operator=(ObjectIndex&& other) noexcept {
    index_ = std::move(other.index_);
    is_shared_ = other.is_shared_;
    pending_ = std::move(other.pending_);
    is_pending_ = std::move(other.is_pending_);
    is_current_.store(index_ != nullptr && pending_.empty(), std::memory_order_relaxed);
    other.is_current_.store(false, std::memory_order_relaxed);
    return *this;
  }

  ~ObjectIndex() = default;

  /// Makes room for so many slots, so that `note` cannot fail.
  void reserve(std::size_t slots) {
    if (is_pending_.size() >= slots) return;
    pending_.reserve(2 * slots);
    is_pending_.resize(2 * slots, false);
  }

  /// The slot's object has come, moved or gone.
  void note(std::uint32_t slot) noexcept {
    if (is_pending_[slot]) return;
    is_pending_[slot] = true;
    pending_.push_back(slot);
    is_current_.store(false, std::memory_order_relaxed);
  }

  /// The index of what the slots hold now.
  const SlotIndex<N, T>& over(const Slots& slots) const {
    if (!is_current_.load(std::memory_order_acquire)) catch_up(slots);
    return *index_;
  }

  /// The index as it is now, for reading; this one goes on with a copy when something has moved.
  ObjectIndex share(const Slots& slots) {
    over(slots);
    is_shared_ = true;
    ObjectIndex copy;
    copy.index_ = index_;
    copy.is_shared_ = true;
    copy.is_current_.store(true, std::memory_order_relaxed);
    return copy;
  }

 private:
  void catch_up(const Slots& slots) const {
    const std::lock_guard<std::mutex> lock(catching_up_);
    if (is_current_.load(std::memory_order_relaxed)) return;
    if (!index_) {
      index_ = std::make_shared<SlotIndex<N, T>>();
    } else if (is_shared_) {
      index_ = std::make_shared<SlotIndex<N, T>>(*index_);
    }
    is_shared_ = false;
    while (!pending_.empty()) {
      index_->set(pending_.back(), slots[pending_.back()]);
      is_pending_[pending_.back()] = false;
      pending_.pop_back();
    }
    is_current_.store(true, std::memory_order_release);
  }

  mutable std::mutex catching_up_;
  mutable std::atomic<bool> is_current_ = false;
  mutable std::shared_ptr<SlotIndex<N, T>> index_;
  mutable bool is_shared_ = false;
  mutable std::vector<std::uint32_t> pending_;
  mutable std::vector<bool> is_pending_;  // by slot
};

}  // namespace graze::detail
