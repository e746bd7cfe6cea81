// SPDX-License-Identifier: MIT
// A spatial index of a scene's objects that takes over changes when it is queried.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/shared_slots.hpp>
#include <graze/scene/storage/slot_list.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// The tree of a Bvh by the slots of objects, without keys. Each box is enlarged by the tolerance of `relation`, so
/// that no object is missed that an exact test would find.
template <Dim N, class T>
class SlotIndex {
 public:
  /// The number of slots whose object contains points.
  std::size_t size() const { return size_; }

  /// Takes over the content of a slot: a new, moved or removed object. Objects without points are not in the index.
  void set(std::uint32_t slot, const std::optional<Object<N, T>>& object) {
    if (slot >= is_held_.size()) is_held_.resize(slot + std::size_t{1}, false);
    const bool has_points = object && !is_nothing(object->box);
    if (is_held_[slot]) {
      if (has_points) return tree_.update(slot, touching_bounds(*object));
      tree_.erase(slot);
      --size_;
    } else {
      if (!has_points) return;
      tree_.insert(slot, touching_bounds(*object));
      ++size_;
    }
    is_held_[slot] = has_points;
  }

  /// Prefetches what `set` will read of a slot: first its position in the tree and, once that is cached, its node.
  void prefetch_place(std::uint32_t slot) const {
    if (slot < is_held_.size() && is_held_[slot]) tree_.prefetch_place(slot);
  }
  void prefetch_node(std::uint32_t slot) const {
    if (slot < is_held_.size() && is_held_[slot]) tree_.prefetch_node(slot);
  }

  /// Fills an empty index with all slots: faster than one by one, and gives a better tree.
  void fill(const SharedSlots<Object<N, T>>& slots) {
    std::vector<Aabb<N, T>> boxes;
    std::vector<std::uint32_t> places;
    boxes.reserve(slots.size());
    places.reserve(slots.size());
    is_held_.resize(slots.size(), false);
    for (std::uint32_t slot = 0; slot < slots.size(); ++slot) {
      const std::optional<Object<N, T>>& object = slots[slot];
      if (!object || is_nothing(object->box)) continue;
      boxes.push_back(touching_bounds(*object));
      places.push_back(slot);
      is_held_[slot] = true;
    }
    tree_.fill(boxes, places, serial_executor());
    size_ = places.size();
  }

  /// Calls visit(slot) for every box that meets the region, until it returns false; it may return nothing.
  template <RegionIn<N, T> R, VisitorOf<std::uint32_t> Visit>
  void query(const R& region, Visit&& visit) const {
    visit_met(tree_, RegionProbe<R>(region), [&visit](const BvhName& name) {
      if constexpr (std::is_void_v<std::invoke_result_t<Visit&, std::uint32_t>>) {
        visit(name.slot);
        return true;
      } else {
        return visit(name.slot);
      }
    });
  }

  /// Calls visit(slot, t) for every box that the ray enters, by t, ties by slot, until it returns false.
  template <class Visit>
  void ray_cast(const Ray<N, T>& ray, const Visit& visit) const {
    visit_along(tree_, ray, [&visit](const BvhName& name, double t) { return visit(name.slot, t); });
  }

  /// Calls visit(slot) for every box that a moving box may touch, by SweptBox::entry, ties by slot. What it returns is
  /// the t up to which it is interested in further boxes.
  template <class Visit>
  void visit_swept(const SweptBox<N>& sweep, const Visit& visit) const {
    graze::detail::visit_swept(
        tree_, sweep, [&sweep](const Aabb<N, T>& box) { return sweep.entry(box); },
        [&visit](const BvhName& name, double) { return visit(name.slot); });
  }

  /// The k boxes nearest to a box, which may be a point, or all if there are fewer; the index of each key is the slot.
  std::vector<Neighbour> nearest(const Aabb<N, T>& from, std::size_t k) const {
    if (k == 0 || size_ == 0) return {};
    NearestKeys nearest(std::min(k, size_));
    find_near(tree_, from, nearest);
    return nearest.sorted();
  }

 private:
  BvhTree<N, T> tree_{0};
  std::vector<bool> is_held_;  // by slot
  std::size_t size_ = 0;
};

/// A SlotIndex and a list of changes that it does not contain yet. Reading is thread-safe, and the first reader applies
/// the changes; `note` and `share` need exclusive access.
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

  /// Reserves memory for this many slots, so that `note` cannot fail.
  void reserve(std::size_t slots) {
    if (is_pending_.size() >= slots) return;
    pending_.reserve(2 * slots);
    is_pending_.resize(2 * slots, false);
  }

  /// The slot's object was added, moved or removed.
  void note(std::uint32_t slot) noexcept {
    if (is_pending_[slot]) return;
    is_pending_[slot] = true;
    pending_.add(slot);
    is_current_.store(false, std::memory_order_relaxed);
  }

  /// The same for these objects; `slots` is the number of slots.
  void note_all(std::span<const ObjectId> ids, std::size_t slots) noexcept {
    if (pending_.size() == slots) return;  // the usual case if there are no queries
    for (const ObjectId& id : ids) note(id.index);
  }

  /// The index with all changes applied.
  const SlotIndex<N, T>& over(const Slots& slots) const {
    if (!is_current_.load(std::memory_order_acquire)) catch_up(slots);
    return *index_;
  }

  /// A read-only copy of the current index; after further changes, this one continues with its own copy.
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
    if (!index_ || pending_.size() * filled_share > index_->size()) {
      fill(slots);
    } else {
      mend(slots);
    }
    is_current_.store(true, std::memory_order_release);
  }

  void fill(const Slots& slots) const {
    auto filled = std::make_shared<SlotIndex<N, T>>();
    filled->fill(slots);
    index_ = std::move(filled);
    is_shared_ = false;
    for (const std::uint32_t slot : pending_.all()) is_pending_[slot] = false;
    pending_.clear();
  }

  void mend(const Slots& slots) const {
    if (is_shared_) index_ = std::make_shared<SlotIndex<N, T>>(*index_);
    is_shared_ = false;
    while (!pending_.empty()) {
      const std::size_t last = pending_.size() - 1;
      index_->prefetch_place(pending_[last - std::min(last, prefetch_distance / 2)]);
      index_->prefetch_node(pending_[last - std::min(last, prefetch_distance / 4)]);
      index_->set(pending_[last], slots[pending_[last]]);
      is_pending_[pending_[last]] = false;
      pending_.drop_last();
    }
  }

  /// If more than one of this many slots has changed, the index is rebuilt.
  static constexpr std::size_t filled_share = 4;

  mutable std::mutex catching_up_;
  mutable std::atomic<bool> is_current_ = false;
  mutable std::shared_ptr<SlotIndex<N, T>> index_;
  mutable bool is_shared_ = false;
  mutable SlotList pending_;
  mutable std::vector<bool> is_pending_;  // by slot
};

}  // namespace graze::detail
