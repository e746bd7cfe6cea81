// SPDX-License-Identifier: MIT
// Walks a Bvh to the boxes near a box, which may be a point. Included once per instruction set, so it has no ordinary
// include guard.
#if defined(GRAZE_BROAD_BVH_NEAR_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_BVH_NEAR_INL_HPP
#undef GRAZE_BROAD_BVH_NEAR_INL_HPP
#else
#define GRAZE_BROAD_BVH_NEAR_INL_HPP
#endif

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/bvh/node.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Unsigned integers of the width of T.
template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// The largest rank of a box within reach.
template <class T>
HWY_INLINE T rank_of(double reach) {
  constexpr T most = std::numeric_limits<T>::max();
  const T distance = static_cast<T>(std::min(reach, static_cast<double>(most)));
  return std::min(distance * (T(1) + tolerance::near_lanes<T>)+std::numeric_limits<T>::min(), most);
}

HWY_INLINE Lanes<float> load_as(Tag<float> d, const float* from) { return hn::Load(d, from); }
HWY_INLINE Lanes<double> load_as(Tag<double> d, const double* from) { return hn::Load(d, from); }
HWY_INLINE Lanes<double> load_as(Tag<double> d, const float* from) {
  return hn::PromoteTo(d, hn::Load(hn::Rebind<float, Tag<double>>(), from));
}

/// The squared distances from a box to boxes of a node, calculated in `To` by the operations of distance_squared.
template <class To, Dim N, class T>
HWY_INLINE Lanes<To> distances_from(const Aabb<N, T>& from, const BvhNode<N, T>& node, std::uint32_t lane) {
  const Tag<To> d;
  auto sum = hn::Zero(d);
  for (Dim i = 0; i < N; ++i) {
    const auto below = hn::Sub(load_as(d, node.boxes.min[i] + lane), hn::Set(d, static_cast<To>(from.max[i])));
    const auto above = hn::Sub(hn::Set(d, static_cast<To>(from.min[i])), load_as(d, node.boxes.max[i] + lane));
    const auto outside = hn::Max(hn::Max(below, above), hn::Zero(d));
    const auto square = hn::Mul(outside, outside);
    sum = i == 0 ? square : hn::Add(sum, square);
  }
  return sum;
}

/// The children of an inner node with their ranks: squared distances in T, capped at the largest number, infinite for
/// lanes without a child. The lowest bits of a rank hold the lane, so the minimum identifies the nearest child.
template <Dim N, class T>
struct NearChildren {
  alignas(64) T ranks[block_size];
  const BvhNode<N, T>* node;

  BvhLink link(std::uint32_t lane) const { return BvhLink::of_code(node->entries[lane]); }
};

/// Returns the lane-wise minima of the ranks.
template <Dim N, class T>
HWY_INLINE Lanes<T> rank_children(const Aabb<N, T>& from, const BvhNode<N, T>& node, NearChildren<N, T>& children) {
  using Bits = BitsOf<T>;
  const Tag<T> d;
  const hn::Rebind<Bits, Tag<T>> bits;
  prefetch(&node.entries);  // read as soon as the least rank is known
  const auto infinity = hn::Set(d, std::numeric_limits<T>::infinity());
  auto least = infinity;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    const auto distances = hn::Min(distances_from<T>(from, node, lane), hn::Set(d, std::numeric_limits<T>::max()));
    const auto upper = hn::AndNot(hn::Set(bits, Bits{block_size - 1}), hn::BitCast(bits, distances));
    const auto marked = hn::BitCast(d, hn::Or(upper, hn::Iota(bits, static_cast<Bits>(lane))));
    const auto ranks = hn::IfThenElse(is_full<T>(hn::Load(d, node.boxes.min[0] + lane)), marked, infinity);
    hn::Store(ranks, d, children.ranks + lane);
    least = hn::Min(least, ranks);
  }
  children.node = &node;
  return least;
}

template <class T>
HWY_INLINE std::uint32_t lane_of_least(Lanes<T> ranks) {
  const T least = hn::GetLane(hn::MinOfLanes(Tag<T>(), ranks));
  return static_cast<std::uint32_t>(bit_cast<BitsOf<T>>(least)) & (block_size - 1);
}

