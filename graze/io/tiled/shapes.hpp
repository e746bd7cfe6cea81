// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <graze/io/tiled/files.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/projection.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// The corners of the polygon that stands for an ellipse.
inline constexpr int tiled_ellipse_corners = 64;

/// The most corners that a polygon may have: cutting it into convex parts takes time that grows with their square.
inline constexpr std::size_t max_tiled_polygon_corners = 10'000;

/// A linear map from the coordinates in which a shape was drawn to those of the scene.
struct TiledFrame {
  Mat<2, double> linear = Mat<2, double>(1.0);
  Vec<2, double> origin = {0.0, 0.0};
  std::optional<double> scale = 1.0;  ///< Where `linear` turns, mirrors and enlarges by this alone: circles stay such.

  Vec<2, double> at(const Vec<2, double>& point) const { return linear * point + origin; }
};

/// First `inner`, then `outer`.
TiledFrame operator*(const TiledFrame& outer, const TiledFrame& inner);

/// The shape of an object, and what is not exactly as the map has it. Without a shape the omission says why.
struct TiledShape {
  std::optional<AnyShape<2, double>> shape;
  OmissionKind omission = {};  ///< Its `what` is empty for none.
};

/// What surrounds an object on its map: how it is projected, by how much its layer is shifted on the screen, and which
/// point of a tile its place is where the tileset says nothing.
struct TiledPlacing {
  const TiledProjection& projection;
  Vec<2, double> shift = {0.0, 0.0};
  TiledAlignment alignment = {};
};

/// What an object of a map covers, in pixels of the screen with y down. A tile object is an upright rectangle, whatever
/// the projection; a turn is about the object's place, on the screen. Rectangles that are neither turned but by quarter
/// turns nor projected are exact up to the rounding of sums. Throws std::invalid_argument when a coordinate overflows.
TiledShape tiled_shape(const TiledResolvedObject& resolved, const TiledPlacing& placing);

/// What an object without a tile covers, drawn on a grid of this projection and then seen through `frame`.
TiledShape tiled_shape(const TiledObject& object, const TiledProjection& projection, const TiledFrame& frame);

}  // namespace graze::io
