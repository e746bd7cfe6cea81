// SPDX-License-Identifier: MIT
// The first filters of rays, for every shape that has one.
#pragma once

#include <graze/query/ray_ball_filter.hpp>
#include <graze/query/ray_box_filter.hpp>
#include <graze/query/ray_capsule_filter.hpp>
#include <graze/query/ray_obb_filter.hpp>
#include <graze/query/ray_plane_filter.hpp>
#include <graze/query/ray_polygon_filter.hpp>
#include <graze/query/ray_rectangle_filter.hpp>
#include <graze/query/ray_triangle_filter.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// One of which a filter settles most rays in few steps, in float or without care: `quick_cast` has a `sight`, and a
/// `hit` where that is one. It never contradicts the careful way, which is asked where it is unclear.
template <class S>
concept HasQuickCast = requires(const S& shape, const Ray<dimension_of<S>, scalar_of<S>>& ray) {
  quick_cast(shape, ray, ray.origin.x);
};

}  // namespace graze::detail