/// Which children have a rank up to a limit, as a bit mask.
template <Dim N, class T>
HWY_INLINE std::uint32_t ranked_within(const NearChildren<N, T>& children, T limit) {
  const Tag<T> d;
  std::uint32_t within = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    within |= bits_of<T>(hn::Le(hn::Load(d, children.ranks + lane), hn::Set(d, limit))) << lane;
  }
  return within;
}

/// The squared distances from a box to the boxes of a leaf node, bit-identical to distance_squared; infinite for
/// lanes without a box.
struct NearBoxes {
  alignas(64) double distances[block_size];
  const std::uint32_t* slots;
  const std::uint32_t* generations;
  std::uint32_t within;  // bit mask of the boxes within reach

  Neighbour neighbour(std::uint32_t lane) const { return {{slots[lane], generations[lane], 0}, distances[lane]}; }
};

template <Dim N, class T>
HWY_INLINE void measure_boxes(const Aabb<N, T>& from, const BvhNode<N, T>& node, double reach, NearBoxes& boxes) {
  const Tag<double> d;
  prefetch(&node.entries);
  prefetch(&node.generations);
  boxes.slots = node.entries;
  boxes.generations = node.generations;
  boxes.within = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<double>) {
    const auto full = is_full<double>(load_as(d, node.boxes.min[0] + lane));
    const auto distances = distances_from<double>(from, node, lane);
    boxes.within |= bits_of<double>(hn::And(full, hn::Le(distances, hn::Set(d, reach)))) << lane;
    const auto infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    hn::Store(hn::IfThenElse(full, distances, infinity), d, boxes.distances + lane);
  }
}

/// Keeps the nearest box only.
class NearestOne {
 public:
  static constexpr bool wants_order = false;

  explicit NearestOne(NearestKeys& nearest) : nearest_(nearest), reach_(nearest.reach()) {}

  HWY_INLINE double reach() const { return reach_; }

  HWY_INLINE void offer(const NearBoxes& boxes) {
    if (boxes.within == 0) return;
    const Tag<double> d;
    auto least = hn::Load(d, boxes.distances);
    for (std::uint32_t lane = lanes_of<double>; lane < block_size; lane += lanes_of<double>) {
      least = hn::Min(least, hn::Load(d, boxes.distances + lane));
    }
    least = hn::MinOfLanes(d, least);
    std::uint32_t first = 0;
    for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<double>) {
      first |= bits_of<double>(hn::Eq(hn::Load(d, boxes.distances + lane), least)) << lane;
    }
    first &= boxes.within;
    double distance = hn::GetLane(least);
    if (first == 0) {  // if all are infinitely far, Highway's emulation returns a smaller number
      first = boxes.within;
      distance = std::numeric_limits<double>::infinity();
    }
    auto lane = static_cast<std::uint32_t>(std::countr_zero(first));
    while ((first &= first - 1) != 0) {
      const auto other = static_cast<std::uint32_t>(std::countr_zero(first));
      if (boxes.slots[other] < boxes.slots[lane]) lane = other;
    }
    if (distance == reach_ && key_.index < boxes.slots[lane]) return;
    key_ = {boxes.slots[lane], boxes.generations[lane], 0};
    reach_ = distance;
  }

  HWY_INLINE void finish() {
    if (key_.index != no_box) nearest_.offer({key_, reach_});
  }

 private:
  NearestKeys& nearest_;
  double reach_;
  Key key_{no_box, 0, 0};
};

/// Keeps a small number of boxes: their distances, ascending, by branch-free minima and maxima, and all boxes that were
/// within reach when they were offered.
template <std::size_t Most>
class NearestFew {
 public:
  static constexpr bool wants_order = false;

  explicit NearestFew(NearestKeys& nearest) : nearest_(nearest), last_(nearest.wanted() - 1) {
    std::fill_n(distances_, Most, std::numeric_limits<double>::infinity());
    for (const Neighbour& neighbour : nearest.kept()) insert(neighbour.distance_squared);
  }

  HWY_INLINE double reach() const { return distances_[last_]; }

