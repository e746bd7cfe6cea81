// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// A SpatialIndex that tests every box in every query: the reference for the others, and fast enough for a few dozen
/// boxes. Queries visit in ascending order of the keys.
template <Dim N, class T = float>
class BruteForce {
 public:
  /// The boxes that the index holds.
  using Box = Aabb<N, T>;

  /// Adds a box and returns its key. Throws std::invalid_argument for a box with a NaN, with a min above its max, or at
  /// infinity, and std::length_error beyond 2^32 - 1 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    const std::uint32_t slot = keys_.prepare().index;
    if (slot == boxes_.size()) boxes_.push_back(box);
    boxes_[slot] = box;
    return keys_.take();
  }

  /// Replaces a box. Throws std::invalid_argument like `insert` and std::out_of_range like `box`.
  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    boxes_[slot] = box;
    keys_.count_change();
  }

  /// Removes a box; its key is never valid again. Throws std::out_of_range like `box`.
  void erase(const Key& key) { keys_.release(keys_.slot_of(key)); }

  /// Removes all boxes; their keys are never valid again.
  void clear() { keys_.release_all(); }

  /// True while the key names a box of this index.
  bool contains(const Key& key) const { return keys_.contains(key); }
  /// The box of a key. Throws std::out_of_range for the key of a removed box, of another index, or a default one. The
  /// reference is valid until the next change of the index.
  const Box& box(const Key& key) const { return boxes_[keys_.slot_of(key)]; }
  /// Number of boxes.
  std::size_t size() const { return keys_.size(); }

  /// Memory in use, in bytes.
  std::size_t bytes() const { return keys_.bytes() + boxes_.capacity() * sizeof(Box); }

  /// Calls visit(key) for every box that meets the region, ascending, until it returns false. Throws
  /// std::invalid_argument for an invalid region.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    for (std::uint32_t slot = 0; slot < keys_.slots(); ++slot) {
      if (keys_.is_taken(slot) && probe.meets(boxes_[slot]) && !guarded(keys_.key_of(slot))) return;
    }
  }

  /// Calls visit(key, t) for every box that the ray enters, in order of t, ties by key, until it returns false. t is 0
  /// if the ray starts inside the box. Allocates a list of all hits. Throws std::invalid_argument for an invalid ray.
  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    visit_in_order([&ray](const Box& box) { return detail::entry_of(ray, box); }, visit);
  }

  /// Calls visit(key, t) for every box that `box` touches while it moves along `motion`, in order of t, ties by key,
  /// until it returns false. t is from 0 to 1; 0 if they touch at the start. Allocates a list of all hits. Throws
  /// std::invalid_argument for an invalid box and if the motion is not finite.
  template <VisitorOf<Key, double> Visit>
  void cast(const Box& box, const Vec<N, T>& motion, Visit&& visit) const {
    const detail::SweptBox<N> sweep = detail::swept_box_in_index(box, motion);
    visit_in_order([&sweep](const Box& other) { return sweep.touch(other); }, visit);
  }

  /// The k boxes nearest to the point, or all if there are fewer: by distance, ties by key. Throws
  /// std::invalid_argument if the point is not finite.
  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    detail::NearestKeys nearest(std::min(k, size()));
    for (std::uint32_t slot = 0; slot < keys_.slots() && k > 0; ++slot) {
      if (keys_.is_taken(slot)) nearest.offer({keys_.key_of(slot), distance_squared(point, boxes_[slot])});
    }
    return nearest.sorted();
  }

  /// Calls visit(a, b) once for every two boxes that share a point, ascending, a < b, until it returns false. Tests all
  /// pairs.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::GuardedVisit guarded(visit, keys_);
    for (std::uint32_t a = 0; a < keys_.slots(); ++a) {
      for (std::uint32_t b = a + 1; b < keys_.slots() && keys_.is_taken(a); ++b) {
        if (!keys_.is_taken(b) || !boxes_overlap(boxes_[a], boxes_[b])) continue;
        if (!guarded(keys_.key_of(a), keys_.key_of(b))) return;
      }
    }
  }

 private:
  /// Calls visit(key, t) for every box with a time, t = *time(box), in order of t, ties by key, until it returns false.
  template <class Time, class Visit>
  void visit_in_order(const Time& time, Visit& visit) const {
    std::vector<Hit> hits;
    for (std::uint32_t slot = 0; slot < keys_.slots(); ++slot) {
      if (!keys_.is_taken(slot)) continue;
      if (const auto t = time(boxes_[slot])) hits.push_back({*t, keys_.key_of(slot)});
    }
    std::sort(hits.begin(), hits.end());
    detail::GuardedVisit guarded(visit, keys_);
    for (const Hit& hit : hits) {
      if (!guarded(hit.key, hit.t)) return;
    }
  }

  struct Hit {
    double t;
    Key key;

    friend auto operator<=>(const Hit&, const Hit&) = default;
  };

  detail::KeyTable keys_;
  std::vector<Box> boxes_;  // by slot
};

}  // namespace graze
