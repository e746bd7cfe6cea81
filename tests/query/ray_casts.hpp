// SPDX-License-Identifier: MIT
// graze's answers for rays and any shape. Functions that visit each type of shape are compiled once for each space, by
// ray_casts.cpp.in.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// ray_cast(shape, ray, t_max, options).
template <Dim N, class T>
std::optional<RayHit<N, T>> hit_of(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max,
                                   RayOptions options = {}) {
  return ray_cast(shape, ray, t_max, options);
}

/// ray_cast(shape, segment, options).
template <Dim N, class T>
std::optional<RayHit<N, T>> hit_of(const AnyShape<N, T>& shape, const Segment<N, T>& segment, RayOptions options = {}) {
  return ray_cast(shape, segment, options);
}

/// intersects(shape, ray) for the shape as its own type.
template <Dim N, class T>
bool meet_as_held(const AnyShape<N, T>& shape, const Ray<N, T>& ray);

/// The signed distance of a point in double: for a compound, the minimum over its parts; for sets without thickness,
/// positive.
template <Dim N, class T>
double height_of(const AnyShape<N, T>& shape, const Vec<N, double>& point);

}  // namespace graze::test
