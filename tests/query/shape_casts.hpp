// SPDX-License-Identifier: MIT
// graze's casts of shapes of any two types.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// shape_cast(a, motion, b).
template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const AnyShape<N, T>& a, const Vec<N, T>& motion, const AnyShape<N, T>& b) {
  return detail::impact_of(a, motion, b);
}

/// The same before rounding.
template <Dim N, class T>
std::optional<detail::CastHit<N>> cast_hit_of(const AnyShape<N, T>& a, const Vec<N, T>& motion,
                                              const AnyShape<N, T>& b) {
  if (const auto contact = detail::penetration(a, b)) return detail::cast_hit_at_start(*contact);
  return max_abs(motion) == T(0) ? std::nullopt : detail::cast_hit(a, wide<N, T>(motion), b);
}

}  // namespace graze::test
