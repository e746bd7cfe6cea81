// SPDX-License-Identifier: MIT
// Shapes of C as AnyShape and back, by the description of their fields (graze/shape/fields/description.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "../graze.h"
#include "handles.hpp"
#include "world.hpp"

namespace graze::c {

/// The polytope, compound or mesh behind a handle.
struct Geometry {
  InAnyWorld<AnyShape> any;
};

HandleTable<const Geometry>& geometries();

/// A valid shape of a call, which shares its geometry until the end of the call.
template <Dim N, class T>
class ShapeIn {
 public:
  /// `role` names the argument. Throws Error for a shape that is not valid, or of another world.
  ShapeIn(std::string_view role, const graze_shape& shape);

  const AnyShape<N, T>& operator*() const { return geometry_ ? *std::get_if<AnyShape<N, T>>(&geometry_->any) : value_; }

 private:
  AnyShape<N, T> value_;
  std::shared_ptr<const Geometry> geometry_;
};

/// Calls use(shape) for a shape of any world.
template <class Use>
auto on_shape(const char* role, const graze_shape* shape, const Use& use) {
  const graze_shape& given = required(role, shape);
  return in_world(given.world, [&]<Dim N, class T>(In<N, T>) { return use(*ShapeIn<N, T>(role, given)); });
}

/// Calls use(mesh). Throws Error for a shape that is none.
template <class Use>
auto on_mesh(const char* role, const graze_shape* shape, const Use& use);

/// Calls use(a, b) for two shapes of one world.
template <class Use>
auto on_pair(const graze_shape* a, const graze_shape* b, const Use& use) {
  const graze_shape& given_a = required("a", a);
  const graze_shape& given_b = required("b", b);
  require_world("a", given_a.world, "b", given_b.world);
  return in_world(given_a.world, [&]<Dim N, class T>(In<N, T>) {
    const ShapeIn<N, T> in_a("a", given_a);
    const ShapeIn<N, T> in_b("b", given_b);
    return use(*in_a, *in_b);
  });
}

/// Copies of valid shapes, all of the world N, T.
template <Dim N, class T>
std::vector<AnyShape<N, T>> shapes_in(std::string_view role, const graze_shape* shapes, std::size_t count);

/// A shape as C has it. For one of any size it creates a geometry.
template <Dim N, class T>
graze_shape shape_out(AnyShape<N, T> shape);

[[noreturn]] void refuse_kind(std::string_view role, graze_kind kind, const char* needed);

template <class Use>
auto on_mesh(const char* role, const graze_shape* shape, const Use& use) {
  if (required(role, shape).kind != GRAZE_MESH) refuse_kind(role, shape->kind, "a mesh");
  return on_shape(role, shape,
                  [&]<Dim N, class T>(const AnyShape<N, T>& any) { return use(*std::get_if<Mesh<N, T>>(&any)); });
}

}  // namespace graze::c
