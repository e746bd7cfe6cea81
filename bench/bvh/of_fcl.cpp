// SPDX-License-Identifier: MIT
#include <memory>

#include <fcl/narrowphase/collision_object.h>

#include "../bench/fcl_box.hpp"
#include "contestant.hpp"

namespace bench {
namespace {

/// If all boxes have moved, the whole tree is refitted; otherwise single boxes are updated. It has no ray queries.
class DynamicTree {
 public:
  void build(std::span<const Box<3>> boxes) {
    manager_ = std::make_unique<FclTree<float>>();
    objects_.clear();
    objects_.reserve(boxes.size());
    std::vector<fcl::CollisionObject<float>*> pointers;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      objects_.push_back(std::make_unique<FclBox<float>>(k));
      objects_.back()->place(boxes[k]);
      pointers.push_back(objects_.back().get());
    }
    manager_->registerObjects(pointers);
    manager_->setup();
  }
  void move(std::span<const Box<3>> boxes, const Share& share) {
    moved_.clear();
    for (std::size_t k = share.first; k < boxes.size(); k += share.step) {
      objects_[k]->place(boxes[k]);
      moved_.push_back(objects_[k].get());
    }
    share.step == 1 ? manager_->update() : manager_->update(moved_);
  }
  template <class Visit>
  void query(const Box<3>& region, const Visit& visit) {
    asked_.place(region);
    const auto take = [](fcl::CollisionObject<float>* found, fcl::CollisionObject<float>* /*asked*/, void* data) {
      (*static_cast<const Visit*>(data))(FclBox<float>::number_of(found));
      return false;  // continues the search
    };
    manager_->collide(&asked_, const_cast<Visit*>(&visit), take);
  }

 private:
  FclBox<float> asked_{0};
  std::unique_ptr<FclTree<float>> manager_;
  std::vector<std::unique_ptr<FclBox<float>>> objects_;
  std::vector<fcl::CollisionObject<float>*> moved_;
};

}  // namespace

template <Dim N>
void enter_fcl(Entrants<N>& field) {
  if constexpr (N == 3) field.push_back(entrant<3, DynamicTree>("FCL"));
}

template void enter_fcl(Entrants<2>&);
template void enter_fcl(Entrants<3>&);

}  // namespace bench