  HWY_INLINE void offer(const NearBoxes& boxes) {
    for (std::uint32_t rest = boxes.within; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      insert(boxes.distances[lane]);
      candidates_[count_++] = {boxes.distances[lane], boxes.slots[lane], boxes.generations[lane]};
    }
    if (count_ > room) finish();
  }

  /// A box's rank is the number of smaller distances, if no other is equal. Ties are broken by slots, also where tied
  /// boxes share the last wanted rank and every rank seems to be taken.
  void finish() {
    const Tag<double> d;
    constexpr std::uint32_t lanes = lanes_of<double>;
    Lanes<double> least[Most / lanes];
    for (std::uint32_t k = 0; k < Most / lanes; ++k) least[k] = hn::Load(d, distances_ + k * lanes);
    std::uint32_t order[Most + 1];
    std::uint32_t taken = 0;
    std::uint32_t taken_twice = 0;
    for (std::uint32_t k = 0; k < count_; ++k) {
      std::uint32_t before = 0;
      for (std::uint32_t j = 0; j < Most / lanes; ++j) {
        before |= bits_of<double>(hn::Lt(least[j], hn::Set(d, candidates_[k].distance))) << j * lanes;
      }
      const auto place = static_cast<std::uint32_t>(std::popcount(before));
      order[place] = k;
      taken_twice |= taken & (1U << place);
      taken |= 1U << place;
    }
    const std::size_t wanted = last_ + 1;
    const std::uint32_t places = (1U << wanted) - 1U;
    if ((taken & ~taken_twice & places) == places && !keeps_any_within_reach()) {
      Neighbour sorted[Most];
      for (std::size_t place = 0; place < wanted; ++place) {
        sorted[place] = candidates_[order[place]].neighbour();
      }
      nearest_.replace({sorted, wanted});
    } else {
      const double farthest = reach();
      for (std::uint32_t k = 0; k < count_; ++k) {
        if (candidates_[k].distance <= farthest) nearest_.offer(candidates_[k].neighbour());
      }
    }
    count_ = 0;
  }

 private:
  struct Candidate {
    double distance;
    std::uint32_t slot;
    std::uint32_t generation;

    Neighbour neighbour() const { return {{slot, generation, 0}, distance}; }
  };

  /// Among the boxes offered before the candidates.
  bool keeps_any_within_reach() const {
    bool any = false;
    for (const Neighbour& neighbour : nearest_.kept()) any |= neighbour.distance_squared <= reach();
    return any;
  }

  HWY_INLINE void insert(double distance) {
    for (std::size_t k = Most - 1; k > 0; --k) {
      distances_[k] = std::min(distances_[k], std::max(distances_[k - 1], distance));
    }
    distances_[0] = std::min(distances_[0], distance);
  }

  static constexpr std::size_t room = 64;

  NearestKeys& nearest_;
  std::size_t last_;
  std::size_t count_ = 0;
  alignas(64) double distances_[Most];
  Candidate candidates_[room + block_size];
};

/// Keeps any number of boxes. Insertion is so expensive that visiting the nearest nodes first pays.
class NearestMany {
 public:
  static constexpr bool wants_order = true;

  explicit NearestMany(NearestKeys& nearest) : nearest_(nearest) {}

  HWY_INLINE double reach() const { return nearest_.reach(); }

  HWY_INLINE void offer(const NearBoxes& boxes) {
    for (std::uint32_t rest = boxes.within; rest != 0; rest &= rest - 1) {
      nearest_.offer(boxes.neighbour(static_cast<std::uint32_t>(std::countr_zero(rest))));
    }
  }

  void finish() const {}

 private:
  NearestKeys& nearest_;
};

/// A walk to the boxes near a box: first down to the leaf node that seems nearest, then bottom-up to everything
/// within reach of what was found there.
template <Dim N, class T, class Keep>
class NearWalk {
 public:
  NearWalk(const BvhNode<N, T>* nodes, const Aabb<N, T>& from, NearestKeys& nearest)
      : nodes_(nodes), from_(from), keep_(nearest) {}

