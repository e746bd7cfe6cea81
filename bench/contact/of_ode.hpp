// SPDX-License-Identifier: MIT
// ODE's dCollide, in double as Debian builds it, for spheres, capsules and boxes, with up to four contacts.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>

#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include "../bench/contact/answer.hpp"

namespace graze::contact_bench {

/// A shape in ODE's form.
class OdeShape {
 public:
  explicit OdeShape(const Sphere& sphere) : geometry_((start(), dCreateSphere(nullptr, sphere.radius))) {
    place(sphere.center);
  }
  explicit OdeShape(const Aabb& box) : OdeShape(box.max - box.min) { place((box.min + box.max) * 0.5); }
  explicit OdeShape(const Obb& box) : OdeShape(box.half_extents * 2.0) {
    place(box.center);
    const auto& x = box.axes[0];
    const auto& y = box.axes[1];
    const auto& z = box.axes[2];
    const dMatrix3 rotation = {x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0};
    dGeomSetRotation(geometry_.get(), rotation);
  }
  explicit OdeShape(const Capsule& capsule) {
    start();
    const Point way = capsule.b - capsule.a;
    geometry_.reset(dCreateCapsule(nullptr, capsule.radius, std::sqrt(dot(way, way))));
    place((capsule.a + capsule.b) * 0.5);
    dMatrix3 rotation;
    dRFromZAxis(rotation, way.x, way.y, way.z);
    dGeomSetRotation(geometry_.get(), rotation);
  }

  dGeomID get() const { return geometry_.get(); }

 private:
  struct Destroy {
    void operator()(dGeomID geometry) const { dGeomDestroy(geometry); }
  };

  /// ODE has tables for the program and for each thread; they are never freed.
  static void start() {
    static const bool is_started = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    static_cast<void>(is_started);
  }

  explicit OdeShape(const Point& sides) : geometry_((start(), dCreateBox(nullptr, sides.x, sides.y, sides.z))) {}

  void place(const Point& center) { dGeomSetPosition(geometry_.get(), center.x, center.y, center.z); }

  std::unique_ptr<std::remove_pointer_t<dGeomID>, Destroy> geometry_;
};

class OdePair {
 public:
  static constexpr const char* name = "ODE";

  template <class A, class B>
  OdePair(const A& a, const B& b) : a_(a), b_(b) {}

  Answer find() const {
    constexpr int most_contacts = 4;
    std::array<dContactGeom, most_contacts> contacts;
    const int count = dCollide(a_.get(), b_.get(), most_contacts, contacts.data(), sizeof(dContactGeom));
    benchmark::DoNotOptimize(contacts);
    Answer answer{static_cast<std::size_t>(count), 0};
    for (std::size_t i = 0; i < answer.count; ++i) answer.depth = std::max(answer.depth, contacts[i].depth);
    return answer;
  }

 private:
  OdeShape a_;
  OdeShape b_;
};

}  // namespace graze::contact_bench
