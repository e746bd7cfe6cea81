// SPDX-License-Identifier: MIT
// Walks of a BvhTree.
#pragma once

#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// Calls visit(name) for every box in the tree that shares a point with `region`, until it returns false. Returns false
/// if it did.
template <Dim N, class T, class Visit>
bool visit_in_box(const BvhTree<N, T>& tree, const Aabb<N, T>& region, const Visit& visit) {
  BvhMetWalk<N, T> walk;
  walk.region = region;
  walk.open[0] = tree.root().code();
  walk.open_count = 1;
  while (walk.open_count > 0) {
    walk.found_count = 0;
    bvh_kernels<N, T>().find_overlapping(tree.nodes(), walk);
    for (std::size_t k = 0; k < walk.found_count; ++k) {
      if (!visit(BvhName{walk.found[k], walk.generations[k]})) return false;
    }
  }
  return true;
}

/// Calls visit(name) for every box in the tree that meets the region of `probe`, as above. Prunes nodes by
/// may_meet_closely.
template <Dim N, class T, class Probe, class Visit>
bool visit_closely(const BvhTree<N, T>& tree, const Probe& probe, const Visit& visit) {
  const auto met = bvh_kernels<N, T>().met;
  const Aabb<N, T> reach = probe.reach(finite_size(tree.bounds()));
  ShortList<BvhLink, bvh_path> open;
  open.push(tree.root());
  while (!open.empty()) {
    const BvhLink link = open.pop();
    const BvhNode<N, T>& node = tree.node(link);
    for (std::uint32_t lanes = met(node.boxes, reach); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (link.is_leaf()) {
        if (probe.meets(box_in(node.boxes, lane)) && !visit(node.name(lane))) return false;
      } else if (probe.may_meet_closely(box_in(node.boxes, lane))) {
        open.push(BvhLink::of_code(node.entries[lane]));
      }
    }
  }
  return true;
}

/// Calls visit(name) for every box that meets the region of `probe` (a RegionProbe or a class with its interface),
/// until it returns false. Returns false if it did.
template <Dim N, class T, class Probe, class Visit>
bool visit_met(const BvhTree<N, T>& tree, const Probe& probe, const Visit& visit) {
  for (const BvhName& name : tree.infinite()) {
    if (probe.meets(tree.box(name.slot)) && !visit(name)) return false;
  }
  if (tree.root().is_none()) return true;
  if constexpr (Probe::is_box) {
    return visit_in_box(tree, probe.reach(0), visit);
  } else {
    return visit_closely(tree, probe, visit);
  }
}

/// A box that a ray enters.
struct BvhHit {
  double t;
  BvhName name;

  friend bool operator==(const BvhHit&, const BvhHit&) = default;
  friend bool operator<(const BvhHit& a, const BvhHit& b) { return a.t != b.t ? a.t < b.t : a.name.slot < b.name.slot; }
};

/// Prepares a ray for boxes of a tree whose largest coordinate is known. Chooses safe methods where differences or
/// inverses might overflow.
template <Dim N, class T>
BvhSlabs<N, T> slabs_of(const Ray<N, T>& ray, double size) {
  constexpr auto most = static_cast<double>(most_for_slabs<T>);
  BvhSlabs<N, T> slabs;
  for (Dim i = 0; i < N; ++i) {
    slabs.origin[i] = ray.origin[i];
    slabs.inverse[i] = static_cast<T>(1 / static_cast<double>(ray.direction[i]));
    const bool is_usual =
        std::isnormal(slabs.inverse[i]) && size < most && std::fabs(static_cast<double>(ray.origin[i])) < most;
    slabs.kinds[i] = ray.direction[i] == T(0) ? BvhSlab::parallel : is_usual ? BvhSlab::crossed : BvhSlab::any;
  }
  return slabs;
}

/// The first box that a ray enters; ties go to the lowest slot.
template <Dim N, class T>
std::optional<BvhHit> first_along(const BvhTree<N, T>& tree, const Ray<N, T>& ray) {
  BvhHit first{std::numeric_limits<double>::infinity(), {0, 0}};
  for (const BvhName& name : tree.infinite()) {
    const std::optional<double> t = entry_of(ray, tree.box(name.slot));
    if (t && BvhHit{*t, name} < first) first = {*t, name};
  }
  if (!tree.root().is_none()) {
    BvhFirstWalk<N, T> walk{ray, slabs_of(ray, 0), first.t, first.name};
    bvh_kernels<N, T>().find_first(tree.nodes(), tree.root(), walk);
    first = {walk.t, walk.name};
  }
  if (std::isinf(first.t)) return std::nullopt;
  return first;
}

/// What a walk in order of rank has yet to visit: a node by its link's code, or a box by its slot. The rank is the t at
/// which the ray enters. Members are uninitialised, because arrays of them are large.
struct BvhRanked {
  double rank;
  std::uint32_t index;
  std::uint32_t generation;
  bool is_box;

