// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <memory>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <graze/shape/aabb.hpp>

namespace bench {

/// A numbered object of FCL with a given box, not one calculated from its shape and pose, which would round.
template <class T>
class FclBox final : public fcl::CollisionObject<T> {
 public:
  explicit FclBox(std::size_t number) : fcl::CollisionObject<T>(any_geometry()), number_(number) {}

  std::size_t number() const { return number_; }
  void place(const graze::Aabb<3, T>& box) {
    this->aabb.min_ = {box.min[0], box.min[1], box.min[2]};
    this->aabb.max_ = {box.max[0], box.max[1], box.max[2]};
  }

  static std::size_t number_of(const fcl::CollisionObject<T>* object) {
    return static_cast<const FclBox*>(object)->number();
  }

 private:
  static const std::shared_ptr<fcl::CollisionGeometry<T>>& any_geometry() {
    static const std::shared_ptr<fcl::CollisionGeometry<T>> geometry = std::make_shared<fcl::Box<T>>(T(1), T(1), T(1));
    return geometry;
  }

  std::size_t number_;
};

/// FCL's manager with a tree in arrays; the one with pointers is slower. By default, FCL 0.7 rebalances the tree from
/// the top once it is ten levels too high, and then loses track of the leaves: for a thousand boxes in clusters, wrong
/// pairs are found from the 43rd frame on. So rebalancing is disabled here.
template <class T>
class FclTree : public fcl::DynamicAABBTreeCollisionManager_Array<T> {
 public:
  FclTree() { this->max_tree_nonbalanced_level = std::numeric_limits<int>::max(); }
};

}  // namespace bench
