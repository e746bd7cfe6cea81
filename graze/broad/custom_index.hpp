// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <graze/broad/index/index_pairs.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// What CustomIndex requires of a finder, which stores numbered boxes in any data structure.
///
///     add(number, box)           Adds a box, which may have infinite sides. May throw, and then changes nothing.
///     remove(number, box)        Removes it; `box` is the one that was added. Does not throw, and neither does an
///                                `add` of the same box after it.
///     candidates(region, visit)  Calls visit(number) once for every box that shares a point with the region, a box,
///                                and for any others, until visit returns false.
///
/// A number is the index of the box's key. It is reused after its box is removed.
template <class F>
concept BoxFinder = std::copyable<F> && requires(F& finder, const F& reading, const typename F::Box& box,
                                                 std::uint32_t number, bool (*visit)(std::uint32_t)) {
  requires std::same_as<typename F::Box, Aabb<dimension_of<typename F::Box>, scalar_of<typename F::Box>>>;
  finder.add(number, box);
  finder.remove(number, box);
  reading.candidates(box, visit);
};

/// A SpatialIndex made from a way to find candidates: it handles keys, rejects invalid input, and filters the
/// candidates exactly. `query`, `ray_cast` and `nearest` cost what the candidates of a box around the answer cost; a
/// ray's box extends to infinity.
template <BoxFinder F>
class CustomIndex {
 public:
  /// The boxes that the index holds: those of the finder.
  using Box = typename F::Box;
  /// The dimension of the boxes.
  static constexpr Dim N = dimension_of<Box>;
  /// The number type of the boxes.
  using T = scalar_of<Box>;

  /// Creates an empty index on a finder that holds no boxes.
  explicit CustomIndex(F finder = F()) : finder_(std::move(finder)) {}

  /// Adds a box and returns its key. Throws std::invalid_argument for a box with a NaN, with a min above its max, or at
  /// infinity, std::length_error beyond 2^32 - 1 boxes, and what the finder throws.
  Key insert(const Box& box) {
    detail::require_box(box);
    const std::uint32_t slot = keys_.prepare().index;
    if (slot == boxes_.size()) boxes_.push_back(box);
    finder_.add(slot, box);
    settle(slot, box);
    return keys_.take();
  }

