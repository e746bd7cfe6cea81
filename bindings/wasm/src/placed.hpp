// SPDX-License-Identifier: MIT
// Translates shapes.
#pragma once

#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

/// The shape translated so that the center of its box, `box`, is at a point; for spheres and oriented boxes their own
/// center, exactly. The box must be finite.
template <Dim N>
AnyShape<N, double> placed(const AnyShape<N, double>& shape, const Aabb<N, double>& box, const Vec<N, double>& point) {
  if (std::holds_alternative<Vec<N, double>>(shape)) return point;
  if (const auto* const sphere = std::get_if<Sphere<N, double>>(&shape)) {
    return Sphere<N, double>{point, sphere->radius};
  }
  if (const auto* const obb = std::get_if<Obb<N, double>>(&shape)) {
    return Obb<N, double>{point, obb->half_extents, obb->axes};
  }
  return translated<N, double>(shape, point - box.center());
}

}  // namespace graze::wasm
