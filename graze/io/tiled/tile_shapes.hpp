// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <graze/io/tiled/files.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/projection.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// What a tile of a layer covers, when the bottom left corner of its cell is the origin.
struct TiledTileShapes {
  std::vector<AnyShape<2, double>> shapes;
  std::vector<OmissionKind> omissions;  ///< Of its collision shapes, one for each that is not exactly there.
  bool fills_cell = false;              ///< The only shape is the cell, from edge to edge.
};

/// The collision shapes of a tile as Tiled draws them, flipped and turned as the upper bits of `gid` say.
TiledTileShapes tiled_tile_shapes(const TiledTileUse& tile, std::uint32_t gid, const TiledProjection& projection);

/// The corners of the cells from `begin` to before `end`, on the screen, in order around. Only where there are rows.
std::array<Vec<2, double>, 4> tiled_corners_of_cells(const TiledProjection& projection,
                                                     const Vec<2, std::int64_t>& begin,
                                                     const Vec<2, std::int64_t>& end);

}  // namespace graze::io
