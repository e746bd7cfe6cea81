// SPDX-License-Identifier: MIT
// What shape_cast.hpp makes of rays. Include shape_cast.hpp.
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// ray_cast(shape, ray, 1) before t is rounded, for a direction that is not zero.
template <class S, class T>
std::optional<RayHit<dimension_of<S>, double>> hit_in_double(const S& shape, const Ray<dimension_of<S>, T>& ray) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasQuickCast<S> && std::is_same_v<T, double>) {
    const auto quick = quick_cast(shape, ray, 1.0);
    if (quick.sight() == Sight::misses) return std::nullopt;
    if (quick.sight() == Sight::hits) return quick.hit();
  }
  const Usable<N, T> usable(ray);
  const Path<N> path{wide<N, T>(ray.origin), wide<N, T>(usable.ray.direction), usable.to_usable(1.0)};
  const Sighting<N> found = find_carefully(shape, path, RaySide::entry, AskAboutRay<N, T>{usable.ray, path});
  if (found.sight == Sight::misses) return std::nullopt;
  const double t = std::min(1.0, usable.from_usable(found.touch.t));
  return rounded<N, double>(found.touch, t, path.direction, RaySide::entry);
}

template <Dim N>
std::optional<Strike<N>> strike_of_hit(const std::optional<RayHit<N, double>>& hit) {
  if (!hit) return std::nullopt;
  return Strike<N>{hit->t, hit->point, -hit->normal, hit->status, hit->error};
}

}  // namespace graze::detail
