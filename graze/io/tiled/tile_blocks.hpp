// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <graze/io/tiled/merged_cells.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// The width and height of a block, in cells.
inline constexpr std::int64_t tile_block_side = 16;

/// True if a rectangle of cells is no wider and no higher than a block.
bool fits_tile_block(const CellRectangle& cells);

/// One shape for all pieces that begin in the same block, and the range of cells that these cover.
struct TileBlock {
  CellRectangle cells;
  AnyShape<2, double> shape;  ///< A compound, unless there is only one piece.
};

/// Groups pieces of a tile layer by the block that contains their top left cell. Blocks form a regular grid; one of
/// them begins at cell (0, 0).
class TileBlocks {
 public:
  void add(const CellRectangle& cells, AnyShape<2, double> shape);

  /// Calls visit(block) for each block with pieces, row by row, and removes them. The order of the pieces is kept.
  template <class Visit>
  void drain(const Visit& visit) {
    drain_to(blocks_.end(), visit);
  }

  /// The same for the blocks above the one that contains a row of cells.
  template <class Visit>
  void drain_above(std::int64_t row, const Visit& visit) {
    if (!blocks_.empty() && blocks_.begin()->first.row < block_of(row)) {
      drain_to(blocks_.lower_bound({block_of(row), std::numeric_limits<std::int64_t>::min()}), visit);
    }
  }

 private:
  struct Place {
    std::int64_t row;
    std::int64_t column;
    friend auto operator<=>(const Place&, const Place&) = default;
  };

  struct Pieces {
    CellRectangle cells;
    std::vector<AnyShape<2, double>> shapes;
  };

  using Blocks = std::map<Place, Pieces>;

  static std::int64_t block_of(std::int64_t cell);
  static TileBlock joined(Pieces pieces);

  template <class Visit>
  void drain_to(Blocks::iterator end, const Visit& visit) {
    last_ = nullptr;
    for (auto block = blocks_.begin(); block != end; block = blocks_.erase(block)) {
      visit(joined(std::move(block->second)));
    }
  }

  Blocks blocks_;
  Place last_place_{};
  Pieces* last_ = nullptr;  ///< Of the previous piece: the next one is usually in the same block.
};

}  // namespace graze::io
