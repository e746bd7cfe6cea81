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

/// The number of corners of the polygon that replaces an ellipse.
inline constexpr int tiled_ellipse_corners = 64;

/// The most corners that a polygon may have, because the time for convex decomposition grows with their square.
inline constexpr std::size_t max_tiled_polygon_corners = 10'000;

/// A linear map from the coordinates of a drawn shape to those of the scene.
struct TiledFrame {
  Mat<2, double> linear = Mat<2, double>(1.0);
  Vec<2, double> origin = {0.0, 0.0};
  std::optional<double> scale =
      1.0;  ///< Set if `linear` only rotates, reflects and scales by this factor: then circles stay circles.

  Vec<2, double> at(const Vec<2, double>& point) const { return linear * point + origin; }
};

/// First `inner`, then `outer`.
TiledFrame operator*(const TiledFrame& outer, const TiledFrame& inner);

/// The shape of an object, and what is approximated. Without a shape the omission gives the reason.
struct TiledShape {
  std::optional<AnyShape<2, double>> shape;
  OmissionKind omission = {};  ///< Its `what` is empty if there is none.
};

/// The context of an object on its map: the projection, the screen offset of its layer, and the default alignment of
/// tile objects, for tilesets that do not specify one.
struct TiledPlacing {
  const TiledProjection& projection;
  Vec<2, double> shift = {0.0, 0.0};
  TiledAlignment alignment = {};
};

/// The shape of an object of a map, in screen pixels with y down. A tile object is an upright rectangle in every
/// projection; rotation is about the object's position, on the screen. Unprojected rectangles whose rotation is a
/// multiple of 90 degrees are exact up to the rounding of sums. Throws std::invalid_argument if a coordinate overflows.
TiledShape tiled_shape(const TiledResolvedObject& resolved, const TiledPlacing& placing);

/// The shape of an object without a tile, drawn on a grid with this projection and then transformed by `frame`.
TiledShape tiled_shape(const TiledObject& object, const TiledProjection& projection, const TiledFrame& frame);

}  // namespace graze::io
