// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include "../bench/scene_queries/work.hpp"

namespace bench {

/// A shape at its own origin, and its pose.
struct BulletShape {
  std::unique_ptr<btConvexShape> shape;
  btTransform pose;
};

inline btVector3 bullet_vector(const Point<3>& v) { return {v.x, v.y, v.z}; }

inline BulletShape bullet_shape(const graze::Sphere<3>& sphere) {
  return {std::make_unique<btSphereShape>(sphere.radius),
          btTransform(btMatrix3x3::getIdentity(), bullet_vector(sphere.center))};
}

/// Bullet's capsules are parallel to the y axis.
inline BulletShape bullet_shape(const graze::Capsule<3>& capsule) {
  const btVector3 a = bullet_vector(capsule.a);
  const btVector3 b = bullet_vector(capsule.b);
  const btQuaternion turn = shortestArcQuat(btVector3(0, 1, 0), (b - a).normalized());
  return {std::make_unique<btCapsuleShape>(capsule.radius, (b - a).length()), btTransform(turn, (a + b) / 2)};
}

/// Without a margin, with which Bullet would round its corners.
inline BulletShape bullet_shape(const graze::Obb<3>& box) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) basis[row][column] = box.axes[column][row];
  }
  auto shape = std::make_unique<btBoxShape>(bullet_vector(box.half_extents));
  shape->setMargin(0);
  return {std::move(shape), btTransform(basis, bullet_vector(box.center))};
}

inline BulletShape bullet_shape(const Any<3>& shape) {
  if (const auto* const sphere = std::get_if<graze::Sphere<3>>(&shape)) return bullet_shape(*sphere);
  if (const auto* const capsule = std::get_if<graze::Capsule<3>>(&shape)) return bullet_shape(*capsule);
  return bullet_shape(std::get<graze::Obb<3>>(shape));
}

/// A world of objects that do not move, in a tree that is optimized once.
class OfBullet {
 public:
  static constexpr const char* name = "Bullet btCollisionWorld";

  struct Mover {
    BulletShape start;
    btTransform end;
  };
  struct Region {
    BulletShape shape;
    std::unique_ptr<btCollisionObject> object;
  };

  explicit OfBullet(const Work<3>& work) {
    for (const Any<3>& shape : work.objects()) {
      shapes_.push_back(bullet_shape(shape));
      objects_.push_back(object_of(shapes_.back()));
      objects_.back()->setUserIndex(static_cast<int>(objects_.size() - 1));
      objects_.back()->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
      world_.addCollisionObject(objects_.back().get());
    }
    broadphase_.optimize();
  }

  Mover mover(const Cast<3>& cast) const {
    Mover result{bullet_shape(cast.shape), {}};
    result.end = result.start.pose;
    result.end.getOrigin() += bullet_vector(cast.motion);
    return result;
  }

  Region region(const Any<3>& shape) const {
    Region result{bullet_shape(shape), nullptr};
    result.object = object_of(result.shape);
    return result;
  }

  std::optional<float> cast(const Mover& mover) const {
    const btTransform& start = mover.start.pose;
    btCollisionWorld::ClosestConvexResultCallback nearest(start.getOrigin(), mover.end.getOrigin());
    world_.convexSweepTest(mover.start.shape.get(), start, mover.end, nearest);
    if (!nearest.hasHit()) return std::nullopt;
    return nearest.m_closestHitFraction;
  }

  std::size_t touch(const Region& region, std::vector<std::uint32_t>& objects) {
    objects.clear();
    Touches touches(objects);
    world_.contactTest(region.object.get(), touches);
    return touches.points;
  }

 private:
  struct Touches final : btCollisionWorld::ContactResultCallback {
    explicit Touches(std::vector<std::uint32_t>& found) : objects(found) {}

    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* one, int /*part*/, int /*index*/,
                             const btCollisionObjectWrapper* other, int /*other_part*/, int /*other_index*/) override {
      if (point.getDistance() > 0) return 0;
      const int number =
          std::max(one->getCollisionObject()->getUserIndex(), other->getCollisionObject()->getUserIndex());
      if (objects.empty() || objects.back() != static_cast<std::uint32_t>(number)) {
        objects.push_back(static_cast<std::uint32_t>(number));
      }
      ++points;
      return 0;
    }

    std::vector<std::uint32_t>& objects;
    std::size_t points = 0;
  };

  static std::unique_ptr<btCollisionObject> object_of(const BulletShape& placed) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(placed.shape.get());
    object->setWorldTransform(placed.pose);
    return object;
  }

  std::vector<BulletShape> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

}  // namespace bench
