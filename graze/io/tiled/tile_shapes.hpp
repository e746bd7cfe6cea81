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

/// The shapes of a layer's tile, with the bottom left corner of its cell as the origin.
struct TiledTileShapes {
  std::vector<AnyShape<2, double>> shapes;
  std::vector<OmissionKind> omissions;  ///< One for each collision shape that is missing or approximated.
  bool fills_cell = false;              ///< The only shape covers the cell completely.
};

/// The collision shapes of a tile as Tiled draws them, flipped and rotated according to the upper bits of `gid`.
TiledTileShapes tiled_tile_shapes(const TiledTileUse& tile, std::uint32_t gid, const TiledProjection& projection);

/// The corners of the cells from `begin` to before `end`, on the screen, in order. Only on maps with rows.
std::array<Vec<2, double>, 4> tiled_corners_of_cells(const TiledProjection& projection,
                                                     const Vec<2, std::int64_t>& begin,
                                                     const Vec<2, std::int64_t>& end);

}  // namespace graze::io
