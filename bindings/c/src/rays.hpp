// SPDX-License-Identifier: MIT
// Ray casts with the options of C.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <graze/query/ray_cast.hpp>
#include <graze/shape/any_shape.hpp>

#include "../graze.h"
#include "errors.hpp"
#include "results.hpp"

namespace graze::c {

/// Where a ray ends. Throws Error if the limit is negative or NaN.
template <class T>
T limit_in(const graze_ray_options* options) {
  if (options == nullptr || !options->is_limited) return std::numeric_limits<T>::infinity();
  if (options->t_max >= 0) return static_cast<T>(options->t_max);
  throw Error(GRAZE_INVALID_ARGUMENT,
              "options->t_max is " + std::to_string(options->t_max) + "; a number of at least 0 is needed");
}

inline RayOptions ray_options_in(const graze_ray_options* options) {
  return {options != nullptr && options->is_exit ? RaySide::exit : RaySide::entry};
}

/// Of a mesh, with the face that is hit.
template <Dim N, class T>
std::optional<graze_ray_hit> hit_of(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max, RayOptions options) {
  const auto hit_in_c = [](const auto& hit) -> std::optional<graze_ray_hit> {
    if (!hit) return std::nullopt;
    return c_result(*hit);
  };
  if (const auto* const mesh = std::get_if<Mesh<N, T>>(&shape)) return hit_in_c(ray_cast(*mesh, ray, t_max, options));
  return hit_in_c(ray_cast(shape, ray, t_max, options));
}

}  // namespace graze::c
