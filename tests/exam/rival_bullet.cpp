// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <variant>

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>

#include "exam/bullet_shapes.hpp"
#include "exam/rival.hpp"
#include "query/placement.hpp"
#include "query/times_of_impact.hpp"

namespace graze::exam {
namespace {

using bullet::Body;
using bullet::BodyOf;
using bullet::vector;

/// Of the points nearest to each other: distance, the point on b's surface, and the normal from b to a.
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

Vec<3, double> wide_point(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

bool is_box(const Body& body) { return body.shape->getShapeType() == BOX_SHAPE_PROXYTYPE; }

/// Keeps all points that are not above the surface.
struct AllPoints : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3& on_b, btScalar distance) override {
    if (distance <= 0) patch.push_back({wide_point(on_b), -static_cast<double>(distance)});
  }
  ContactPatch patch;
};

/// When two bodies that move between poses first meet.
Meeting first_meeting(const Body& a, const btTransform& end_a, const Body& b, const btTransform& end_b) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision collision(a.shape.get(), b.shape.get(), &simplex, &depth);
  btConvexCast::CastResult result;
  result.m_fraction = 1;
  if (!collision.calcTimeOfImpact(a.pose, end_a, b.pose, end_b, result)) return {};
  return {result.m_fraction <= 1, static_cast<double>(result.m_fraction)};
}

/// The body of a shape with its origin, about which Bullet rotates it, at a point.
std::optional<Body> body_about(const Solid3<float>& shape, const Vec<3, float>& center) {
  std::optional<Body> body = std::visit(BodyOf(), test::moved<3, float>(shape, -center));
  if (body) body->pose.setOrigin(body->pose.getOrigin() + vector(center));
  return body;
}

btTransform end_of(const Body& body, const Motion<3, float>& motion) {
  btTransform end = body.pose;
  const btVector3 turn = vector(motion.angular);
  if (turn.length2() > 0) end.setRotation(btQuaternion(turn.normalized(), turn.length()) * end.getRotation());
  end.setOrigin(end.getOrigin() + vector(motion.linear));
  return end;
}

}  // namespace

std::optional<bool> bullet_answer(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (!nearest) return std::nullopt;
  return nearest->m_hasResult && nearest->m_distance <= 0;
}

std::optional<Proximity> bullet_parting(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (!nearest) return std::nullopt;
  if (!nearest->m_hasResult || nearest->m_distance > 0) return Proximity{};
  const btVector3 way = -nearest->m_normalOnBInWorld;
  return Proximity{true, -static_cast<double>(nearest->m_distance), wide_point(way)};
}

std::optional<Separation> bullet_separation(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (!nearest) return std::nullopt;
  if (!nearest->m_hasResult) return Separation{false, std::numeric_limits<double>::quiet_NaN()};
  const btVector3& on_b = nearest->m_pointInWorld;
  const btVector3 on_a = on_b + nearest->m_normalOnBInWorld * nearest->m_distance;
  return Separation{nearest->m_distance <= 0, static_cast<double>(nearest->m_distance), wide_point(on_a),
                    wide_point(on_b)};
}

std::optional<ContactPatch> bullet_patch(const Solid3<float>& a, const Solid3<float>& b) {
  const std::optional<Body> body_a = std::visit(BodyOf(), a);
  const std::optional<Body> body_b = std::visit(BodyOf(), b);
  if (!body_a || !body_b) return std::nullopt;
  AllPoints points;
  if (is_box(*body_a) && is_box(*body_b)) {
    const auto* box_a = static_cast<const btBoxShape*>(body_a->shape.get());
    const auto* box_b = static_cast<const btBoxShape*>(body_b->shape.get());
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA = body_a->pose;
    input.m_transformB = body_b->pose;
    btBoxBoxDetector(box_a, box_b).getClosestPoints(input, points, nullptr);
    return points.patch;
  }
  const std::optional<btPointCollector> nearest = nearest_of(a, b);
  if (nearest->m_hasResult)
    points.addContactPoint(nearest->m_normalOnBInWorld, nearest->m_pointInWorld, nearest->m_distance);
  return points.patch;
}

std::optional<Meeting> bullet_meeting(const Solid3<float>& a, const Vec<3, float>& motion, const Solid3<float>& b) {
  const std::optional<Body> body_a = std::visit(BodyOf(), a);
  const std::optional<Body> body_b = std::visit(BodyOf(), b);
  if (!body_a || !body_b) return std::nullopt;
  btTransform end = body_a->pose;
  end.setOrigin(end.getOrigin() + vector(motion));
  return first_meeting(*body_a, end, *body_b, body_b->pose);
}

std::optional<Meeting> bullet_impact(const test::Moving<3, float>& moving) {
  const std::optional<Body> body_a = body_about(moving.a, moving.motion_a.center);
  const std::optional<Body> body_b = body_about(moving.b, moving.motion_b.center);
  if (!body_a || !body_b) return std::nullopt;
  return first_meeting(*body_a, end_of(*body_a, moving.motion_a), *body_b, end_of(*body_b, moving.motion_b));
}

std::optional<RayVerdict> bullet_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach) {
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
  return RayVerdict{nearest.hasHit(), static_cast<double>(nearest.m_closestHitFraction) * reach};
}

}  // namespace graze::exam
