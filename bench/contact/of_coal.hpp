// SPDX-License-Identifier: MIT
// Coal, in double, for two oriented boxes: collide, which returns one point, and computeContactPatch, which extends it
// to a manifold. Only compiled if CMake finds Coal.
#pragma once

#include <cstddef>

#include <coal/collision.h>
#include <coal/contact_patch.h>
#include <coal/shape/geometric_shapes.h>

#include "../bench/contact/answer.hpp"

namespace graze::contact_bench {

struct CoalBox {
  coal::Box shape;
  coal::Transform3s pose;

  explicit CoalBox(const Obb& box) : shape(vector(2.0 * box.half_extents)) {
    coal::Matrix3s axes;
    for (Dim i = 0; i < 3; ++i) axes.col(static_cast<int>(i)) = vector(box.axes[i]);
    pose.setTransform(axes, vector(box.center));
  }

 private:
  static coal::Vec3s vector(const Point& v) { return {v.x, v.y, v.z}; }
};

class CoalPair {
 public:
  static constexpr const char* name = "Coal";

  CoalPair(const Obb& a, const Obb& b) : a_(a), b_(b) {}

  Answer find() const {
    static const coal::CollisionRequest request(coal::CONTACT, 1);
    static const coal::ContactPatchRequest patch_request;
    coal::CollisionResult result;
    coal::collide(&a_.shape, a_.pose, &b_.shape, b_.pose, request, result);
    if (!result.isCollision()) return {};
    coal::ContactPatchResult patches;
    coal::computeContactPatch(&a_.shape, a_.pose, &b_.shape, b_.pose, result, patch_request, patches);
    const std::size_t count = patches.numContactPatches() == 0 ? 1 : patches.getContactPatch(0).size();
    return {count, -result.getContact(0).penetration_depth};
  }

 private:
  CoalBox a_;
  CoalBox b_;
};

}  // namespace graze::contact_bench
