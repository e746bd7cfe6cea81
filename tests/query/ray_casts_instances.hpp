// SPDX-License-Identifier: MIT
// The definitions behind ray_casts.hpp, for the files that instantiate them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/visit.hpp>

#include "query/ray_casts.hpp"

namespace graze::test {

template <Dim N, class T>
std::optional<RayHit<N, T>> hit_of(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max, RayOptions options) {
  return ray_cast(shape, ray, t_max, options);
}

template <Dim N, class T>
std::optional<RayHit<N, T>> hit_of(const AnyShape<N, T>& shape, const Segment<N, T>& segment, RayOptions options) {
  return ray_cast(shape, segment, options);
}

template <Dim N, class T>
bool meet_as_held(const AnyShape<N, T>& shape, const Ray<N, T>& ray) {
  return detail::visit(
      [&ray](const auto& held) {
        const bool is_met = intersects(held, ray);
        EXPECT_EQ(intersects(ray, held), is_met);
        return is_met;
      },
      shape);
}

template <Dim N, class T>
double height_of(const AnyShape<N, T>& shape, const Vec<N, double>& point) {
  return detail::visit(
      [&point](const auto& held) {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, Compound<N, T>>) {
          double least = std::numeric_limits<double>::infinity();
          for (const Part<N, T>& part : held.parts) least = std::min(least, height_of<N, T>(part.shape, point));
          return least;
        } else {
          const double height = detail::surface_point(held, point).distance;
          return std::is_same_v<std::decay_t<decltype(held)>, Plane<N, T>> ? std::fabs(height) : height;
        }
      },
      shape);
}

}  // namespace graze::test
