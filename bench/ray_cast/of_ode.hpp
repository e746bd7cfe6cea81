// SPDX-License-Identifier: MIT
// ODE's dCollide of a ray, in double as Debian builds it. Each ray is created once, before it is cast. Without convex
// polytopes, given by planes: ODE missed 712 of 716 hits on them.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>

#include <ode/ode.h>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

struct DestroyGeometry {
  void operator()(dGeomID geometry) const { dGeomDestroy(geometry); }
};
using OdeGeometry = std::unique_ptr<std::remove_pointer_t<dGeomID>, DestroyGeometry>;

/// ODE has tables for the program and for each thread; they are never freed.
inline void start_ode() {
  static const bool is_started = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  static_cast<void>(is_started);
}

inline OdeGeometry ode_at(dGeomID geometry, const Vec<3, double>& center) {
  dGeomSetPosition(geometry, center.x, center.y, center.z);
  return OdeGeometry(geometry);
}

inline OdeGeometry ode_geometry(const Sphere<3, double>& sphere) {
  return ode_at(dCreateSphere(nullptr, sphere.radius), sphere.center);
}
inline OdeGeometry ode_geometry(const Aabb<3, double>& box) {
  const Vec<3, double> sides = box.max - box.min;
  return ode_at(dCreateBox(nullptr, sides.x, sides.y, sides.z), (box.min + box.max) * 0.5);
}
inline OdeGeometry ode_geometry(const Obb<3, double>& box) {
  const Vec<3, double> sides = box.half_extents * 2.0;
  OdeGeometry geometry = ode_at(dCreateBox(nullptr, sides.x, sides.y, sides.z), box.center);
  const auto& m = box.axes;
  const dMatrix3 rotation = {m[0].x, m[1].x, m[2].x, 0, m[0].y, m[1].y, m[2].y, 0, m[0].z, m[1].z, m[2].z, 0};
  dGeomSetRotation(geometry.get(), rotation);
  return geometry;
}
/// ODE's capsules are parallel to z, and their length is that of the axis.
inline OdeGeometry ode_geometry(const Capsule<3, double>& capsule) {
  const Vec<3, double> way = capsule.b - capsule.a;
  OdeGeometry geometry =
      ode_at(dCreateCapsule(nullptr, capsule.radius, std::sqrt(dot(way, way))), (capsule.a + capsule.b) * 0.5);
  dMatrix3 rotation;
  dRFromZAxis(rotation, way.x, way.y, way.z);
  dGeomSetRotation(geometry.get(), rotation);
  return geometry;
}
/// ODE's planes are solid below, but rays hit the surface from both sides.
inline OdeGeometry ode_geometry(const Plane<3, double>& plane) {
  const double length = std::sqrt(dot(plane.normal, plane.normal));
  const Vec<3, double> normal = plane.normal / length;
  return OdeGeometry(dCreatePlane(nullptr, normal.x, normal.y, normal.z, plane.offset / length));
}
inline OdeGeometry ode_geometry(const HalfSpace<3, double>& solid) { return ode_geometry(boundary(solid)); }

class OdeRay {
 public:
  static constexpr const char* name = "ODE dCollide";
  static constexpr double tolerance = 1e-9;

  struct Hit {
    double t;
    Vec<3, double> point;
    Vec<3, double> normal;
  };

  template <class S>
  requires requires(const S& shape) { ode_geometry(shape); }
  explicit OdeRay(const Case<S>& asked) : OdeRay(asked.ray) { body_ = ode_geometry(asked.shape); }

  std::optional<Hit> cast() const {
    dContactGeom contact;
    if (dCollide(path_.get(), body_.get(), 1, &contact, sizeof(contact)) == 0) return std::nullopt;
    return Hit{contact.depth * per_length_,
               {contact.pos[0], contact.pos[1], contact.pos[2]},
               {contact.normal[0], contact.normal[1], contact.normal[2]}};
  }

 private:
  explicit OdeRay(const Ray<3, double>& ray) {
    start_ode();
    const double length = std::sqrt(dot(ray.direction, ray.direction));
    per_length_ = 1 / length;
    path_.reset(dCreateRay(nullptr, static_cast<double>(t_max) * length));
    const Vec<3, double> way = ray.direction / length;
    dGeomRaySet(path_.get(), ray.origin.x, ray.origin.y, ray.origin.z, way.x, way.y, way.z);
  }

  OdeGeometry body_;
  OdeGeometry path_;
  double per_length_ = 0;
};

}  // namespace graze::ray_bench