  /// Nodes come before boxes of the same rank: a node may contain a box that precedes them.
  struct Before {
    bool operator()(const BvhRanked& a, const BvhRanked& b) const {
      if (a.rank != b.rank) return a.rank < b.rank;
      return a.is_box != b.is_box ? b.is_box : a.index < b.index;
    }
  };
};

/// Calls visit(name, t) for every box that a ray enters, in order of t, ties by slot, until it returns false.
template <Dim N, class T, class Visit>
void visit_along_after(const BvhTree<N, T>& tree, const Ray<N, T>& ray, const BvhHit& former, const Visit& visit) {
  ShortHeap<BvhRanked, bvh_path, BvhRanked::Before> open;
  const auto look_at_box = [&](const BvhName& name, const Aabb<N, T>& box) {
    const std::optional<double> t = entry_of(ray, box);
    if (t && former < BvhHit{*t, name}) open.push({*t, name.slot, name.generation, true});
  };
  for (const BvhName& name : tree.infinite()) look_at_box(name, tree.box(name.slot));
  if (!tree.root().is_none()) open.push({0, tree.root().code(), 0, false});
  const BvhSlabs<N, T> slabs = tree.root().is_none() ? BvhSlabs<N, T>{} : slabs_of(ray, finite_size(tree.bounds()));
  const auto entered = bvh_kernels<N, T>().entered;
  alignas(64) T soonest[block_size];
  while (!open.empty()) {
    const BvhRanked next = open.pop();
    if (next.is_box) {
      if (!visit(BvhName{next.index, next.generation}, next.rank)) return;
      continue;
    }
    const BvhLink link = BvhLink::of_code(next.index);
    const BvhNode<N, T>& node = tree.node(link);
    for (std::uint32_t lanes = entered(node.boxes, slabs, soonest); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      if (link.is_leaf()) {
        look_at_box(node.name(lane), box_in(node.boxes, lane));
      } else {
        open.push({static_cast<double>(soonest[lane]), node.entries[lane], 0, false});
      }
    }
  }
}

/// The same. The first box is searched separately, because this is faster and most callers need only that one.
template <Dim N, class T, class Visit>
void visit_along(const BvhTree<N, T>& tree, const Ray<N, T>& ray, const Visit& visit) {
  const std::optional<BvhHit> first = first_along(tree, ray);
  if (first && visit(first->name, first->t)) visit_along_after(tree, ray, *first, visit);
}

/// Calls visit(name, t) for every box that a moving box touches, by time(box), ties by slot. What it returns is the t
/// up to which it is interested in further boxes. `time` is `sweep.touch` or `sweep.entry`.
template <Dim N, class T, class Time, class Visit>
void visit_swept(const BvhTree<N, T>& tree, const SweptBox<N>& sweep, const Time& time, const Visit& visit) {
  ShortHeap<BvhRanked, bvh_path, BvhRanked::Before> open;
  double limit = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Aabb<N, T>& box, const BvhRanked& ranked) {
    const std::optional<double> t = time(box);
    if (t && *t <= limit) open.push({*t, ranked.index, ranked.generation, ranked.is_box});
  };
  for (const BvhName& name : tree.infinite()) look_at(tree.box(name.slot), {0, name.slot, name.generation, true});
  Aabb<N, T> reach = Aabb<N, T>::nothing();
  if (!tree.root().is_none()) {
    reach = sweep.template reach<T>(finite_size(tree.bounds()));
    open.push({0, tree.root().code(), 0, false});
  }
  const auto met = bvh_kernels<N, T>().met;
  while (!open.empty() && open.top().rank <= limit) {
    const BvhRanked next = open.pop();
    if (next.is_box) {
      limit = visit(BvhName{next.index, next.generation}, next.rank);
      continue;
    }
    const BvhLink link = BvhLink::of_code(next.index);
    const BvhNode<N, T>& node = tree.node(link);
    for (std::uint32_t lanes = met(node.boxes, reach); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const std::uint32_t generation = link.is_leaf() ? node.generations[lane] : 0;
      look_at(box_in(node.boxes, lane), {0, node.entries[lane], generation, link.is_leaf()});
    }
  }
}

/// Offers the boxes near a box to `nearest`, by keys without an owner, until the rest is beyond its reach. Returns the
/// number of nodes visited.
template <Dim N, class T>
std::size_t find_near(const BvhTree<N, T>& tree, const Aabb<N, T>& from, NearestKeys& nearest) {
  for (const BvhName& name : tree.infinite()) {
    nearest.offer({{name.slot, name.generation, 0}, distance_squared(from, tree.box(name.slot))});
  }
  if (tree.root().is_none()) return 0;
  return bvh_kernels<N, T>().find_near(tree.nodes(), tree.root(), from, nearest);
}

/// The same near a point: the distances are those of distance_squared.
template <Dim N, class T>
std::size_t find_near(const BvhTree<N, T>& tree, const Vec<N, T>& point, NearestKeys& nearest) {
  return find_near(tree, Aabb<N, T>{point, point}, nearest);
}

}  // namespace graze::detail
