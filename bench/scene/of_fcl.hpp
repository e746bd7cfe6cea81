// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <fcl/narrowphase/collision_object.h>

#include "../bench/fcl_box.hpp"
#include "../bench/scene/frames.hpp"

namespace bench {

/// FCL's tree does not store pairs between frames, so all are found again. If everything has moved, the whole tree is
/// refitted, otherwise single objects are updated.
class OfFcl {
 public:
  static constexpr const char* name = "FCL DynamicAABBTree_Array";

  explicit OfFcl(const Frames<3>& frames) : frames_(frames) {
    std::vector<fcl::CollisionObject<float>*> pointers;
    for (const Box<3>& box : frames.start()) {
      objects_.push_back(std::make_unique<FclBox<float>>(objects_.size()));
      objects_.back()->place(box);
      pointers.push_back(objects_.back().get());
    }
    manager_.registerObjects(pointers);
    manager_.setup();
    find();
  }

  void step(std::size_t frame) {
    moved_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box<3>& box) {
      objects_[k]->place(box);
      moved_.push_back(objects_[k].get());
    });
    if (moved_.size() == objects_.size()) {
      manager_.update();
    } else {
      manager_.update(moved_);
    }
    find();
  }

  const Outcome& outcome() const { return outcome_; }

 private:
  void find() {
    found_.clear();
    manager_.collide(&found_, take);
    go_on(outcome_, found_);
  }

  /// Returning false continues the search.
  static bool take(fcl::CollisionObject<float>* one, fcl::CollisionObject<float>* other, void* found) {
    static_cast<std::vector<Pair>*>(found)->push_back(
        ascending(FclBox<float>::number_of(one), FclBox<float>::number_of(other)));
    return false;
  }

  const Frames<3>& frames_;
  std::vector<std::unique_ptr<FclBox<float>>> objects_;
  std::vector<fcl::CollisionObject<float>*> moved_;
  FclTree<float> manager_;
  std::vector<Pair> found_;
  Outcome outcome_;
};

}  // namespace bench
