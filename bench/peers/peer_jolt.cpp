// SPDX-License-Identifier: MIT
// Only compiled if CMake finds Jolt.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// clang-format off
#include <Jolt/Jolt.h> // required before Jolt's other headers
// clang-format on

#include <Jolt/Core/Memory.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Body/BodyManager.h>
#include <Jolt/Physics/Body/BodyPair.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseQuadTree.h>
#include <Jolt/Physics/Collision/CollisionCollectorImpl.h>
#include <Jolt/Physics/Collision/Shape/ConvexShape.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

using Boxes = std::span<const Aabb<3, float>>;

/// A shape with a given box, not one that is calculated from its pose, which would round. Jolt's broad phase asks for
/// nothing else.
class BoxedShape final : public JPH::ConvexShape {
 public:
  BoxedShape() : ConvexShape(JPH::EShapeSubType::UserConvex1) {}

  void place(const Aabb<3, float>& box) { box_ = {corner(box.min), corner(box.max)}; }

  // NOLINTBEGIN(readability-identifier-naming): Jolt's names
  JPH::AABox GetWorldSpaceBounds(JPH::Mat44Arg /*pose*/, JPH::Vec3Arg /*scale*/) const override { return box_; }
  JPH::AABox GetLocalBounds() const override { return box_; }
  float GetInnerRadius() const override { return 0; }
  JPH::MassProperties GetMassProperties() const override { return {}; }
  JPH::Vec3 GetSurfaceNormal(const JPH::SubShapeID& /*part*/, JPH::Vec3Arg /*at*/) const override {
    return JPH::Vec3::sZero();
  }
  void CollideSoftBodyVertices(JPH::Mat44Arg /*pose*/, JPH::Vec3Arg /*scale*/,
                               const JPH::CollideSoftBodyVertexIterator& /*vertices*/, JPH::uint /*count*/,
                               int /*index*/) const override {}
  Stats GetStats() const override { return {sizeof(*this), 0}; }
  float GetVolume() const override { return 0; }
  const Support* GetSupportFunction(ESupportMode /*mode*/, SupportBuffer& /*buffer*/,
                                    JPH::Vec3Arg /*scale*/) const override {
    return nullptr;
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  static JPH::Vec3 corner(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

  JPH::AABox box_;
};

/// The number of a body's box.
std::uint32_t number_of(const JPH::BodyManager& bodies, JPH::BodyID id) {
  return static_cast<std::uint32_t>(bodies.GetBody(id).GetUserData());
}

class PairList final : public JPH::BodyPairCollector {
 public:
  PairList(const JPH::BodyManager& bodies, std::vector<Pair>& pairs) : bodies_(bodies), pairs_(pairs) {}

  void AddHit(const JPH::BodyPair& pair) override {  // NOLINT(readability-identifier-naming): Jolt's name
    pairs_.push_back(ascending(number_of(bodies_, pair.mBodyA), number_of(bodies_, pair.mBodyB)));
  }

 private:
  const JPH::BodyManager& bodies_;
  std::vector<Pair>& pairs_;
};

/// Active bodies with the given boxes, in the given order, all on one layer.
class World {
 public:
  World(Boxes boxes, const std::vector<std::uint32_t>& order) {
    layers_.MapObjectToBroadPhaseLayer(0, JPH::BroadPhaseLayer(0));
    bodies_.Init(static_cast<JPH::uint>(boxes.size()), 0, layers_);
    tree_.Init(&bodies_, layers_);
    for (const std::uint32_t number : order) add(boxes[number], number);
    const int count = static_cast<int>(ids_.size());
    bodies_.ActivateBodies(ids_.data(), count);
    std::vector<JPH::BodyID> added = ids_;  // whose order Jolt changes
    tree_.AddBodiesFinalize(added.data(), count, tree_.AddBodiesPrepare(added.data(), count));
    tree_.Optimize();
  }

  /// The numbers of the boxes in the order of the leaves.
  std::vector<std::uint32_t> leaves() const {
    JPH::AllHitCollisionCollector<JPH::CollideShapeBodyCollector> found;
    tree_.CollideAABox(tree_.GetBounds(), found, {}, {});
    std::vector<std::uint32_t> numbers;
    for (const JPH::BodyID id : found.mHits) numbers.push_back(number_of(bodies_, id));
    return numbers;
  }

  void move(Boxes boxes) {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      JPH::Body& body = bodies_.GetBody(ids_[i]);
      shapes_[i]->place(boxes[static_cast<std::size_t>(body.GetUserData())]);
      body.CalculateWorldSpaceBoundsInternal();
    }
    for_batches([this](JPH::BodyID* ids, int count) { tree_.NotifyBodiesAABBChanged(ids, count, false); });
  }

  void rebuild() {
    tree_.FrameSync();
    tree_.LockModifications();
    tree_.UpdateFinalize(tree_.UpdatePrepare());
    tree_.UnlockModifications();
  }

  void find(std::vector<Pair>& pairs) {
    PairList list(bodies_, pairs);
    for_batches([&](JPH::BodyID* ids, int count) { tree_.FindCollidingPairs(ids, count, 0, {}, {}, list); });
  }

 private:
  void add(const Aabb<3, float>& box, std::uint32_t number) {
    const JPH::Ref<BoxedShape> shape = new BoxedShape;
    shape->place(box);
    JPH::BodyCreationSettings settings(shape.GetPtr(), JPH::RVec3::sZero(), JPH::Quat::sIdentity(),
                                       JPH::EMotionType::Dynamic, 0);
    settings.mUserData = number;
    settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = 1;
    settings.mMassPropertiesOverride.mInertia = JPH::Mat44::sIdentity();
    JPH::Body* const body = bodies_.AllocateBody(settings);
    bodies_.AddBody(body);
    shapes_.push_back(shape);
    ids_.push_back(body->GetID());
  }

  /// Jolt sorts each batch by layer; its PhysicsSystem passes this many bodies at a time.
  template <class Visit>
  void for_batches(const Visit& visit) {
    constexpr std::size_t size = 16;
    for (std::size_t i = 0; i < ids_.size(); i += size) {
      visit(&ids_[i], static_cast<int>(std::min(size, ids_.size() - i)));
    }
  }

  JPH::BroadPhaseLayerInterfaceTable layers_{1, 1};
  JPH::BodyManager bodies_;
  JPH::BroadPhaseQuadTree tree_;
  std::vector<JPH::Ref<BoxedShape>> shapes_;
  std::vector<JPH::BodyID> ids_;
};

enum class Update { rebuilt, widened };

/// Bodies are created, moved and queried in the order of the leaves of a first tree, so that neighbours are adjacent in
/// memory and in time.
class QuadTree final : public Contestant<3, float> {
 public:
  QuadTree(Boxes boxes, Update update) : update_(update) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0U);
    world_ = std::make_unique<World>(boxes, World(boxes, order).leaves());
  }

  std::span<const Pair> find(Boxes boxes) override {
    pairs_.clear();
    world_->move(boxes);
    if (update_ == Update::rebuilt) world_->rebuild();
    world_->find(pairs_);
    return pairs_;
  }

 private:
  Update update_;
  std::unique_ptr<World> world_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_jolt(Entrants<N, T>& field) {
  if constexpr (N == 3 && std::is_same_v<T, float>) {
    JPH::RegisterDefaultAllocator();
    const auto enter = [&](const std::string& name, const std::string& settings, Update update) {
      Entrant<N, T> entrant;
      entrant.name = name;
      entrant.keeps = true;
      entrant.settings = "Jolt " + std::to_string(JPH_VERSION_MAJOR) + "." + std::to_string(JPH_VERSION_MINOR) + "." +
                         std::to_string(JPH_VERSION_PATCH) + ", the tree kept, " + settings;
      entrant.prepare = [update](Boxes boxes) { return std::make_unique<QuadTree>(boxes, update); };
      field.push_back(std::move(entrant));
    };
    enter("Jolt BroadPhaseQuadTree", "and rebuilt in every frame, as by its PhysicsSystem", Update::rebuilt);
    enter("Jolt BroadPhaseQuadTree, widened", "its nodes only widened, which only serves for some frames",
          Update::widened);
  }
}

template void enter_jolt(Entrants<2, float>& field);
template void enter_jolt(Entrants<2, double>& field);
template void enter_jolt(Entrants<3, float>& field);
template void enter_jolt(Entrants<3, double>& field);

}  // namespace graze::race
