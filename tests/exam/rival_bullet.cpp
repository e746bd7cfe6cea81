// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <graze/math/vec.hpp>

#include "exam/contact_rival.hpp"
#include "exam/ray_rival.hpp"
#include "exam/rival.hpp"

namespace graze::exam {
namespace {

struct Body {
  std::unique_ptr<btConvexShape> shape;
  btTransform pose = btTransform::getIdentity();
};

btVector3 vector(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

/// Bullet's capsules stand along z.
btQuaternion turn_from_z(const Vec<3, float>& way) {
  const btVector3 direction = vector(way);
  if (direction.length2() == 0.0F) return btQuaternion::getIdentity();
  return shortestArcQuat({0, 0, 1}, direction.normalized());
}

struct BodyOf {
  using Found = std::optional<Body>;

  static Found without_margin(std::unique_ptr<btConvexShape> shape) {
    shape->setMargin(0);
    return Body{std::move(shape)};
  }

  Found operator()(const Sphere<3, float>& sphere) const {
    Body body{std::make_unique<btSphereShape>(sphere.radius)};
    body.pose.setOrigin(vector(sphere.center));
    return body;
  }
  Found operator()(const Aabb<3, float>& box) const {
    Found body = without_margin(std::make_unique<btBoxShape>(vector((box.max - box.min) * 0.5F)));
    body->pose.setOrigin(vector((box.min + box.max) * 0.5F));
    return body;
  }
  Found operator()(const Obb<3, float>& box) const {
    Found body = without_margin(std::make_unique<btBoxShape>(vector(box.half_extents)));
    const Mat<3, float>& m = box.axes;
    body->pose.setBasis({m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z});
    body->pose.setOrigin(vector(box.center));
    return body;
  }
  Found operator()(const Capsule<3, float>& capsule) const {
    const Vec<3, float> way = capsule.b - capsule.a;
    Body body{std::make_unique<btCapsuleShapeZ>(capsule.radius, vector(way).length())};
    body.pose.setRotation(turn_from_z(way));
    body.pose.setOrigin(vector((capsule.a + capsule.b) * 0.5F));
    return body;
  }
  Found operator()(const Triangle<3, float>& t) const {
    return without_margin(std::make_unique<btTriangleShape>(vector(t.a), vector(t.b), vector(t.c)));
  }
  Found operator()(const Polytope<3, float>& polytope) const {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec<3, float>& vertex : polytope.vertices()) hull->addPoint(vector(vertex));
    return without_margin(std::move(hull));
  }
  template <class S>
  Found operator()(const S&) const {
    return std::nullopt;
  }
};

/// Of a point of b's surface, or of the two nearest ones: distance, and the normal from b to a.
std::optional<btPointCollector> nearest_of(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<Body> body_a = std::visit(BodyOf(), a);
  const std::optional<Body> body_b = std::visit(BodyOf(), b);
  if (!body_a || !body_b) return std::nullopt;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(body_a->shape.get(), body_b->shape.get(), &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = body_a->pose;
  input.m_transformB = body_b->pose;
  btPointCollector nearest;
  detector.getClosestPoints(input, nearest, nullptr);
  return nearest;
}

}  // namespace

std::optional<bool> bullet_answer(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (!nearest) return std::nullopt;
  return nearest->m_hasResult && nearest->m_distance <= 0;
}

std::optional<Parting> bullet_parting(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (!nearest) return std::nullopt;
  if (!nearest->m_hasResult || nearest->m_distance > 0) return Parting{};
  const btVector3 way = -nearest->m_normalOnBInWorld;
  return Parting{true, -static_cast<double>(nearest->m_distance), Vec<3, double>(way.x(), way.y(), way.z())};
}

std::optional<Sight> bullet_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach) {
  std::optional<Body> body = std::visit(BodyOf(), shape);
  if (!body) return std::nullopt;
  const Vec<3, double> direction = wide<3, float>(ray.direction);
  const Vec<3, float> end(wide<3, float>(ray.origin) + direction * (reach / length(direction)));
  const btVector3 from = vector(ray.origin);
  const btVector3 to = vector(end);
  btCollisionObject object;
  object.setCollisionShape(body->shape.get());
  object.setWorldTransform(body->pose);
  btCollisionWorld::ClosestRayResultCallback nearest(from, to);
  btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), from),
                                  btTransform(btQuaternion::getIdentity(), to), &object, body->shape.get(), body->pose,
                                  nearest);
  return Sight{nearest.hasHit(), static_cast<double>(nearest.m_closestHitFraction) * reach};
}

}  // namespace graze::exam
