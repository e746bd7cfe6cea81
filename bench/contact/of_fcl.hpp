// SPDX-License-Identifier: MIT
// FCL's collide, in double, with up to four contacts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include <fcl/narrowphase/collision.h>

#include "../bench/contact/answer.hpp"

namespace graze::contact_bench {

class FclShape {
 public:
  explicit FclShape(const Sphere& sphere) : geometry_(std::make_shared<fcl::Sphered>(sphere.radius)) {
    pose_.translation() = vector(sphere.center);
  }
  explicit FclShape(const Aabb& box) : geometry_(std::make_shared<fcl::Boxd>(vector(box.max - box.min))) {
    pose_.translation() = vector(box.center());
  }
  explicit FclShape(const Obb& box) : geometry_(std::make_shared<fcl::Boxd>(vector(2.0 * box.half_extents))) {
    for (Dim i = 0; i < 3; ++i) pose_.linear().col(static_cast<int>(i)) = vector(box.axes[i]);
    pose_.translation() = vector(box.center);
  }
  /// FCL's capsules are parallel to z.
  explicit FclShape(const Capsule& capsule) {
    const fcl::Vector3d way = vector(capsule.b - capsule.a);
    geometry_ = std::make_shared<fcl::Capsuled>(capsule.radius, way.norm());
    pose_.linear() = Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), way).toRotationMatrix();
    pose_.translation() = 0.5 * vector(capsule.a + capsule.b);
  }

  const fcl::CollisionGeometryd* geometry() const { return geometry_.get(); }
  const fcl::Transform3d& pose() const { return pose_; }

 private:
  static fcl::Vector3d vector(const Point& v) { return {v.x, v.y, v.z}; }

  std::shared_ptr<fcl::CollisionGeometryd> geometry_;
  fcl::Transform3d pose_ = fcl::Transform3d::Identity();
};

class FclPair {
 public:
  static constexpr const char* name = "FCL";

  template <class A, class B>
  FclPair(const A& a, const B& b) : a_(a), b_(b) {}

  Answer find() const {
    static const fcl::CollisionRequestd request(4, true);
    fcl::CollisionResultd result;
    fcl::collide(a_.geometry(), a_.pose(), b_.geometry(), b_.pose(), request, result);
    Answer answer{result.numContacts(), 0};
    for (std::size_t i = 0; i < answer.count; ++i) {
      answer.depth = std::max(answer.depth, result.getContact(i).penetration_depth);
    }
    return answer;
  }

 private:
  FclShape a_;
  FclShape b_;
};

}  // namespace graze::contact_bench
