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

/// The cells of a block in each direction.
inline constexpr std::int64_t tile_block_side = 16;

/// True when a rectangle of cells is no wider and no higher than a block.
bool fits_tile_block(const CellRectangle& cells);

/// One shape for all pieces that begin in the same block, and the cells that these cover, from the first to the last.
struct TileBlock {
  CellRectangle cells;
  AnyShape<2, double> shape;  ///< A compound, unless there is but one piece.
};

/// Gathers pieces of a tile layer by the block of cells in which their top left cell is. Blocks lie side by side, one
/// of them begins at cell (0, 0).
class TileBlocks {
 public:
  void add(const CellRectangle& cells, AnyShape<2, double> shape);

  /// Calls visit(block) for each block that has pieces, row by row, and forgets them. Pieces keep their order.
  template <class Visit>
  void drain(const Visit& visit) {
    drain_to(blocks_.end(), visit);
  }

  /// The same for the blocks above the one that holds a row of cells.
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
  Pieces* last_ = nullptr;  ///< Of the last piece: the next one is mostly in the same block.
};

}  // namespace graze::io
