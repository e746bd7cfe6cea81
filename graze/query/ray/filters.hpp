// SPDX-License-Identifier: MIT
// The first filters of rays, for every shape that has one.
#pragma once

#include <graze/query/ray/filter/box.hpp>
#include <graze/query/ray/filter/capsule.hpp>
#include <graze/query/ray/filter/obb.hpp>
#include <graze/query/ray/filter/plane.hpp>
#include <graze/query/ray/filter/polygon.hpp>
#include <graze/query/ray/filter/rectangle.hpp>
#include <graze/query/ray/filter/sphere.hpp>
#include <graze/query/ray/filter/triangle.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A shape for which a filter decides most rays in few steps, in float or with little precision: `quick_cast` has a
/// `sight`, and a `hit` if the verdict is one. It never contradicts the precise algorithm, which decides what is
/// unclear.
template <class S>
concept HasQuickCast = requires(const S& shape, const Ray<dimension_of<S>, scalar_of<S>>& ray) {
  quick_cast(shape, ray, ray.origin.x);
};

}  // namespace graze::detail
