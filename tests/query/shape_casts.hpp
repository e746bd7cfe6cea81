// SPDX-License-Identifier: MIT
// graze's casts of shapes of any two types: compiled once for each space, by shape_casts.cpp.in.
#pragma once

#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/proximity.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// shape_cast(a, motion, b).
template <Dim N, class T>
std::optional<Impact<N, T>> impact_of(const AnyShape<N, T>& a, const Vec<N, T>& motion, const AnyShape<N, T>& b);

/// The same before rounding.
template <Dim N, class T>
std::optional<detail::CastHit<N>> cast_hit_of(const AnyShape<N, T>& a, const Vec<N, T>& motion,
                                              const AnyShape<N, T>& b);

}  // namespace graze::test
