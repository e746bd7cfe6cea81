// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <memory>

#include <box2d/b2_common.h>
#include <box2d/b2_dynamic_tree.h>

#include <graze/broad/spatial_index.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

b2Vec2 vector(const Point<2>& p) { return {p.x, p.y}; }

b2AABB bounds(const Box<2>& box) {
  b2AABB result;
  result.lowerBound = vector(box.min);
  result.upperBound = vector(box.max);
  return result;
}

/// Boxes in the tree are enlarged by b2_aabbExtension, so hits are tested.
class DynamicTree {
 public:
  void build(std::span<const Box<2>> boxes) {
    boxes_.assign(boxes.begin(), boxes.end());
    tree_ = std::make_unique<b2DynamicTree>();
    proxies_.clear();
    number_of_.assign(2 * boxes.size() + 16, 0);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      proxies_.push_back(tree_->CreateProxy(bounds(boxes[k]), nullptr));
      number_of_[static_cast<std::size_t>(proxies_.back())] = static_cast<std::uint32_t>(k);
    }
  }
  void move(std::span<const Box<2>> boxes, const Share& share) {
    for (std::size_t k = share.first; k < boxes.size(); k += share.step) {
      boxes_[k] = boxes[k];
      tree_->MoveProxy(proxies_[k], bounds(boxes[k]), b2Vec2(0, 0));
    }
  }
  template <class Visit>
  void query(const Box<2>& region, const Visit& visit) const {
    struct Callback {
      bool QueryCallback(std::int32_t proxy) {  // NOLINT(readability-identifier-naming): Box2D's name for it
        const std::size_t number = tree.number_of_[static_cast<std::size_t>(proxy)];
        if (boxes_overlap(region, tree.boxes_[number])) visit(number);
        return true;
      }
      const DynamicTree& tree;
      const Box<2>& region;
      const Visit& visit;
    } callback{*this, region, visit};
    tree_->Query(&callback, bounds(region));
  }
  double first_hit(const Ray<2>& ray) const {
    constexpr float length = 1e4F;  // longer than any path through the scene
    struct Callback {
      float RayCastCallback(const b2RayCastInput& input, std::int32_t proxy) {  // NOLINT(readability-identifier-naming)
        const auto t = graze::detail::entry_of(ray, boxes[number_of[static_cast<std::size_t>(proxy)]]);
        if (!t || !(*t < first)) return input.maxFraction;
        first = *t;
        if (first == 0) return 0;
        return static_cast<float>((first + 1e-3) / static_cast<double>(length));  // margin for Box2D's rounding
      }
      const Ray<2>& ray;
      const std::vector<Box<2>>& boxes;
      const std::vector<std::uint32_t>& number_of;
      double first = std::numeric_limits<double>::infinity();
    } callback{ray, boxes_, number_of_};
    tree_->RayCast(&callback, {vector(ray.origin), vector(ray.origin + ray.direction * length), 1});
    return callback.first;
  }

 private:
  std::vector<Box<2>> boxes_;
  std::unique_ptr<b2DynamicTree> tree_;
  std::vector<std::int32_t> proxies_;
  std::vector<std::uint32_t> number_of_;  // by proxy
};

}  // namespace

template <Dim N>
void enter_box2d(Entrants<N>& field) {
  if constexpr (N == 2) field.push_back(entrant<2, DynamicTree>("Box2D"));
}

template void enter_box2d(Entrants<2>&);
template void enter_box2d(Entrants<3>&);

}  // namespace bench
