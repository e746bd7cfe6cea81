// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <graze/math/vec.hpp>

#include "drawing.hpp"

namespace graze::wasm {

/// Adds the surface of the convex hull of points, and those of its edges at which it bends. Points that lie in one
/// plane, or on one line, give a flat polygon, or a line.
void add_hull(Drawing<3>& drawing, std::span<const Vec<3, double>> points);

/// Adds the convex hull of points in a plane, given by its normal (any length but zero), as a flat polygon that is seen
/// counter-clockwise from where the normal points to.
void add_flat_hull(Drawing<3>& drawing, std::span<const Vec<3, double>> points, const Vec<3, double>& normal);

}  // namespace graze::wasm
