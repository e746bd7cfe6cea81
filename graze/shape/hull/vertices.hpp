// SPDX-License-Identifier: MIT
// hull_vertices(points): the corners of the convex hull of 3D points. graze::graze holds it compiled, since few of the
// files that include a polytope construct one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The indices of the corners of the convex hull, each once, decided exactly: a point in the hull of the others is not
/// a corner. At least one point and fewer than 2^32, all finite.
template <class T>
GRAZE_EXPORT std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, T>> points);

#ifdef GRAZE_COMPILED_QUERIES
extern template std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, float>>);
extern template std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, double>>);
#endif

}  // namespace graze::detail

#ifndef GRAZE_COMPILED_QUERIES
#include <graze/shape/hull/vertices-inl.hpp>  // IWYU pragma: export
#endif
