// SPDX-License-Identifier: MIT
/// @file
/// The interface of all indexes of moving boxes. BruteForce, Grid, Orthtree (QuadTree, Octree) and Bvh model it; one
/// typed test compares each with BruteForce. CustomIndex turns a way to find candidates into an index.
///
///     insert(box) -> Key        Adds a box. Throws std::invalid_argument for a box with a NaN, with min above max, or
///                               at infinity; infinite sides are valid. Throws std::length_error if it is full: an
///                               Orthtree and a Grid with 2^29 boxes, a Bvh with 2^31 - 1, a BruteForce with 2^32 - 1.
///     update(key, box)          Replaces a box. Throws like insert and box.
///     erase(key)                Removes a box. The key is never valid again. Throws like box.
///     box(key), contains(key)   box throws std::out_of_range for the key of a removed box, of another index, or a
///                               default one.
///     size(), clear()
///     assign(boxes)             Bvh and Orthtree only: replaces all boxes at once. Returns their keys, in order.
///     query(region, visit)      Calls visit(key) once for every box that meets the region (region.hpp).
///     ray_cast(ray, visit)      Calls visit(key, t) for every box that the ray enters, in order of t, ties by key. The
///                               ray is inside the box from origin + t * direction on; t is 0 if it starts there.
///     cast(box, motion, visit)  Calls visit(key, t) for every box that the moving box touches, in order of t, ties by
///     key.
///                               The box has moved by t * motion then, with t from 0 to 1; t is 0 if they touch at
///                               once.
///     nearest(point, k)         Returns the k boxes nearest to the point, or all: by distance, ties by key.
///     pairs(visit)              Calls visit(a, b) once for every two boxes that share a point, ascending, a < b.
///
/// A call that throws leaves the index unchanged. A visitor returns void or bool; false ends the visit. The order of
/// visits in `query` depends on the index, but the same sequence of calls gives the same order on every machine.
/// Reading is const, allocates almost nothing, and is safe from many threads at once; writing needs exclusive access. A
/// visitor must not change the index that it visits: that throws std::logic_error. Exceptions of a visitor propagate.
/// Queries throw std::invalid_argument for invalid input: a region, ray or point with a NaN, a negative radius.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/sphere.hpp>

namespace graze {

/// A box and its squared distance from a point, as `distance_squared(point, box)` returns it: 0 if the point is inside.
struct Neighbour {
  Key key;                      ///< Names the box.
  double distance_squared = 0;  ///< In double, whatever the type of the boxes.

  friend bool operator==(const Neighbour&, const Neighbour&) = default;
};

/// A callable that takes these values and returns void, or a bool that tells whether to go on.
template <class V, class... Values>
concept VisitorOf = std::invocable<V&, Values...> &&(std::same_as<std::invoke_result_t<V&, Values...>, void> ||
                                                     std::same_as<std::invoke_result_t<V&, Values...>, bool>);

/// The interface described at the top of this file.
template <class I>
concept SpatialIndex = requires(I& index, const I& reading, const Key& key, bool (*visit)(Key),
                                bool (*visit_hit)(Key, double), bool (*visit_pair)(Key, Key)) {
  typename I::Box;
  { index.insert(typename I::Box{}) } -> std::same_as<Key>;
  { index.update(key, typename I::Box{}) } -> std::same_as<void>;
  { index.erase(key) } -> std::same_as<void>;
  { index.clear() } -> std::same_as<void>;
  { reading.contains(key) } -> std::same_as<bool>;
  { reading.box(key) } -> std::convertible_to<typename I::Box>;
  { reading.size() } -> std::same_as<std::size_t>;
  reading.query(typename I::Box{}, visit);
  reading.query(Sphere<dimension_of<typename I::Box>, scalar_of<typename I::Box>>{}, visit);
  reading.ray_cast(Ray<dimension_of<typename I::Box>, scalar_of<typename I::Box>>{}, visit_hit);
  reading.cast(typename I::Box{}, decltype(I::Box::min){}, visit_hit);
  { reading.nearest(decltype(I::Box::min){}, std::size_t{}) } -> std::same_as<std::vector<Neighbour>>;
  reading.pairs(visit_pair);
};

/// The number of boxes of an index that meet a region.
template <SpatialIndex I, class R>
std::size_t count(const I& index, const R& region) {
  std::size_t found = 0;
  index.query(region, [&found](Key) { ++found; });
  return found;
}

namespace detail {

template <Dim N, class T>
void require_box(const Aabb<N, T>& box) {
  if (has_nan_coordinate(box))
    GRAZE_THROW(std::invalid_argument("SpatialIndex: the box has a coordinate that is not a number"));
  if (is_nothing(box)) GRAZE_THROW(std::invalid_argument("SpatialIndex: the box has a min above its max"));
  constexpr T infinity = std::numeric_limits<T>::infinity();
  for (Dim i = 0; i < N; ++i) {
    if (box.min[i] < infinity && box.max[i] > -infinity) continue;
    GRAZE_THROW(std::invalid_argument(
        "SpatialIndex: the box lies at infinity; its min must be below +infinity, its max above -infinity"));
  }
}

template <Dim N, class T>
void require_ray(const Ray<N, T>& ray) {
  if (!is_valid(ray)) GRAZE_THROW(std::invalid_argument("SpatialIndex: the ray " + std::string(defect(ray))));
}

template <Dim N, class T>
void require_point(const Vec<N, T>& point) {
  if (!is_finite(point))
    GRAZE_THROW(std::invalid_argument("SpatialIndex: the point has a coordinate that is not finite"));
}

/// Wraps a visitor: returns whether to go on, and throws if it has changed the index.
template <class Visit>
class GuardedVisit {
 public:
  GuardedVisit(Visit& visit, const KeyTable& keys) : visit_(visit), keys_(keys), changes_(keys.changes()) {}

