// SPDX-License-Identifier: MIT
#include "of_jolt.hpp"

#include <algorithm>

// clang-format off
#include <Jolt/Jolt.h> // required before Jolt's other headers
// clang-format on

#include <Jolt/Core/Factory.h>
#include <Jolt/Physics/Collision/CollideShape.h>
#include <Jolt/Physics/Collision/CollisionDispatch.h>
#include <Jolt/Physics/Collision/ManifoldBetweenTwoFaces.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/PhysicsSettings.h>
#include <Jolt/RegisterTypes.h>

namespace graze::contact_bench {
namespace {

/// Tables for the program, which are never freed.
void start() {
  static const bool is_started = [] {
    JPH::RegisterDefaultAllocator();
    JPH::Factory::sInstance = new JPH::Factory;
    JPH::RegisterTypes();
    return true;
  }();
  static_cast<void>(is_started);
}

JPH::Vec3 vector(const Point& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

struct JoltBox {
  JPH::RefConst<JPH::BoxShape> shape;
  JPH::Mat44 pose;

  JoltBox(const Obb& box, JoltEdges edges)
      : pose(JPH::Vec4(vector(box.axes[0]), 0), JPH::Vec4(vector(box.axes[1]), 0), JPH::Vec4(vector(box.axes[2]), 0),
             vector(box.center)) {
    start();
    const JPH::Vec3 half = vector(box.half_extents);
    const float radius = edges == JoltEdges::sharp ? 0 : std::min(JPH::cDefaultConvexRadius, half.ReduceMin());
    shape = new JPH::BoxShape(half, radius);
  }
};

/// The points of one hit; two boxes have at most one.
class Manifold final : public JPH::CollideShapeCollector {
 public:
  JPH::ContactPoints on_a;
  JPH::ContactPoints on_b;
  float depth = 0;

  void AddHit(const JPH::CollideShapeResult& hit) override {  // NOLINT(readability-identifier-naming): Jolt's name
    static const JPH::PhysicsSettings settings;
    depth = hit.mPenetrationDepth;
    JPH::ManifoldBetweenTwoFaces(hit.mContactPointOn1, hit.mContactPointOn2, hit.mPenetrationAxis,
                                 settings.mSpeculativeContactDistance + settings.mManifoldTolerance, hit.mShape1Face,
                                 hit.mShape2Face, on_a, on_b JPH_IF_DEBUG_RENDERER(, JPH::RVec3::sZero()));
    if (on_a.size() <= 4) return;
    JPH::PruneContactPoints(hit.mPenetrationAxis.Normalized(), on_a, on_b JPH_IF_DEBUG_RENDERER(, JPH::RVec3::sZero()));
  }
};

}  // namespace

template <JoltEdges Edges>
struct JoltPair<Edges>::Boxes {
  JoltBox a;
  JoltBox b;
};

template <JoltEdges Edges>
JoltPair<Edges>::JoltPair(const Obb& a, const Obb& b) : boxes_(new Boxes{JoltBox(a, Edges), JoltBox(b, Edges)}) {}
template <JoltEdges Edges>
JoltPair<Edges>::JoltPair(JoltPair&& other) noexcept = default;
template <JoltEdges Edges>
JoltPair<Edges>::~JoltPair() = default;

template <JoltEdges Edges>
Answer JoltPair<Edges>::find() const {
  JPH::CollideShapeSettings settings;
  settings.mCollectFacesMode = JPH::ECollectFacesMode::CollectFaces;
  const JPH::Vec3 scale = JPH::Vec3::sOne();
  Manifold manifold;
  JPH::CollisionDispatch::sCollideShapeVsShape(boxes_->a.shape, boxes_->b.shape, scale, scale, boxes_->a.pose,
                                               boxes_->b.pose, {}, {}, settings, manifold);
  return {manifold.on_a.size(), static_cast<double>(manifold.depth)};
}

template class JoltPair<JoltEdges::sharp>;
template class JoltPair<JoltEdges::rounded>;

}  // namespace graze::contact_bench
