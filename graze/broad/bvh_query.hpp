// SPDX-License-Identifier: MIT
// How a BvhTree is walked. Whoever asks says what a box is worth, and so can count how many were looked at.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_tree.hpp>
#include <graze/broad/short_list.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// Calls visit(slot) for every box in the tree that `probe` (a RegionProbe, or what counts as one) says is met, until
/// it returns false. Returns whether it never did.
template <Dim N, class T, class Probe, class Visit>
bool visit_met(const BvhTree<N, T>& tree, const Probe& probe, const Visit& visit) {
  for (const std::uint32_t slot : tree.infinite()) {
    if (probe.meets(tree.box(slot)) && !visit(slot)) return false;
  }
  constexpr std::uint32_t worth_a_close_look = 8;
  const bool leaves_are_exact = tree.margin() == 0;
  ShortList<std::uint32_t, bvh_path> open;
  const auto look = [&](const Aabb<N, T>& bounds, BvhChild child, bool may_meet) {
    if (!child.is_leaf()) {
      open.push_if(may_meet, child.index());
      return true;
    }
    if (!may_meet) return true;
    return !probe.meets(leaves_are_exact ? bounds : tree.box(child.index())) || visit(child.index());
  };
  if (!tree.child(0).is_none() && !look(tree.bounds(0), tree.child(0), probe.may_meet(tree.bounds(0)))) return false;
  while (!open.empty()) {
    const BvhNode<N, T>& node = tree.node(open.pop());
    if (node.count >= worth_a_close_look && !probe.may_meet_closely(box_around(node.boxes[0], node.boxes[1]))) continue;
    const bool first = probe.may_meet(node.boxes[0]);
    const bool second = probe.may_meet(node.boxes[1]);
    if (!look(node.boxes[0], node.children[0], first) || !look(node.boxes[1], node.children[1], second)) return false;
  }
  return true;
}

/// What a walk in order of rank still has to look at: a node, or a box by its slot. A rank is the t at which a ray
/// enters, or a distance. Without initial values, so that room for many costs nothing.
struct BvhRanked {
  double rank;
  std::uint32_t index;
  bool is_box;

  /// A node before boxes of the same rank: it may hold one that comes before them.
  struct Before {
    bool operator()(const BvhRanked& a, const BvhRanked& b) const {
      if (a.rank != b.rank) return a.rank < b.rank;
      return a.is_box != b.is_box ? b.is_box : a.index < b.index;
    }
  };
};

/// All that a walk still has to look at. The one that came last is apart from the heap: mostly it comes next.
class BvhFront {
 public:
  bool empty() const { return !has_last_ && others_.empty(); }

  void push(const BvhRanked& one) {
    if (has_last_) others_.push(last_);
    last_ = one;
    has_last_ = true;
  }

  BvhRanked pop() {
    const bool last_is_next = has_last_ && (others_.empty() || BvhRanked::Before{}(last_, others_.top()));
    if (!last_is_next) return others_.pop();
    has_last_ = false;
    return last_;
  }

 private:
  BvhRanked last_{};
  bool has_last_ = false;
  ShortHeap<BvhRanked, 2 * bvh_path, BvhRanked::Before> others_;
};

/// A box that a ray enters.
struct BvhHit {
  double t;
  std::uint32_t slot;

  friend auto operator<=>(const BvhHit&, const BvhHit&) = default;
};

/// The first box that a ray enters, of equal ones that of the lowest slot. The nearer side of a node first, and what
/// waits is passed by when a box was found before it: without a heap, in three quarters of the time that one takes to
/// its first box.
template <Dim N, class T, class Probe>
std::optional<BvhHit> first_along(const BvhTree<N, T>& tree, const Probe& ray) {
  struct Waiting {
    double soonest;
    std::uint32_t node;
  };
  BvhHit first{std::numeric_limits<double>::infinity(), 0};
  const auto look_at_box = [&](std::uint32_t slot, const Aabb<N, T>& box) {
    const std::optional<double> t = ray.entry(box);
    if (t && BvhHit{*t, slot} < first) first = {*t, slot};
  };
  for (const std::uint32_t slot : tree.infinite()) look_at_box(slot, tree.box(slot));
  const bool leaves_are_exact = tree.margin() == 0;
  ShortList<Waiting, bvh_path> open;
  const auto look = [&](std::optional<double> soonest, const Aabb<N, T>& bounds, BvhChild child) {
    if (!soonest || *soonest > first.t) return;
    if (child.is_leaf()) return look_at_box(child.index(), leaves_are_exact ? bounds : tree.box(child.index()));
    tree.prefetch(child.index());
    open.push({*soonest, child.index()});
  };
  if (!tree.child(0).is_none()) look(ray.soonest(tree.bounds(0)), tree.bounds(0), tree.child(0));
  while (!open.empty()) {
    const Waiting next = open.pop();
    if (next.soonest > first.t) continue;
    const BvhNode<N, T>& node = tree.node(next.node);
    const std::array soonest = {ray.soonest(node.boxes[0]), ray.soonest(node.boxes[1])};
    const std::size_t far = soonest[0] < soonest[1] ? 1 : 0;
    look(soonest[far], node.boxes[far], node.children[far]);
    look(soonest[1 - far], node.boxes[1 - far], node.children[1 - far]);
  }
  if (std::isinf(first.t)) return std::nullopt;
  return first;
}

