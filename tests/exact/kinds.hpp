// SPDX-License-Identifier: MIT
// Which shapes the oracle splits into parts, and which are unbounded.
#pragma once

#include <graze/shape/any_shape.hpp>

namespace graze::test {

template <class S>
inline constexpr bool is_plane_or_half_space = false;
template <Dim N, class T>
inline constexpr bool is_plane_or_half_space<Plane<N, T>> = true;
template <Dim N, class T>
inline constexpr bool is_plane_or_half_space<HalfSpace<N, T>> = true;

template <class S>
inline constexpr bool is_ray = false;
template <Dim N, class T>
inline constexpr bool is_ray<Ray<N, T>> = true;

template <class S>
inline constexpr bool has_parts = false;
template <Dim N, class T>
inline constexpr bool has_parts<Compound<N, T>> = true;
template <Dim N, class T>
inline constexpr bool has_parts<Mesh<N, T>> = true;

}  // namespace graze::test
