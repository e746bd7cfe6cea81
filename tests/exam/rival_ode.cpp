// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <ode/ode.h>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {
namespace {

using Vec3 = Vec<3, double>;

/// A failed assertion of ODE, such as that of a normal for a sphere of radius zero; by default it ends the program.
struct Refusal {};

// NOLINTNEXTLINE(cert-dcl50-cpp): what ODE calls
void refuse(int, const char*, va_list) { throw Refusal(); }

/// ODE has tables for the program and for each thread.
class Library {
 public:
  Library() {
    dInitODE2(0);
    dSetDebugHandler(refuse);
  }
  ~Library() { dCloseODE(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

void start_library() {
  static const Library library;
  static thread_local const int is_ready = dAllocateODEDataForThread(dAllocateMaskAll);
  static_cast<void>(is_ready);
}

struct DestroyGeometry {
  void operator()(dGeomID geometry) const { dGeomDestroy(geometry); }
};
using Geometry = std::unique_ptr<std::remove_pointer_t<dGeomID>, DestroyGeometry>;

Geometry placed_at(dGeomID geometry, const Vec3& center) {
  dGeomSetPosition(geometry, center.x, center.y, center.z);
  return Geometry(geometry);
}

void turn(dGeomID geometry, const Mat<3, double>& axes) {
  const dMatrix3 rotation = {axes[0].x, axes[1].x, axes[2].x, 0,         axes[0].y, axes[1].y,
                             axes[2].y, 0,         axes[0].z, axes[1].z, axes[2].z, 0};
  dGeomSetRotation(geometry, rotation);
}

struct GeometryOf {
  Geometry operator()(const Sphere<3, double>& sphere) const {
    return placed_at(dCreateSphere(nullptr, sphere.radius), sphere.center);
  }
  Geometry operator()(const Aabb<3, double>& box) const {
    const Vec3 sides = box.max - box.min;
    return placed_at(dCreateBox(nullptr, sides.x, sides.y, sides.z), (box.min + box.max) * 0.5);
  }
  Geometry operator()(const Obb<3, double>& box) const {
    const Vec3 sides = box.half_extents * 2.0;
    Geometry geometry = placed_at(dCreateBox(nullptr, sides.x, sides.y, sides.z), box.center);
    turn(geometry.get(), box.axes);
    return geometry;
  }
  /// ODE's capsules are parallel to z, and their length is that of the axis.
  Geometry operator()(const Capsule<3, double>& capsule) const {
    const Vec3 way = capsule.b - capsule.a;
    const double length = std::sqrt(dot(way, way));
    Geometry geometry = placed_at(dCreateCapsule(nullptr, capsule.radius, length), (capsule.a + capsule.b) * 0.5);
    if (length > 0) {
      dMatrix3 rotation;
      dRFromZAxis(rotation, way.x, way.y, way.z);
      dGeomSetRotation(geometry.get(), rotation);
    }
    return geometry;
  }
  /// ODE's planes are solid below. It normalises the normal.
  Geometry operator()(const HalfSpace<3, double>& solid) const {
    const double length = std::sqrt(dot(solid.normal, solid.normal));
    const Vec3 normal = solid.normal / length;
    return Geometry(dCreatePlane(nullptr, normal.x, normal.y, normal.z, solid.offset / length));
  }
  template <class S>
  Geometry operator()(const S&) const {
    return nullptr;
  }
};

/// The maximum for a pair of boxes.
constexpr int most_contacts = 8;

/// The number of contacts from dCollide; none if it refuses.
std::optional<int> collide(const Geometry& a, const Geometry& b, std::array<dContactGeom, most_contacts>& contacts) {
  try {
    return dCollide(a.get(), b.get(), most_contacts, contacts.data(), sizeof(dContactGeom));
  } catch (const Refusal&) {
    return std::nullopt;
  }
}

/// The contacts of two shapes, up to a maximum; none if it has no test for them, or refuses.
std::optional<std::vector<dContactGeom>> contacts_of(const Solid3<double>& a, const Solid3<double>& b) {
  if (std::holds_alternative<HalfSpace<3, double>>(a) && std::holds_alternative<HalfSpace<3, double>>(b))
    return std::nullopt;
  start_library();
  const Geometry of_a = std::visit(GeometryOf(), a);
  const Geometry of_b = std::visit(GeometryOf(), b);
  if (!of_a || !of_b) return std::nullopt;
  std::array<dContactGeom, most_contacts> contacts{};
  const std::optional<int> count = collide(of_a, of_b, contacts);
  if (!count) return std::nullopt;
  return std::vector<dContactGeom>(contacts.begin(), contacts.begin() + *count);
}

}  // namespace

std::optional<Proximity> ode_parting(const Solid3<double>& a, const Solid3<double>& b) {
  const auto contacts = contacts_of(a, b);
  if (!contacts) return std::nullopt;
  Proximity deepest;
  for (const dContactGeom& contact : *contacts) {
    if (deepest.meets && contact.depth <= deepest.depth) continue;
    // The normal is the direction in which a moves.
    deepest = {true, contact.depth, -Vec3(contact.normal[0], contact.normal[1], contact.normal[2])};
  }
  return deepest;
}

std::optional<ContactPatch> ode_patch(const Solid3<double>& a, const Solid3<double>& b) {
  const auto contacts = contacts_of(a, b);
  if (!contacts) return std::nullopt;
  ContactPatch patch;
  for (const dContactGeom& contact : *contacts)
    patch.push_back({Vec3(contact.pos[0], contact.pos[1], contact.pos[2]), contact.depth});
  return patch;
}

std::optional<bool> ode_answer(const Solid3<double>& a, const Solid3<double>& b) {
  const std::optional<Proximity> parting = ode_parting(a, b);
  if (!parting) return std::nullopt;
  return parting->meets;
}

std::optional<RayVerdict> ode_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double reach) {
  // for which it searches for the surface
  if (std::holds_alternative<HalfSpace<3, double>>(shape)) return std::nullopt;
  start_library();
  const Geometry body = std::visit(GeometryOf(), shape);
  if (!body) return std::nullopt;
  const Geometry path(dCreateRay(nullptr, reach));
  const Vec3& o = ray.origin;
  const Vec3 way = ray.direction / std::sqrt(dot(ray.direction, ray.direction));
  dGeomRaySet(path.get(), o.x, o.y, o.z, way.x, way.y, way.z);
  std::array<dContactGeom, most_contacts> contacts{};
  const std::optional<int> count = collide(path, body, contacts);
  if (!count) return std::nullopt;
  return RayVerdict{*count > 0, contacts[0].depth};
}

}  // namespace graze::exam
