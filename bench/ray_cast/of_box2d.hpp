// SPDX-License-Identifier: MIT
// Box2D's RayCast (float) against a circle, an edge, a polygon, which it also uses for boxes and triangles, and an
// axis-aligned box. Shapes have no transform.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

inline b2Vec2 box2d(const Vec<2, float>& v) { return {v.x, v.y}; }

/// Takes corners in counter-clockwise order. Filled in by hand, because Set would weld nearby corners.
inline b2PolygonShape box2d_polygon(std::span<const Vec<2, float>> corners) {
  b2PolygonShape polygon;
  polygon.m_count = static_cast<int32>(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    polygon.m_vertices[i] = box2d(corners[i]);
    polygon.m_normals[i] = b2Cross(box2d(corners[(i + 1) % corners.size()] - corners[i]), 1.0F);
    polygon.m_normals[i].Normalize();
  }
  return polygon;
}

inline b2CircleShape box2d_shape(const Sphere<2, float>& circle) {
  b2CircleShape shape;
  shape.m_p = box2d(circle.center);
  shape.m_radius = circle.radius;
  return shape;
}
inline b2EdgeShape box2d_shape(const Segment<2, float>& segment) {
  b2EdgeShape shape;
  shape.SetTwoSided(box2d(segment.start), box2d(segment.end));
  return shape;
}
inline b2PolygonShape box2d_shape(const Obb<2, float>& box) {
  const Vec<2, float> x = box.axes[0] * box.half_extents.x;
  const Vec<2, float> y = box.axes[1] * box.half_extents.y;
  return box2d_polygon(std::array{box.center - x - y, box.center + x - y, box.center + x + y, box.center - x + y});
}
inline b2PolygonShape box2d_shape(const Polytope<2, float>& polygon) { return box2d_polygon(polygon.vertices()); }
inline b2PolygonShape box2d_shape(const Triangle<2, float>& triangle) {
  return box2d_shape(convex_hull<2, float>(std::array{triangle.a, triangle.b, triangle.c}));
}
inline b2AABB box2d_shape(const Aabb<2, float>& box) {
  b2AABB result;
  result.lowerBound = box2d(box.min);
  result.upperBound = box2d(box.max);
  return result;
}

template <class S>
class Box2dRay {
 public:
  static constexpr const char* name = "Box2D RayCast";
  static constexpr double tolerance = 1e-5;

  struct Hit {
    float t;
    Vec<2, float> normal;
  };

  explicit Box2dRay(const Case<S>& asked)
      : shape_(box2d_shape(asked.shape)),
        path_{box2d(asked.ray.origin), box2d(asked.ray.origin + asked.ray.direction * t_max), 1} {}

  std::optional<Hit> cast() const {
    b2RayCastOutput output;
    if (!is_hit(shape_, output)) return std::nullopt;
    return Hit{output.fraction * t_max, {output.normal.x, output.normal.y}};
  }

 private:
  bool is_hit(const b2AABB& box, b2RayCastOutput& output) const { return box.RayCast(&output, path_); }
  bool is_hit(const b2Shape& shape, b2RayCastOutput& output) const {
    static const b2Transform at_home(b2Vec2(0, 0), b2Rot(0));
    return shape.RayCast(&output, path_, at_home, 0);
  }

  decltype(box2d_shape(std::declval<S>())) shape_;
  b2RayCastInput path_;
};

}  // namespace graze::ray_bench
