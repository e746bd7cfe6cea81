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
#include <graze/broad/spatial_index.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// What CustomIndex builds on: numbers of boxes, kept in an order of yours.
///
///   add(number, box)           Takes a box in, which may have infinite sides. It may throw, and then changes nothing.
///   remove(number, box)        Takes it out; `box` is the one that was added. It does not throw, and an `add` of the
///                              same box after it does not either.
///   candidates(region, visit)  visit(number) for every box that shares a point with the region, a box, and for others
///                              as it likes, but once for each, until visit returns false.
///
/// A number is the index of the box's key. It is used again when its box is gone.
template <class F>
concept BoxFinder = std::copyable<F> && requires(F& finder, const F& reading, const typename F::Box& box,
                                                 std::uint32_t number, bool (*visit)(std::uint32_t)) {
  requires std::same_as<typename F::Box, Aabb<dimension_of<typename F::Box>, scalar_of<typename F::Box>>>;
  finder.add(number, box);
  finder.remove(number, box);
  reading.candidates(box, visit);
};

/// A SpatialIndex of your own, from nothing but a way to find candidates: it sees to keys, to what is refused, and to
/// the exact answers. `query`, `ray_cast` and `nearest` cost what the candidates of a box around the answer cost; a
/// ray's box reaches to infinity.
template <BoxFinder F>
class CustomIndex {
 public:
  using Box = typename F::Box;
  static constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;

  explicit CustomIndex(F finder = F()) : finder_(std::move(finder)) {}

  Key insert(const Box& box) {
    detail::require_box(box);
    const std::uint32_t slot = keys_.prepare().index;
    if (slot == boxes_.size()) boxes_.push_back(box);
    finder_.add(slot, box);
    settle(slot, box);
    return keys_.take();
  }

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

  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    finder_.remove(slot, boxes_[slot]);
    keys_.release(slot);
  }

  void clear() {
    for (std::uint32_t slot = 0; slot < keys_.slots(); ++slot) {
      if (keys_.is_taken(slot)) finder_.remove(slot, boxes_[slot]);
    }
    keys_.release_all();
  }

  bool contains(const Key& key) const { return keys_.contains(key); }
  const Box& box(const Key& key) const { return boxes_[keys_.slot_of(key)]; }
  std::size_t size() const { return keys_.size(); }

  /// What finds the candidates.
  const F& finder() const { return finder_; }

  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    visit_candidates(probe.reach(largest_),
                     [&](std::uint32_t slot) { return !probe.meets(boxes_[slot]) || guarded(keys_.key_of(slot)); });
  }

  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    std::vector<std::pair<double, Key>> hits;
    visit_candidates(reach_of(ray), [&](std::uint32_t slot) {
      if (const auto t = detail::entry_of(ray, boxes_[slot])) hits.emplace_back(*t, keys_.key_of(slot));
      return true;
    });
    std::sort(hits.begin(), hits.end());
    detail::GuardedVisit guarded(visit, keys_);
    for (const auto& [t, key] : hits) {
      if (!guarded(key, t)) return;
    }
  }

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
      // The distance of what lies outside is rounded, too.
      if (nearest.reach() < radius * radius * (1 - tolerance::box_slack) || std::isinf(radius)) return nearest.sorted();
    }
  }

  /// By the batch method, without the candidates; holds all pairs while it visits them.
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

  /// Of a reach that nothing can meet a finder hears nothing.
  template <class Visit>
  void visit_candidates(const Box& reach, Visit&& visit) const {
    if (!detail::has_nan_coordinate(reach) && !is_nothing(reach)) finder_.candidates(reach, visit);
  }

  /// No box that the ray enters misses it: an entry is at t >= 0, and differences have the right sign.
  static Box reach_of(const Ray<N, T>& ray) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    Box reach{ray.origin, ray.origin};
    for (Dim i = 0; i < N; ++i) {
      if (ray.direction[i] > T(0)) reach.max[i] = infinity;
      if (ray.direction[i] < T(0)) reach.min[i] = -infinity;
    }
    return reach;
  }

  /// What lies outside is farther away on some axis, and not by rounding alone.
  static Box around(const Vec<N, T>& point, double radius) {
    Box box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = round_down<T>(static_cast<double>(point[i]) - radius);
      box.max[i] = round_up<T>(static_cast<double>(point[i]) + radius);
    }
    return box;
  }

  /// A guess that is doubled until it holds enough: as if the boxes lay evenly within the farthest of a few.
  double first_radius(const Vec<N, T>& point, std::size_t wanted) const {
    constexpr std::size_t sample = 16;
    constexpr double least = 1e-100;  // whose square is not zero
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
  double largest_ = 0;      // no finite coordinate was ever larger
};

}  // namespace graze
