// SPDX-License-Identifier: MIT
// Tried: the manager with pointers instead of arrays (1.4 times as slow), reporting each moved object (three times),
// and rebuilding the tree from the top (twice) or by Morton codes (twice).
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fcl/config.h>
#include <fcl/narrowphase/collision_object.h>

#include "../bench/fcl_box.hpp"
#include "contestant.hpp"

namespace graze::race {
namespace {

/// The tree is built at the start; in every frame it is refitted to the objects' new boxes, and some leaves are moved
/// to better places.
template <class T>
class DynamicTree final : public Contestant<3, T> {
 public:
  explicit DynamicTree(std::span<const Aabb<3, T>> boxes) {
    objects_.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      objects_.push_back(std::make_unique<bench::FclBox<T>>(i));
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
  /// Returning false continues the search.
  static bool take(fcl::CollisionObject<T>* one, fcl::CollisionObject<T>* other, void* pairs) {
    static_cast<std::vector<Pair>*>(pairs)->push_back(
        ascending(bench::FclBox<T>::number_of(one), bench::FclBox<T>::number_of(other)));
    return false;
  }

  std::vector<std::unique_ptr<bench::FclBox<T>>> objects_;
  std::vector<fcl::CollisionObject<T>*> pointers_;
  bench::FclTree<T> manager_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_fcl(Entrants<N, T>& field) {
  if constexpr (N == 3) {
    Entrant<N, T> entrant;
    entrant.name = "FCL DynamicAABBTree_Array";
    entrant.keeps = true;
    entrant.settings =
        "FCL " FCL_VERSION
        ", the tree kept and refitted; not rebalanced from the root, because its answers are wrong afterwards";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<DynamicTree<T>>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_fcl(Entrants<2, float>& field);
template void enter_fcl(Entrants<2, double>& field);
template void enter_fcl(Entrants<3, float>& field);
template void enter_fcl(Entrants<3, double>& field);

}  // namespace graze::race
