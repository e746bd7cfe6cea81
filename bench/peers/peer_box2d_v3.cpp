// SPDX-License-Identifier: MIT
// Box2D 3, a rewrite in C; compiled instead of peer_box2d.cpp if CMake finds it. Tried: b2DynamicTree_MoveProxy, with
// and without a margin, and a full rebuild in every frame; all take up to twice as long.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <box2d/base.h>
#include <box2d/collision.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

using Boxes = std::span<const Aabb<2, float>>;
using Numbers = std::vector<std::uint32_t>;

constexpr float margin = 0.1F;  // for boxes of about unit size; 0.02 and 0.2 are no faster
constexpr std::uint64_t any_category = 1;

b2AABB as_b2(const Aabb<2, float>& box, float enlarged_by) {
  return {{box.min[0] - enlarged_by, box.min[1] - enlarged_by}, {box.max[0] + enlarged_by, box.max[1] + enlarged_by}};
}

bool contains(const b2AABB& outer, const Aabb<2, float>& box) {
  return outer.lowerBound.x <= box.min[0] && outer.lowerBound.y <= box.min[1] && box.max[0] <= outer.upperBound.x &&
         box.max[1] <= outer.upperBound.y;
}

/// A tree of enlarged boxes, used as by b2World_Step: a box that has left its enlarged one enlarges the nodes above it,
/// and then the changed part of the tree is rebuilt.
class Tree {
 public:
  Tree(Boxes boxes, const Numbers& order)
      : tree_(b2DynamicTree_Create(static_cast<int>(boxes.size()))), proxies_(boxes.size()) {
    for (const std::uint32_t i : order) {
      proxies_[i] = b2DynamicTree_CreateProxy(&tree_, as_b2(boxes[i], margin), any_category, i);
    }
    b2DynamicTree_Rebuild(&tree_, true);
  }
  ~Tree() { b2DynamicTree_Destroy(&tree_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  /// The numbers of the boxes in the order of the leaves.
  Numbers leaves() const {
    Numbers numbers;
    const auto take = [](int /*proxy*/, std::uint64_t number, void* list) {
      static_cast<Numbers*>(list)->push_back(static_cast<std::uint32_t>(number));
      return true;  // continues the query
    };
    b2DynamicTree_QueryAll(&tree_, b2DynamicTree_GetRootBounds(&tree_), take, &numbers);
    return numbers;
  }

  void move(Boxes boxes, const Numbers& order) {
    for (const std::uint32_t i : order) {
      if (contains(b2DynamicTree_GetAABB(&tree_, proxies_[i]), boxes[i])) continue;
      b2DynamicTree_EnlargeProxy(&tree_, proxies_[i], as_b2(boxes[i], margin));
    }
    b2DynamicTree_Rebuild(&tree_, false);
  }

  /// Appends the pairs of box i and those with greater numbers.
  void find(Boxes boxes, std::uint32_t i, std::vector<Pair>& pairs) const {
    struct Query {
      Boxes boxes;
      std::uint32_t i;
      std::vector<Pair>& pairs;
    } query{boxes, i, pairs};
    const auto take = [](int /*proxy*/, std::uint64_t number, void* context) {
      const Query& asked = *static_cast<const Query*>(context);
      const auto j = static_cast<std::uint32_t>(number);
      if (asked.i < j && boxes_overlap(asked.boxes[asked.i], asked.boxes[j])) asked.pairs.push_back({asked.i, j});
      return true;  // continues the query
    };
    b2DynamicTree_Query(&tree_, as_b2(boxes[i], 0), any_category, take, &query);
  }

 private:
  b2DynamicTree tree_;
  std::vector<int> proxies_;
};

/// Boxes are inserted, moved and queried in the order of the leaves of a first tree, so that neighbours are adjacent in
/// memory and in time.
class DynamicTree final : public Contestant<2, float> {
 public:
  explicit DynamicTree(Boxes boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    order_ = Tree(boxes, order_).leaves();
    tree_ = std::make_unique<Tree>(boxes, order_);
  }

  std::span<const Pair> find(Boxes boxes) override {
    pairs_.clear();
    tree_->move(boxes, order_);
    for (const std::uint32_t i : order_) tree_->find(boxes, i, pairs_);
    return pairs_;
  }

 private:
  Numbers order_;
  std::unique_ptr<Tree> tree_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_box2d(Entrants<N, T>& field) {
  if constexpr (N == 2 && std::is_same_v<T, float>) {
    const b2Version version = b2GetVersion();
    Entrant<N, T> entrant;
    entrant.name = "Box2D b2DynamicTree";
    entrant.keeps = true;
    entrant.settings =
        "Box2D " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
        std::to_string(version.revision) +
        ", the tree kept, its boxes enlarged by 0.1 and rebuilt where they leave them, queried in its order";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<DynamicTree>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_box2d(Entrants<2, float>& field);
template void enter_box2d(Entrants<2, double>& field);
template void enter_box2d(Entrants<3, float>& field);
template void enter_box2d(Entrants<3, double>& field);

}  // namespace graze::race
