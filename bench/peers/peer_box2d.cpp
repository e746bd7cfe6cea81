// SPDX-License-Identifier: MIT
// Tried: passing each box's displacement to the tree, and a new tree in every frame; neither is faster.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <box2d/b2_common.h>
#include <box2d/b2_dynamic_tree.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

using Boxes = std::span<const Aabb<2, float>>;

b2AABB as_b2(const Aabb<2, float>& box) {
  b2AABB result;
  result.lowerBound.Set(box.min[0], box.min[1]);
  result.upperBound.Set(box.max[0], box.max[1]);
  return result;
}

/// Collects the leaves that a query meets.
struct Leaves {
  std::vector<std::int32_t> nodes;

  /// The name that Box2D requires. Returning true continues the query.
  bool QueryCallback(std::int32_t node) {  // NOLINT(readability-identifier-naming)
    nodes.push_back(node);
    return true;
  }
};

/// Box2D's broad phase reports only new pairs, so its tree is queried directly, once for each box. Boxes in the tree
/// are enlarged by b2_aabbExtension, so that they need not be reinserted with every move; every hit is tested. Boxes
/// are inserted, moved and queried in the order of the leaves of a first tree, so that neighbours are adjacent in
/// memory and in time; index order takes up to twice as long.
class DynamicTree final : public Contestant<2, float> {
 public:
  explicit DynamicTree(Boxes boxes) {
    b2DynamicTree first;
    std::vector<std::uint32_t> boxes_of_first(2 * boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      boxes_of_first[static_cast<std::size_t>(first.CreateProxy(as_b2(boxes[i]), nullptr))] = i;
    }
    Leaves leaves;
    first.Query(&leaves, as_b2(Aabb<2, float>::everything()));
    index_of_.resize(2 * boxes.size());
    for (const std::int32_t leaf : leaves.nodes) {
      const std::uint32_t i = boxes_of_first[static_cast<std::size_t>(leaf)];
      const std::int32_t node = tree_.CreateProxy(as_b2(boxes[i]), nullptr);
      nodes_.push_back(node);
      index_of_[static_cast<std::size_t>(node)] = i;
    }
  }

  std::span<const Pair> find(Boxes boxes) override {
    pairs_.clear();
    for (const std::int32_t node : nodes_) tree_.MoveProxy(node, as_b2(boxes[index_of(node)]), b2Vec2(0, 0));
    for (const std::int32_t node : nodes_) {
      const std::uint32_t i = index_of(node);
      hits_.nodes.clear();
      tree_.Query(&hits_, as_b2(boxes[i]));
      for (const std::int32_t hit : hits_.nodes) {
        const std::uint32_t j = index_of(hit);
        if (i < j && boxes_overlap(boxes[i], boxes[j])) pairs_.push_back({i, j});
      }
    }
    return pairs_;
  }

 private:
  std::uint32_t index_of(std::int32_t node) const { return index_of_[static_cast<std::size_t>(node)]; }

  b2DynamicTree tree_;
  std::vector<std::int32_t> nodes_;      // the leaves, in the order of the first tree
  std::vector<std::uint32_t> index_of_;  // by node; n boxes make at most 2n - 1 nodes
  Leaves hits_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_box2d(Entrants<N, T>& field) {
  if constexpr (N == 2 && std::is_same_v<T, float>) {
    Entrant<N, T> entrant;
    entrant.name = "Box2D b2DynamicTree";
    entrant.keeps = true;
    entrant.settings = "Box2D " + std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
                       std::to_string(b2_version.revision) +
                       ", the tree kept and its boxes moved, queried in its order";
    entrant.most_boxes = 1'000'000;
    entrant.why_no_more = "building the tree takes minutes";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<DynamicTree>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_box2d(Entrants<2, float>& field);
template void enter_box2d(Entrants<2, double>& field);
template void enter_box2d(Entrants<3, float>& field);
template void enter_box2d(Entrants<3, double>& field);

}  // namespace graze::race
