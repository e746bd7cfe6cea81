// SPDX-License-Identifier: MIT
// ODE's dCollide, in double as Debian builds it, on two oriented boxes, with up to four contacts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>

#include <benchmark/benchmark.h>
#include <ode/ode.h>

#include "contact/answer.hpp"

namespace graze::contact_bench {

class OdePair {
 public:
  static constexpr const char* name = "ODE";

  OdePair(const Obb& a, const Obb& b) : a_(geometry(a)), b_(geometry(b)) {}

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
  struct Destroy {
    void operator()(dGeomID geometry) const { dGeomDestroy(geometry); }
  };
  using Geometry = std::unique_ptr<std::remove_pointer_t<dGeomID>, Destroy>;

  /// ODE has tables for the whole program and for each thread; they go with the program.
  static void start() {
    static const bool is_started = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    static_cast<void>(is_started);
  }

  static Geometry geometry(const Obb& box) {
    start();
    const Point sides = box.half_extents * 2.0;
    Geometry result(dCreateBox(nullptr, sides.x, sides.y, sides.z));
    dGeomSetPosition(result.get(), box.center.x, box.center.y, box.center.z);
    const auto& x = box.axes[0];
    const auto& y = box.axes[1];
    const auto& z = box.axes[2];
    const dMatrix3 rotation = {x.x, y.x, z.x, 0, x.y, y.y, z.y, 0, x.z, y.z, z.z, 0};
    dGeomSetRotation(result.get(), rotation);
    return result;
  }

  Geometry a_;
  Geometry b_;
};

}  // namespace graze::contact_bench
