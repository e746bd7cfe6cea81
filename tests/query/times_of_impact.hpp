// SPDX-License-Identifier: MIT
// graze's times of impact of shapes of any two types.
#pragma once

#include <optional>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// Two shapes and how they move.
template <Dim N, class T>
struct Moving {
  AnyShape<N, T> a;
  Motion<N, T> motion_a;
  AnyShape<N, T> b;
  Motion<N, T> motion_b;
};

/// time_of_impact(a, motion_a, b, motion_b).
template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const Moving<N, T>& moving) {
  return time_of_impact(moving.a, moving.motion_a, moving.b, moving.motion_b);
}

/// The same before rounding, for shapes that are apart.
template <Dim N, class T>
std::optional<detail::CastHit<N>> cast_hit_of(const Moving<N, T>& moving) {
  return detail::cast_hit_in_motion(moving.a, detail::wide_motion(moving.motion_a), moving.b,
                                    detail::wide_motion(moving.motion_b));
}

}  // namespace graze::test