  /// Returns the number of nodes visited.
  HWY_INLINE std::size_t walk(BvhLink root) {
    NearChildren<N, T> path[bvh_height_limit];
    std::uint32_t lanes[bvh_height_limit];
    std::size_t depth = 0;
    BvhLink link = root;
    for (; !link.is_leaf(); ++depth) {
      lanes[depth] = lane_of_least<T>(rank_children(from_, nodes_[link.index()], path[depth]));
      link = path[depth].link(lanes[depth]);
    }
    looks_ = depth;
    prefetch_whole(nodes_ + link.index());
    if (depth > 0) ask_for_near(path[depth - 1], lanes[depth - 1]);  // while that one is being fetched
    test_axes(link);
    while (depth-- > 0) {
      const std::uint32_t others = ranked_within(path[depth], limit_) & ~(1U << lanes[depth]);
      look_at(path[depth], others);
      while (open_count_ > 0) {
        const Waiting next = open_[--open_count_];
        if (next.rank > limit_) continue;
        NearChildren<N, T> children;
        rank_children(from_, nodes_[BvhLink::of_code(next.code).index()], children);
        ++looks_;
        look_at(children, ranked_within(children, limit_));
      }
    }
    keep_.finish();
    return looks_;
  }

 private:
  HWY_INLINE void test_axes(BvhLink leaf) {
    NearBoxes boxes;
    measure_boxes(from_, nodes_[leaf.index()], keep_.reach(), boxes);
    ++looks_;
    keep_.offer(boxes);
    limit_ = rank_of<T>(keep_.reach());
  }

  /// Prefetches the other children likely to be visited after the nearest: those at most a quarter of its width farther
  /// away, where a box is usually found.
  HWY_INLINE void ask_for_near(const NearChildren<N, T>& children, std::uint32_t nearest) const {
    const Block<N, T>& boxes = children.node->boxes;
    const T quarter = (boxes.max[0][nearest] - boxes.min[0][nearest]) * T(0.25);
    const T limit = std::min(children.ranks[nearest] + quarter * quarter, std::numeric_limits<T>::max());
    std::uint32_t others = ranked_within(children, limit) & ~(1U << nearest);
    for (; others != 0; others &= others - 1) {
      prefetch_whole(nodes_ + children.link(static_cast<std::uint32_t>(std::countr_zero(others))).index());
    }
  }

  /// Visits the boxes of children that are leaf nodes now, and queues inner nodes.
  HWY_INLINE void look_at(const NearChildren<N, T>& children, std::uint32_t lanes) {
    if (lanes == 0) return;
    std::uint32_t order[block_size];
    std::uint32_t count = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      prefetch_whole(nodes_ + children.link(lane).index());
      std::uint32_t place = count++;
      if constexpr (Keep::wants_order) {
        for (; place > 0 && children.ranks[order[place - 1]] < children.ranks[lane]; --place) {
          order[place] = order[place - 1];
        }
      }
      order[place] = lane;
    }
    if (children.link(0).is_leaf()) {
      while (count-- > 0) {
        if (children.ranks[order[count]] <= limit_) test_axes(children.link(order[count]));
      }
      return;
    }
    for (std::uint32_t k = 0; k < count; ++k) {
      open_[open_count_++] = {children.ranks[order[k]], children.node->entries[order[k]]};
    }
  }

  struct Waiting {
    T rank;
    std::uint32_t code;  // of its link
  };

  const BvhNode<N, T>* nodes_;
  const Aabb<N, T>& from_;
  Keep keep_;
  T limit_{};
  std::size_t looks_ = 0;
  std::size_t open_count_ = 0;
  Waiting open_[bvh_path];
};

template <Dim N, class T>
std::size_t find_near(const BvhNode<N, T>* nodes, BvhLink root, const Aabb<N, T>& from, NearestKeys& nearest) {
  if (nearest.wanted() == 1) return NearWalk<N, T, NearestOne>(nodes, from, nearest).walk(root);
  if (nearest.wanted() <= 8) return NearWalk<N, T, NearestFew<8>>(nodes, from, nearest).walk(root);
  return NearWalk<N, T, NearestMany>(nodes, from, nearest).walk(root);
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
