// SPDX-License-Identifier: MIT
// hull_faces(points): the surface of the convex hull of 3D points. graze::graze holds it compiled.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The indices of three points, counter-clockwise as seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// The surface of the convex hull, for finite points in any order, with duplicates allowed: a closed mesh of triangles,
/// none of them degenerate. Sides are decided exactly, so no corner is lost, however nearly coplanar the points are. A
/// face with more than three corners becomes several triangles, whose corners may include points inside that face or on
/// its edges. Empty if all points are coplanar, exactly.
template <class T>
GRAZE_EXPORT std::vector<HullTriangle> hull_faces(std::span<const Vec<3, T>> points);

#ifdef GRAZE_COMPILED_QUERIES
extern template std::vector<HullTriangle> hull_faces(std::span<const Vec<3, float>>);
extern template std::vector<HullTriangle> hull_faces(std::span<const Vec<3, double>>);
#endif

}  // namespace graze::detail

#ifndef GRAZE_COMPILED_QUERIES
#include <graze/shape/hull/faces-inl.hpp>  // IWYU pragma: export
#endif