  template <class... Values>
  bool operator()(const Values&... values) {
    bool goes_on = true;
    if constexpr (std::is_void_v<std::invoke_result_t<Visit&, const Values&...>>) {
      visit_(values...);
    } else {
      goes_on = visit_(values...);
    }
    if (keys_.changes() != changes_) {
      GRAZE_THROW(std::logic_error(
          "SpatialIndex: a visitor changed the index that it visits; keep the keys and change it afterwards"));
    }
    return goes_on;
  }

 private:
  Visit& visit_;
  const KeyTable& keys_;
  std::uint64_t changes_;
};

/// The t at which a ray enters a box, 0 if it starts inside; none if it misses the box or t overflows. Each t has two
/// roundings, so a ray that passes a corner by that little enters. Never later for a box that contains another, because
/// differences, quotients and maxima round monotonically.
template <Dim N, class T>
std::optional<double> entry_of(const Ray<N, T>& ray, const Aabb<N, T>& box) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < N; ++i) {
    if (ray.direction[i] == T(0)) {
      if (!(box.min[i] <= ray.origin[i] && ray.origin[i] <= box.max[i])) return std::nullopt;
      continue;
    }
    const double origin = static_cast<double>(ray.origin[i]);
    const double direction = static_cast<double>(ray.direction[i]);
    const double low = static_cast<double>(box.min[i]);
    const double high = static_cast<double>(box.max[i]);
    enter = std::max(enter, ((direction > 0 ? low : high) - origin) / direction);
    leave = std::min(leave, ((direction > 0 ? high : low) - origin) / direction);
  }
  if (!(enter <= leave * (1 + tolerance::ray_slabs)) || std::isinf(enter)) return std::nullopt;
  return enter;
}

/// The k nearest of all boxes offered: few are kept sorted, many in a heap. Only many allocate before the end.
class NearestKeys {
 public:
  /// Up to this many are kept sorted.
  static constexpr std::size_t few = 32;

  explicit NearestKeys(std::size_t k) : k_(k) {
    if (is_heap()) many_.reserve(k);
  }

  std::size_t wanted() const { return k_; }

  /// The nearest so far, in some order.
  std::span<const Neighbour> kept() const {
    return is_heap() ? std::span<const Neighbour>(many_) : std::span<const Neighbour>(few_.all, count_);
  }

  /// Boxes farther away than this are no longer candidates.
  double reach() const {
    if (is_heap()) return many_.size() < k_ ? infinity : many_.front().distance_squared;
    return count_ < k_ ? infinity : few_.all[count_ - 1].distance_squared;
  }

  /// Not to be called if k is zero.
  void offer(const Neighbour& candidate) {
    if (!is_heap()) return offer_to_few(candidate);
    if (many_.size() == k_) {
      if (!comes_first(candidate, many_.front())) return;
      std::pop_heap(many_.begin(), many_.end(), comes_first);
      many_.back() = candidate;
    } else {
      many_.push_back(candidate);
    }
    std::push_heap(many_.begin(), many_.end(), comes_first);
  }

  /// Replaces all by these, in their order: k of them, at most `few`.
  void replace(std::span<const Neighbour> sorted) {
    std::uninitialized_copy(sorted.begin(), sorted.end(), few_.all);
    count_ = sorted.size();
  }

  /// The result, sorted; ends the search.
  std::vector<Neighbour> sorted() {
    if (!is_heap()) return {few_.all, few_.all + count_};
    std::sort_heap(many_.begin(), many_.end(), comes_first);
    return std::move(many_);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Storage that is not written before there is something to keep.
  union Few {
    Few() {}  // NOLINT(modernize-use-equals-default): which would be deleted
    Neighbour all[few];
  };

  bool is_heap() const { return k_ > few; }

  void offer_to_few(const Neighbour& candidate) {
    if (count_ < k_) {
      ++count_;
    } else if (!comes_first(candidate, few_.all[count_ - 1])) {
      return;
    }
    std::size_t place = count_ - 1;
    for (; place > 0 && comes_first(candidate, few_.all[place - 1]); --place) few_.all[place] = few_.all[place - 1];
    few_.all[place] = candidate;
  }

  static bool comes_first(const Neighbour& a, const Neighbour& b) {
    return a.distance_squared != b.distance_squared ? a.distance_squared < b.distance_squared : a.key < b.key;
  }

  std::size_t k_;
  std::size_t count_ = 0;        // of a few
  Few few_;                      // ascending
  std::vector<Neighbour> many_;  // a heap with the farthest in front
};

}  // namespace detail
}  // namespace graze
