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

/// One of which a filter settles most rays in few steps, in float or without care: `quick_cast` has a `sight`, and a
/// `hit` where that is one. It never contradicts the careful way, which is asked where it is unclear.
template <class S>
concept HasQuickCast = requires(const S& shape, const Ray<dimension_of<S>, scalar_of<S>>& ray) {
  quick_cast(shape, ray, ray.origin.x);
};

}  // namespace graze::detail
