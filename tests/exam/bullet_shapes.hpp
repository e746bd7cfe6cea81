// SPDX-License-Identifier: MIT
// Converts graze's shapes to Bullet's, with their transforms: boxes, triangles and hulls without margin, so that they
// have their exact size.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::exam::bullet {

/// One of Bullet's shapes and its transform.
struct Body {
  std::unique_ptr<btConvexShape> shape;
  btTransform pose = btTransform::getIdentity();
};

inline btVector3 vector(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

/// Bullet's capsules are parallel to z.
inline btQuaternion turn_from_z(const Vec<3, float>& way) {
  const btVector3 direction = vector(way);
  if (direction.length2() == 0.0F) return btQuaternion::getIdentity();
  return shortestArcQuat({0, 0, 1}, direction.normalized());
}

/// The body of a shape; none if Bullet has no convex shape for it.
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

}  // namespace graze::exam::bullet
