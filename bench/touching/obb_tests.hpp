// SPDX-License-Identifier: MIT
// Other libraries' tests whether two oriented boxes intersect, without finding contacts if possible. Each has its own
// copies of all boxes, created before any query.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <BulletCollision/Gimpact/btBoxCollision.h>
#include <fcl/math/bv/OBB.h>
#include <ode/ode.h>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/obb.hpp>

namespace graze::touching_bench {

using Boxes = std::vector<Obb<3, float>>;

/// FCL's bounding volume (float): the fifteen axes, one after the other, until one separates the boxes.
class FclBoxes {
 public:
  static constexpr const char* name = "FCL OBB::overlap";

  explicit FclBoxes(const Boxes& boxes) {
    for (const Obb<3, float>& box : boxes) {
      fcl::OBB<float>& copy = boxes_.emplace_back();
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) copy.axis(k, i) = box.axes[i][k];
        copy.To[i] = box.center[i];
        copy.extent[i] = box.half_extents[i];
      }
    }
  }

  bool do_meet(const Pair& pair) const { return boxes_[pair.a].overlap(boxes_[pair.b]); }

 private:
  std::vector<fcl::OBB<float>> boxes_;
};

/// The test in Bullet's trees of boxes (float): the fifteen axes in the frame of the first box.
class BulletBoxes {
 public:
  static constexpr const char* name = "Bullet overlapping_trans_cache";

  explicit BulletBoxes(const Boxes& boxes) {
    for (const Obb<3, float>& box : boxes) {
      const auto& m = box.axes;
      const btMatrix3x3 basis(m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z);
      const btVector3 half(box.half_extents.x, box.half_extents.y, box.half_extents.z);
      boxes_.push_back(
          {btAABB(-half, half, half), btTransform(basis, btVector3(box.center.x, box.center.y, box.center.z))});
    }
  }

  bool do_meet(const Pair& pair) const {
    const Box& a = boxes_[pair.a];
    const Box& b = boxes_[pair.b];
    BT_BOX_BOX_TRANSFORM_CACHE relative;
    relative.calc_from_homogenic(a.pose, b.pose);
    return a.box.overlapping_trans_cache(b.box, relative, true);
  }

 private:
  struct Box {
    btAABB box;
    btTransform pose;
  };

  std::vector<Box> boxes_;
};

/// ODE's test (double), which finds a contact, too.
class OdeBoxes {
 public:
  static constexpr const char* name = "ODE dBoxTouchesBox";

  explicit OdeBoxes(const Boxes& boxes) {
    for (const Obb<3, float>& box : boxes) {
      Box& copy = boxes_.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        copy.center[row] = static_cast<double>(box.center[i]);
        copy.sides[row] = 2 * static_cast<double>(box.half_extents[i]);
        for (int k = 0; k < 3; ++k)
          copy.rotation[4 * row + static_cast<std::size_t>(k)] = static_cast<double>(box.axes[k][i]);
      }
    }
  }

  bool do_meet(const Pair& pair) const {
    const Box& a = boxes_[pair.a];
    const Box& b = boxes_[pair.b];
    return dBoxTouchesBox(a.center.data(), a.rotation.data(), a.sides.data(), b.center.data(), b.rotation.data(),
                          b.sides.data()) != 0;
  }

 private:
  struct Box {
    std::array<double, 4> center{};
    std::array<double, 12> rotation{};
    std::array<double, 4> sides{};
  };

  std::vector<Box> boxes_;
};

}  // namespace graze::touching_bench
