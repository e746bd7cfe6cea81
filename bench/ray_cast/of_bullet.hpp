// SPDX-License-Identifier: MIT
// Bullet (float): its ray tests against an axis-aligned box and a triangle, its convex cast for all other convex
// shapes, and what its worlds do with a plane and a compound.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btAabbUtil2.h>

#include <graze/shape/fields/visit.hpp>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

inline btVector3 bullet(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

/// From the origin to the ray's point at t_max; Bullet finds a fraction of that path.
struct BulletPath {
  explicit BulletPath(const Ray<3, float>& ray)
      : from(bullet(ray.origin)), to(bullet(ray.origin + ray.direction * t_max)) {}

  btVector3 from;
  btVector3 to;
};

struct BulletHit {
  btScalar t;
  btVector3 normal;
};

// ---- Shapes and their poses

template <class Geometry>
struct BulletPlaced {
  std::shared_ptr<Geometry> geometry;
  btTransform pose = btTransform::getIdentity();
};
using BulletConvex = BulletPlaced<btConvexShape>;
using BulletShape = BulletPlaced<btCollisionShape>;

inline BulletConvex bullet_shape(const Sphere<3, float>& sphere) {
  BulletConvex shape{std::make_shared<btSphereShape>(sphere.radius)};
  shape.pose.setOrigin(bullet(sphere.center));
  return shape;
}
inline BulletConvex bullet_shape(const Obb<3, float>& box) {
  BulletConvex shape{std::make_shared<btBoxShape>(bullet(box.half_extents))};
  const auto& m = box.axes;
  shape.pose.setBasis(btMatrix3x3(m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z));
  shape.pose.setOrigin(bullet(box.center));
  return shape;
}
/// Bullet's capsules are parallel to y.
inline BulletConvex bullet_shape(const Capsule<3, float>& capsule) {
  const btVector3 way = bullet(capsule.b - capsule.a);
  BulletConvex shape{std::make_shared<btCapsuleShape>(capsule.radius, way.length())};
  shape.pose.setRotation(shortestArcQuat(btVector3(0, 1, 0), way.normalized()));
  shape.pose.setOrigin(bullet(capsule.a) + way * 0.5F);
  return shape;
}
inline BulletConvex bullet_shape(const Polytope<3, float>& polytope) {
  auto hull = std::make_shared<btConvexHullShape>();
  for (const Vec<3, float>& vertex : polytope.vertices()) hull->addPoint(bullet(vertex), false);
  hull->setMargin(0);
  hull->recalcLocalAabb();
  return {hull};
}
inline BulletShape bullet_shape(const Plane<3, float>& plane) {
  const float length = std::sqrt(dot(plane.normal, plane.normal));
  return {std::make_shared<btStaticPlaneShape>(bullet(plane.normal / length), plane.offset / length)};
}

template <class S>
concept IsConvexForBullet = requires(const S& shape) {
  { bullet_shape(shape) } -> std::same_as<BulletConvex>;
};

/// A compound with its parts, which Bullet does not own.
struct BulletCompound : btCompoundShape {
  std::vector<BulletConvex> parts;
};

inline BulletShape bullet_shape(const Compound<3, float>& compound) {
  auto whole = std::make_shared<BulletCompound>();
  for (const Part<3, float>& part : compound.parts) {
    detail::visit(
        [&](const auto& held) {
          if constexpr (IsConvexForBullet<std::decay_t<decltype(held)>>) whole->parts.push_back(bullet_shape(held));
        },
        part.shape);
  }
  for (const BulletConvex& part : whole->parts) whole->addChildShape(part.pose, part.geometry.get());
  return {whole};
}

/// Shapes that only a world can cast a ray at.
template <class S>
concept IsWholeForBullet = requires(const S& shape) {
  { bullet_shape(shape) } -> std::same_as<BulletShape>;
};

// ---- Tests

/// Bullet's convex cast stops when the squared distance is 1e-4, and gives up, with its current result, if its simplex
/// becomes flat.
inline constexpr double bullet_cast_tolerance = 3e-2;
inline constexpr double bullet_cast_share_wrong = 0.05;

/// Casts a point against a convex shape at rest, as Bullet's ray tests do.
class BulletConvexCast {
 public:
  static constexpr const char* name = "Bullet btSubsimplexConvexCast";
  static constexpr double tolerance = bullet_cast_tolerance;
  static constexpr double share_wrong = bullet_cast_share_wrong;

  template <class S>
  requires IsConvexForBullet<S>
  explicit BulletConvexCast(const Case<S>& asked) : shape_(bullet_shape(asked.shape)), path_(asked.ray) {}

  std::optional<BulletHit> cast() const {
    static btSphereShape point = [] {
      btSphereShape sphere(0);
      sphere.setMargin(0);
      return sphere;
    }();
    btVoronoiSimplexSolver simplex;
    btSubsimplexConvexCast caster(&point, shape_.geometry.get(), &simplex);
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    btTransform from = btTransform::getIdentity();
    btTransform to = btTransform::getIdentity();
    from.setOrigin(path_.from);
    to.setOrigin(path_.to);
    if (!caster.calcTimeOfImpact(from, to, shape_.pose, shape_.pose, result)) return std::nullopt;
    if (!(result.m_normal.length2() > 1e-4F && result.m_fraction < 1)) return std::nullopt;  // as its worlds do
    return BulletHit{result.m_fraction * t_max, result.m_normal};
  }

 private:
  BulletConvex shape_;
  BulletPath path_;
};

/// What a world does with each object that a ray may hit.
class BulletObjectCast {
 public:
  static constexpr const char* name = "Bullet rayTestSingle";
  static constexpr double tolerance = bullet_cast_tolerance;
  static constexpr double share_wrong = bullet_cast_share_wrong;

  template <class S>
  requires IsWholeForBullet<S>
  explicit BulletObjectCast(const Case<S>& asked)
      : shape_(bullet_shape(asked.shape)), path_(asked.ray), object_(std::make_unique<btCollisionObject>()) {
    object_->setCollisionShape(shape_.geometry.get());
    object_->setWorldTransform(shape_.pose);
  }

  std::optional<BulletHit> cast() const {
    btCollisionWorld::ClosestRayResultCallback result(path_.from, path_.to);
    btTransform from = btTransform::getIdentity();
    btTransform to = btTransform::getIdentity();
    from.setOrigin(path_.from);
    to.setOrigin(path_.to);
    btCollisionWorld::rayTestSingle(from, to, object_.get(), shape_.geometry.get(), shape_.pose, result);
    if (!result.hasHit()) return std::nullopt;
    return BulletHit{result.m_closestHitFraction * t_max, result.m_hitNormalWorld};
  }

 private:
  BulletShape shape_;
  BulletPath path_;
  std::unique_ptr<btCollisionObject> object_;
};

class BulletBoxCast {
 public:
  static constexpr const char* name = "Bullet btRayAabb";
  static constexpr double tolerance = 1e-5;

  explicit BulletBoxCast(const Case<Aabb<3, float>>& asked)
      : min_(bullet(asked.shape.min)), max_(bullet(asked.shape.max)), path_(asked.ray) {}

  std::optional<BulletHit> cast() const {
    BulletHit hit{1, {0, 0, 0}};
    if (!btRayAabb(path_.from, path_.to, min_, max_, hit.t, hit.normal)) return std::nullopt;
    hit.t *= t_max;
    return hit;
  }

 private:
  btVector3 min_;
  btVector3 max_;
  BulletPath path_;
};

/// The box test in Bullet's trees, which finds no normal, with its precomputed ray data.
class BulletSlabs {
 public:
  static constexpr const char* name = "Bullet btRayAabb2 (t alone)";
  static constexpr double tolerance = 1e-5;

  struct Hit {
    btScalar t;
  };

  explicit BulletSlabs(const Case<Aabb<3, float>>& asked)
      : sides_{bullet(asked.shape.min), bullet(asked.shape.max)},
        origin_(bullet(asked.ray.origin)),
        direction_(bullet(asked.ray.direction)) {}

  std::optional<Hit> cast() const {
    const btVector3 inverse(1 / direction_.x(), 1 / direction_.y(), 1 / direction_.z());
    const unsigned int signs[3] = {inverse.x() < 0, inverse.y() < 0, inverse.z() < 0};
    btScalar t = 0;
    if (!btRayAabb2(origin_, inverse, signs, sides_.data(), t, 0, t_max)) return std::nullopt;
    return Hit{t};
  }

 private:
  std::array<btVector3, 2> sides_;
  btVector3 origin_;
  btVector3 direction_;
};

class BulletTriangleCast {
 public:
  static constexpr const char* name = "Bullet btTriangleRaycastCallback";
  static constexpr double tolerance = 1e-3;  // its edges have a tolerance of 1e-4 of the triangle

  explicit BulletTriangleCast(const Case<Triangle<3, float>>& asked)
      : corners_{bullet(asked.shape.a), bullet(asked.shape.b), bullet(asked.shape.c)}, path_(asked.ray) {}

  std::optional<BulletHit> cast() const {
    Callback callback(path_.from, path_.to);
    std::array<btVector3, 3> copy = corners_;  // processTriangle takes a pointer to non-const
    callback.processTriangle(copy.data(), 0, 0);
    return callback.hit;
  }

 private:
  struct Callback : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    btScalar reportHit(const btVector3& normal, btScalar fraction, int, int) override {
      hit = BulletHit{fraction * t_max, normal};
      return fraction;
    }
    std::optional<BulletHit> hit;
  };

  std::array<btVector3, 3> corners_;
  BulletPath path_;
};

}  // namespace graze::ray_bench