  /// Replaces a box. Throws std::invalid_argument like `insert`, std::out_of_range like `box`, and what the finder
  /// throws; then the box is as it was.
  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    finder_.remove(slot, boxes_[slot]);
    try {
      finder_.add(slot, box);
    } catch (...) {
      finder_.add(slot, boxes_[slot]);
      throw;
    }
    settle(slot, box);
    keys_.count_change();
  }

  /// Removes a box; its key is never valid again. Throws std::out_of_range like `box`.
  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    finder_.remove(slot, boxes_[slot]);
    keys_.release(slot);
  }

  /// Removes all boxes one by one from the finder; their keys are never valid again.
  void clear() {
    for (std::uint32_t slot = 0; slot < keys_.slots(); ++slot) {
      if (keys_.is_taken(slot)) finder_.remove(slot, boxes_[slot]);
    }
    keys_.release_all();
  }

  /// True while the key names a box of this index.
  bool contains(const Key& key) const { return keys_.contains(key); }
  /// The box of a key. Throws std::out_of_range for the key of a removed box, of another index, or a default one. The
  /// reference is valid until the next change of the index.
  const Box& box(const Key& key) const { return boxes_[keys_.slot_of(key)]; }
  /// Number of boxes.
  std::size_t size() const { return keys_.size(); }

  /// The finder, for reading.
  const F& finder() const { return finder_; }

  /// Calls visit(key) once for every box that meets the region, in the order of the finder, until it returns false.
  /// Throws std::invalid_argument for an invalid region.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    visit_candidates(probe.reach(largest_),
                     [&](std::uint32_t slot) { return !probe.meets(boxes_[slot]) || guarded(keys_.key_of(slot)); });
  }

  /// Calls visit(key, t) for every box that the ray enters, in order of t, ties by key, until it returns false. t is 0
  /// if the ray starts inside the box. Allocates a list of all hits. Throws std::invalid_argument for an invalid ray.
  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    visit_in_order(
        reach_of(ray), [&ray](const Box& box) { return detail::entry_of(ray, box); }, visit);
  }

  /// Calls visit(key, t) for every box that `box` touches while it moves along `motion`, in order of t, ties by key,
  /// until it returns false. t is from 0 to 1; 0 if they touch at the start. Allocates a list of all hits. Throws
  /// std::invalid_argument for an invalid box and if the motion is not finite.
  template <VisitorOf<Key, double> Visit>
  void cast(const Box& box, const Vec<N, T>& motion, Visit&& visit) const {
    const detail::SweptBox<N> sweep = detail::swept_box_in_index(box, motion);
    visit_in_order(
        sweep.template reach<T>(largest_), [&sweep](const Box& other) { return sweep.touch(other); }, visit);
  }

  /// The k boxes nearest to the point, or all if there are fewer: by distance, ties by key. Searches boxes of growing
  /// size around the point. Throws std::invalid_argument if the point is not finite.
  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    const std::size_t wanted = std::min(k, size());
    if (wanted == 0) return {};
    for (double radius = first_radius(point, wanted);; radius *= 2) {
      const Box near = around(point, radius);
      detail::NearestKeys nearest(wanted);
      visit_candidates(near, [&](std::uint32_t slot) {
        nearest.offer({keys_.key_of(slot), distance_squared(point, boxes_[slot])});
        return true;
      });
      // The distance of a box outside is rounded, too.
      if (nearest.reach() < radius * radius * (1 - tolerance::box_slack) || std::isinf(radius)) return nearest.sorted();
    }
  }

  /// Calls visit(a, b) once for every two boxes that share a point, ascending, a < b, until it returns false. Uses the
  /// batch method, not the finder; holds all pairs in memory while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return boxes_[slot]; }, visit);
  }

 private:
  void settle(std::uint32_t slot, const Box& box) noexcept {
    boxes_[slot] = box;
    largest_ = std::max(largest_, detail::finite_size(box));
  }

  /// Calls visit(key, t) for every box in a region with a time, t = *time(box), in order of t, ties by key, until it
  /// returns false.
  template <class Time, class Visit>
  void visit_in_order(const Box& reach, const Time& time, Visit& visit) const {
    std::vector<std::pair<double, Key>> hits;
    visit_candidates(reach, [&](std::uint32_t slot) {
      if (const auto t = time(boxes_[slot])) hits.emplace_back(*t, keys_.key_of(slot));
      return true;
    });
    std::sort(hits.begin(), hits.end());
    detail::GuardedVisit guarded(visit, keys_);
    for (const auto& [t, key] : hits) {
      if (!guarded(key, t)) return;
    }
  }

  /// A finder is not asked about a region that nothing can meet.
  template <class Visit>
  void visit_candidates(const Box& reach, Visit&& visit) const {
    if (!detail::has_nan_coordinate(reach) && !is_nothing(reach)) finder_.candidates(reach, visit);
  }

  /// Every box that the ray enters meets this one: an entry is at t >= 0, and differences have the right sign.
  static Box reach_of(const Ray<N, T>& ray) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    Box reach{ray.origin, ray.origin};
    for (Dim i = 0; i < N; ++i) {
      if (ray.direction[i] > T(0)) reach.max[i] = infinity;
      if (ray.direction[i] < T(0)) reach.min[i] = -infinity;
    }
    return reach;
  }

  /// A point outside this box is farther away than `radius` along some axis, by more than rounding.
  static Box around(const Vec<N, T>& point, double radius) {
    Box box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = round_down<T>(static_cast<double>(point[i]) - radius);
      box.max[i] = round_up<T>(static_cast<double>(point[i]) + radius);
    }
    return box;
  }

  /// A guess that is doubled until the box contains enough: as if the boxes were evenly distributed up to the farthest
  /// of a sample.
  double first_radius(const Vec<N, T>& point, std::size_t wanted) const {
    constexpr std::size_t sample = 16;
    constexpr double least = 1e-100;  // its square is not zero
    double farthest = 0;
    std::size_t seen = 0;
    for (std::uint32_t slot = 0; slot < keys_.slots() && seen < sample; ++slot) {
      if (!keys_.is_taken(slot)) continue;
      ++seen;
      const double distance = std::sqrt(distance_squared(point, boxes_[slot]));
      if (distance < std::numeric_limits<double>::infinity()) farthest = std::max(farthest, distance);
    }
    const double share = static_cast<double>(wanted) / static_cast<double>(size());
    const double radius = farthest * std::pow(share, 1.0 / N);
    return std::max(radius, least + largest_ * std::numeric_limits<T>::epsilon());
  }

  F finder_;
  detail::KeyTable keys_;
  std::vector<Box> boxes_;  // by slot
  double largest_ = 0;      // largest finite coordinate so far
};

}  // namespace graze
