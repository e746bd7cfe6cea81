// SPDX-License-Identifier: MIT
// Tried: the manager with pointers instead of arrays (1.4 times as slow), telling it of each object that moved (three
// times), and building the tree anew from the top (twice) or by Morton codes (twice).
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/config.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

/// An object of FCL whose box is given, not calculated from a shape and its place, which would round.
template <class T>
class BoxObject final : public fcl::CollisionObject<T> {
 public:
  BoxObject(const std::shared_ptr<fcl::CollisionGeometry<T>>& geometry, std::size_t index)
      : fcl::CollisionObject<T>(geometry), index_(index) {}

  std::size_t index() const { return index_; }
  void place(const Aabb<3, T>& box) {
    this->aabb.min_ = {box.min[0], box.min[1], box.min[2]};
    this->aabb.max_ = {box.max[0], box.max[1], box.max[2]};
  }

 private:
  std::size_t index_;
};

/// The tree is built at the start; in every frame its boxes are fitted to where the objects are now. Its shape ages
/// with that, which the few frames of a race do not show.
template <class T>
class DynamicTree final : public Contestant<3, T> {
 public:
  explicit DynamicTree(std::span<const Aabb<3, T>> boxes) {
    const auto geometry = std::make_shared<fcl::Box<T>>(T(1), T(1), T(1));
    objects_.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      objects_.push_back(std::make_unique<BoxObject<T>>(geometry, i));
      objects_.back()->place(boxes[i]);
      pointers_.push_back(objects_.back().get());
    }
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  std::span<const Pair> find(std::span<const Aabb<3, T>> boxes) override {
    pairs_.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i) objects_[i]->place(boxes[i]);
    manager_.update();
    manager_.collide(&pairs_, take);
    return pairs_;
  }

 private:
  /// False lets FCL go on.
  static bool take(fcl::CollisionObject<T>* one, fcl::CollisionObject<T>* other, void* pairs) {
    static_cast<std::vector<Pair>*>(pairs)->push_back(ascending(index_of(one), index_of(other)));
    return false;
  }
  static std::size_t index_of(const fcl::CollisionObject<T>* object) {
    return static_cast<const BoxObject<T>*>(object)->index();
  }

  std::vector<std::unique_ptr<BoxObject<T>>> objects_;
  std::vector<fcl::CollisionObject<T>*> pointers_;
  fcl::DynamicAABBTreeCollisionManager_Array<T> manager_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_fcl(Entrants<N, T>& field) {
  if constexpr (N == 3) {
    Entrant<N, T> entrant;
    entrant.name = "FCL DynamicAABBTree_Array";
    entrant.settings = "FCL " FCL_VERSION ", the tree kept and refitted";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<DynamicTree<T>>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_fcl(Entrants<2, float>& field);
template void enter_fcl(Entrants<2, double>& field);
template void enter_fcl(Entrants<3, float>& field);
template void enter_fcl(Entrants<3, double>& field);

}  // namespace graze::race
