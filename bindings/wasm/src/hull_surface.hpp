// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <graze/math/vec.hpp>

#include "drawing.hpp"

namespace graze::wasm {

/// Adds the surface of the convex hull of points, and those of its edges at which it bends. Coplanar points give a flat
/// polygon, collinear ones a line.
void add_hull(Drawing<3>& drawing, std::span<const Vec<3, double>> points);

/// Adds the convex hull of points in a plane, given by its normal (of any nonzero length), as a flat polygon,
/// counter-clockwise as seen from the side to which the normal points.
void add_flat_hull(Drawing<3>& drawing, std::span<const Vec<3, double>> points, const Vec<3, double>& normal);

}  // namespace graze::wasm
