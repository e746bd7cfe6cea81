// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include <graze/math/platform/throw.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/transformed.hpp>

namespace graze {

/// All points origin + t * direction with t >= 0. The direction may have any nonzero length, which is the unit of t.
template <Dim N, class T = float>
struct Ray {
  Vec<N, T> origin = Vec<N, T>(T(0));        ///< Where t is 0.
  Vec<N, T> direction = unit_axis<N, T>(0);  ///< Any nonzero length; t counts in units of it.
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Ray<N, T>> = Description("ray", field::point("origin", &Ray<N, T>::origin),
                                                              field::direction("direction", &Ray<N, T>::direction));
}  // namespace detail

/// The ray from one point through another, which is at t = 1. Throws std::invalid_argument if the points are equal.
template <Dim N, class T>
Ray<N, T> ray_between(const Vec<N, T>& from, const Vec<N, T>& to) {
  if (from == to)
    GRAZE_THROW(std::invalid_argument("ray_between: the two points are equal, so the ray has no direction"));
  return {from, to - from};
}

}  // namespace graze