/// Calls visit(slot, t) for every box that a ray enters after another, in order of t, equal ones by slot, until it
/// returns false.
template <Dim N, class T, class Probe, class Visit>
void visit_along_after(const BvhTree<N, T>& tree, const Probe& ray, const BvhHit& former, const Visit& visit) {
  BvhFront open;
  const auto look_at_leaf = [&](std::uint32_t slot) {
    const std::optional<double> t = ray.entry(tree.box(slot));
    if (t && former < BvhHit{*t, slot}) open.push({*t, slot, true});
  };
  for (const std::uint32_t slot : tree.infinite()) look_at_leaf(slot);
  const auto look = [&](std::optional<double> soonest, BvhChild child) {
    if (!soonest) return;
    if (child.is_leaf()) return look_at_leaf(child.index());
    tree.prefetch(child.index());
    open.push({*soonest, child.index(), false});
  };
  if (!tree.child(0).is_none()) look(0.0, tree.child(0));
  while (!open.empty()) {
    const BvhRanked next = open.pop();
    if (next.is_box) {
      if (!visit(next.index, next.rank)) return;
      continue;
    }
    const BvhNode<N, T>& node = tree.node(next.index);
    const std::array soonest = {ray.soonest(node.boxes[0]), ray.soonest(node.boxes[1])};
    const std::size_t far = soonest[0] < soonest[1] ? 1 : 0;
    look(soonest[far], node.children[far]);
    look(soonest[1 - far], node.children[1 - far]);
  }
}

/// Calls visit(slot, t) for every box that a ray enters, in order of t, equal ones by slot, until it returns false.
/// `ray` (a RayProbe, or what counts as one) says what it enters. Most want the first box only, which is found quicker
/// by itself.
template <Dim N, class T, class Probe, class Visit>
void visit_along(const BvhTree<N, T>& tree, const Probe& ray, const Visit& visit) {
  const std::optional<BvhHit> first = first_along(tree, ray);
  if (first && visit(first->slot, first->t)) visit_along_after(tree, ray, *first, visit);
}

/// Calls offer(slot, distance squared) for boxes near a point until the nearest of what is left is beyond reach().
template <Dim N, class T, class Offer, class Reach>
void visit_near(const BvhTree<N, T>& tree, const Vec<N, T>& point, const Offer& offer, const Reach& reach) {
  BvhFront open;
  for (const std::uint32_t slot : tree.infinite()) offer(slot, distance_squared(point, tree.box(slot)));
  const bool leaves_are_exact = tree.margin() == 0;
  const auto look = [&](double distance, BvhChild child) {
    if (distance > reach()) return;
    if (!child.is_leaf()) {
      tree.prefetch(child.index());
      return open.push({distance, child.index(), false});
    }
    offer(child.index(), leaves_are_exact ? distance : distance_squared(point, tree.box(child.index())));
  };
  if (!tree.child(0).is_none()) look(distance_squared(point, tree.bounds(0)), tree.child(0));
  while (!open.empty()) {
    const BvhRanked next = open.pop();
    if (next.rank > reach()) return;
    const BvhNode<N, T>& node = tree.node(next.index);
    const std::array distances = {distance_squared(point, node.boxes[0]), distance_squared(point, node.boxes[1])};
    const std::size_t near = distances[1] < distances[0] ? 1 : 0;
    look(distances[near], node.children[near]);
    look(distances[1 - near], node.children[1 - near]);
  }
}

/// A ray during one query.
template <Dim N, class T>
class RayProbe {
 public:
  explicit RayProbe(const Ray<N, T>& ray) : ray_(ray) {
    for (Dim i = 0; i < N; ++i) {
      origin_[i] = static_cast<double>(ray.origin[i]);
      inverse_[i] = 1 / static_cast<double>(ray.direction[i]);
      has_inverse_ = has_inverse_ && std::isfinite(inverse_[i]);
    }
  }

  std::optional<double> entry(const Aabb<N, T>& box) const { return entry_of(ray_, box); }

  /// No box within finite bounds has an entry before this; none if none has one. As entry_of, but with a product where
  /// that has a quotient: off by a rounding more, or, where numbers are so small that they round coarsely, by as much
  /// as the smallest.
  std::optional<double> soonest(const Aabb<N, T>& bounds) const {
    if (!has_inverse_) return entry_of(ray_, bounds);
    constexpr double smallest = std::numeric_limits<double>::min();
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();
    for (Dim i = 0; i < N; ++i) {
      const T near = inverse_[i] < 0 ? bounds.max[i] : bounds.min[i];
      const T far = inverse_[i] < 0 ? bounds.min[i] : bounds.max[i];
      enter = std::max(enter, (static_cast<double>(near) - origin_[i]) * inverse_[i]);
      leave = std::min(leave, (static_cast<double>(far) - origin_[i]) * inverse_[i]);
    }
    if (!(enter <= leave * (1 + tolerance::ray_bounds) + smallest)) return std::nullopt;
    return std::min(enter, std::numeric_limits<double>::max()) * (1 - tolerance::ray_bounds) - smallest;
  }

 private:
  const Ray<N, T>& ray_;
  Vec<N, double> origin_;
  Vec<N, double> inverse_;
  bool has_inverse_ = true;
};

}  // namespace graze::detail
