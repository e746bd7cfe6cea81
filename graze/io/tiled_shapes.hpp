// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <graze/io/tiled_files.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// The corners of the polygon that stands for an ellipse.
inline constexpr int tiled_ellipse_corners = 64;

/// The most corners that a polygon may have: cutting it into convex parts takes time that grows with their square.
inline constexpr std::size_t max_tiled_polygon_corners = 10'000;

/// The shape of an object, and what is not exactly as the map has it ("ellipse drawn as a 64-gon"; empty for nothing).
/// Without a shape the omission says why.
struct TiledShape {
  std::optional<AnyShape<2, double>> shape;
  std::string_view omission;
};

/// What an object of a map covers, in pixels with y down. `shift` is that of the layers around it; `alignment` is for
/// tiles whose tileset names none. Rectangles that are not turned, or by quarter turns, are exact up to the rounding of
/// sums. Throws std::invalid_argument when a coordinate overflows.
TiledShape tiled_shape(const TiledResolvedObject& resolved, const Vec<2, double>& shift,
                       const TiledAlignment& alignment);

}  // namespace graze::io
