// SPDX-License-Identifier: MIT
// Triangles of the polygons in mesh files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>

namespace graze::io {

/// The most corners that a polygon may have: cutting one may take time quadratic in their number.
inline constexpr std::size_t max_polygon_corners = 10'000;

/// Appends triangles on the corners of a polygon, in its direction: n - 2 of n corners, none of fewer than three. All
/// corners are used, also those that lie straight between their neighbours, so that neighbouring polygons still share
/// edges. The polygon is cut as it is seen along the axis nearest to its normal: into a fan from its first corner if
/// all triangles of the fan have the same orientation there, else by its ears (EarClipper). One that crosses itself in
/// that view, or has no area, becomes a fan, too. `corners` are indices of `vertices`, at most `max_polygon_corners`.
void append_triangles(std::vector<std::array<std::uint32_t, 3>>& faces, std::span<const Vec<3, double>> vertices,
                      std::span<const std::uint32_t> corners);

}  // namespace graze::io
