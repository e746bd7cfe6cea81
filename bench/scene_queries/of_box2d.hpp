// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>
#include <box2d/b2_world_callbacks.h>

#include "../bench/scene_queries/work.hpp"

namespace bench {

inline b2Vec2 box2d_vector(const Point<2>& v) { return {v.x, v.y}; }

/// In world coordinates. A capsule is an edge with a radius. Box2D widens polygons by b2_polygonRadius, 0.01.
inline std::unique_ptr<b2Shape> box2d_shape(const Any<2>& shape) {
  if (const auto* const sphere = std::get_if<graze::Sphere<2>>(&shape)) {
    auto circle = std::make_unique<b2CircleShape>();
    circle->m_p = box2d_vector(sphere->center);
    circle->m_radius = sphere->radius;
    return circle;
  }
  if (const auto* const capsule = std::get_if<graze::Capsule<2>>(&shape)) {
    auto edge = std::make_unique<b2EdgeShape>();
    edge->SetTwoSided(box2d_vector(capsule->a), box2d_vector(capsule->b));
    edge->m_radius = capsule->radius;
    return edge;
  }
  const auto& box = std::get<graze::Obb<2>>(shape);
  auto polygon = std::make_unique<b2PolygonShape>();
  const float angle = std::atan2(box.axes[0].y, box.axes[0].x);
  polygon->SetAsBox(box.half_extents.x, box.half_extents.y, box2d_vector(box.center), angle);
  return polygon;
}

/// Box2D 2.4 has no cast of a shape through a world. As its users do, asks the world for the fixtures around the whole
/// motion, and casts at each of them, up to the nearest hit so far.
template <bool by_time_of_impact>
class OfBox2d {
 public:
  static constexpr const char* name = by_time_of_impact ? "Box2D b2TimeOfImpact" : "Box2D b2ShapeCast";

  struct Mover {
    std::unique_ptr<b2Shape> shape;
    b2Vec2 motion;
  };

  explicit OfBox2d(const Work<2>& work) {
    const b2BodyDef definition;
    b2Body* const ground = world_.CreateBody(&definition);
    for (const Any<2>& shape : work.objects()) ground->CreateFixture(box2d_shape(shape).get(), 0);
  }

  Mover mover(const Cast<2>& cast) const { return {box2d_shape(cast.shape), box2d_vector(cast.motion)}; }

  std::optional<float> cast(const Mover& mover) const {
    Nearest nearest(mover);
    b2AABB start;
    b2Transform at;
    at.SetIdentity();
    mover.shape->ComputeAABB(&start, at, 0);
    b2AABB end = start;
    end.lowerBound += mover.motion;
    end.upperBound += mover.motion;
    start.Combine(end);
    world_.QueryAABB(&nearest, start);
    return nearest.first;
  }

 private:
  struct Nearest final : b2QueryCallback {
    explicit Nearest(const Mover& asked) : mover(asked) { proxy.Set(asked.shape.get(), 0); }

    /// The name that Box2D requires.
    bool ReportFixture(b2Fixture* fixture) override {  // NOLINT(readability-identifier-naming)
      b2DistanceProxy other;
      other.Set(fixture->GetShape(), 0);
      const float end = first.value_or(1);
      const std::optional<float> found = by_time_of_impact ? time_of_impact(other, end) : shape_cast(other, end);
      if (found) first = *found;
      return true;
    }

    std::optional<float> time_of_impact(const b2DistanceProxy& other, float end) const {
      b2TOIInput input;
      input.proxyA = other;
      input.proxyB = proxy;
      input.sweepA.localCenter.SetZero();
      input.sweepA.c0.SetZero();
      input.sweepA.c.SetZero();
      input.sweepA.a0 = 0;
      input.sweepA.a = 0;
      input.sweepA.alpha0 = 0;
      input.sweepB = input.sweepA;
      input.sweepB.c = mover.motion;
      input.tMax = end;
      b2TOIOutput output;
      b2TimeOfImpact(&output, &input);
      if (output.state != b2TOIOutput::e_touching && output.state != b2TOIOutput::e_overlapped) return std::nullopt;
      return output.t;
    }

    std::optional<float> shape_cast(const b2DistanceProxy& other, float end) const {
      b2ShapeCastInput input;
      input.proxyA = other;
      input.proxyB = proxy;
      input.transformA.SetIdentity();
      input.transformB.SetIdentity();
      input.translationB = end * mover.motion;
      b2ShapeCastOutput output;
      if (!b2ShapeCast(&output, &input)) return std::nullopt;
      return end * output.lambda;
    }

    const Mover& mover;
    b2DistanceProxy proxy;
    std::optional<float> first;
  };

  b2World world_{b2Vec2(0, 0)};
};

}  // namespace bench
