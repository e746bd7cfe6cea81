// SPDX-License-Identifier: MIT
// Checks the invariants of a Bvh's tree, and counts the nodes that a walk visits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/shape.hpp>

#include "box_worlds.hpp"

namespace graze::test {

/// Visits all nodes of a tree and records the first violation.
template <Dim N, class T>
class BvhInspection {
 public:
  using Tree = detail::BvhTree<N, T>;
  using Box = Aabb<N, T>;

  /// `expected` are the boxes in the tree, by slot; boxes without a generation in `generations` have 0.
  BvhInspection(const Tree& tree, const std::map<std::uint32_t, Box>& expected,
                const std::map<std::uint32_t, std::uint32_t>& generations = {})
      : tree_(tree), expected_(expected), generations_(generations) {
    for (const detail::BvhName& name : tree.infinite()) {
      expect(!is_valid(tree.box(name.slot)), "a finite box is in the list of infinite boxes");
      find(name);
    }
    if (!tree.root().is_none()) {
      expect(tree.parent(tree.root()) == detail::no_box, "the root has a parent");
      const std::uint32_t least = tree.root().is_leaf() ? 1 : 2;
      expect(tree.count(tree.root()) >= least, "the root should not exist");
      height_ = inspect(tree.root());
    }
    expect(found_.size() == expected.size(), "boxes are lost");
    // Two entries of the root, six of each node below.
    const double boxes = static_cast<double>(expected.size() - tree.infinite().size());
    expect(height_ < 2 || 2 * std::pow(6, static_cast<double>(height_ - 1)) <= boxes, "the tree is too tall");
  }

  /// Empty when all is well.
  const std::string& fault() const { return fault_; }
  std::size_t height() const { return height_; }
  std::size_t nodes() const { return nodes_; }

 private:
  void expect(bool holds, const char* fault) {
    if (!holds && fault_.empty()) fault_ = fault;
  }

  void find(const detail::BvhName& name) {
    expect(++found_[name.slot] == 1, "a box is in the tree twice");
    const auto wanted = expected_.find(name.slot);
    expect(wanted != expected_.end() && tree_.box(name.slot) == wanted->second,
           "a box is in the tree that should not be");
    const auto generation = generations_.find(name.slot);
    expect(name.generation == (generation == generations_.end() ? 0 : generation->second),
           "a box has a wrong generation");
  }

  /// The number of levels from this node down.
  std::size_t inspect(detail::BvhLink link) {
    ++nodes_;
    const detail::BvhNode<N, T>& node = tree_.node(link);
    const std::uint32_t count = tree_.count(link);
    expect(count <= detail::block_size, "a node has too many entries");
    expect(link == tree_.root() || count >= detail::bvh_least, "a node has too few entries");
    for (std::uint32_t lane = count; lane < detail::block_size; ++lane) {
      const Box box = detail::box_in(node.boxes, lane);
      for (Dim i = 0; i < N; ++i) {
        expect(std::isnan(box.min[i]) && std::isnan(box.max[i]), "a lane without an entry has a box");
      }
    }
    std::size_t below = 0;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const Box box = detail::box_in(node.boxes, lane);
      if (link.is_leaf()) {
        find(node.name(lane));
        expect(box == tree_.box(node.entries[lane]), "a box differs in its node");
        continue;
      }
      const auto child = detail::BvhLink::of_code(node.entries[lane]);
      expect(tree_.parent(child) == link.index(), "a node has a wrong parent");
      inspect_bounds(box, child);
      const std::size_t height = inspect(child);
      expect(lane == 0 || height == below, "leaf nodes have different depths");
      below = height;
    }
    return below + 1;
  }

  void inspect_bounds(const Box& bounds, detail::BvhLink child) {
    Box around = Box::nothing();
    for (std::uint32_t lane = 0; lane < tree_.count(child); ++lane) {
      detail::grow_at_once(around, detail::box_in(tree_.node(child).boxes, lane));
    }
    if (child.is_leaf() && tree_.margin() > 0) {
      expect(detail::covers(bounds, around), "bounds do not contain what is below");
      expect(detail::covers(detail::grown_by(around, 5 * tree_.margin()), bounds), "bounds are far too large");
    } else {
      expect(bounds == around, "bounds are not tight");
    }
  }

  const Tree& tree_;
  const std::map<std::uint32_t, Box>& expected_;
  const std::map<std::uint32_t, std::uint32_t> generations_;
  std::map<std::uint32_t, int> found_;
  std::string fault_;
  std::size_t height_ = 0;
  std::size_t nodes_ = 0;
};

/// A region that counts the visited nodes except the root.
template <Dim N, class T>
struct CountingRegion {
  static constexpr bool is_box = false;

  Aabb<N, T> region;
  mutable std::size_t looks = 0;

  Aabb<N, T> reach(double /*size*/) const { return region; }
  bool may_meet_closely(const Aabb<N, T>&) const {
    ++looks;
    return true;
  }
  bool meets(const Aabb<N, T>& box) const { return boxes_overlap(region, box); }
};

/// The number of nodes visited by a query, and what it found.
struct Effort {
  std::size_t looks = 0;
  std::size_t found = 0;
};

template <Dim N, class T>
Effort effort_of(const detail::BvhTree<N, T>& tree, const Aabb<N, T>& region) {
  const CountingRegion<N, T> probe{region};
  std::size_t found = 0;
  detail::visit_met(tree, probe, [&found](const detail::BvhName&) { return ++found > 0; });
  return {probe.looks + 1, found};
}

/// The number of nodes visited to find the first box on a ray.
template <Dim N>
std::size_t looks_along(const detail::BvhTree<N, float>& tree, const Ray<N>& ray) {
  detail::BvhFirstWalk<N, float> walk{ray, detail::slabs_of(ray, 0), std::numeric_limits<double>::infinity(), {0, 0}};
  return detail::bvh_kernels<N, float>().find_first(tree.nodes(), tree.root(), walk);
}

/// Rays aimed at some of the boxes, from outside along an axis and from inside.
template <Dim N>
std::vector<Ray<N>> rays_at(const std::vector<Aabb<N>>& boxes, const Aabb<N>& bounds) {
  Numbers numbers(boxes.size());
  std::vector<Ray<N>> rays;
  for (std::size_t k = 0; k < 32; ++k) {
    const Vec<N> target = boxes[k * 997 % boxes.size()].center();
    Vec<N> origin = target;
    for (Dim i = 0; i < N; ++i) {
      if (k % 2 == 0) origin[i] = static_cast<float>(numbers.between(bounds.min[i] - 1, bounds.max[i] + 1));
    }
    const auto axis = static_cast<Dim>(k / 4 % N);
    if (k % 4 == 1) origin[axis] = bounds.min[axis] - 1;
    if (k % 4 == 3) origin[axis] = bounds.max[axis] + 1;
    if (origin != target) rays.push_back({origin, target - origin});
  }
  return rays;
}

}  // namespace graze::test
