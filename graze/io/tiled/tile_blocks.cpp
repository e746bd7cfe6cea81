// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <graze/io/tiled/tile_blocks.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io {
bool fits_tile_block(const CellRectangle& cells) {
  return cells.end - cells.begin <= tile_block_side && cells.bottom - cells.top <= tile_block_side;
}

std::int64_t TileBlocks::block_of(std::int64_t cell) {
  return (cell >= 0 ? cell : cell - (tile_block_side - 1)) / tile_block_side;
}

void TileBlocks::add(const CellRectangle& cells, AnyShape<2, double> shape) {
  const Place place{block_of(cells.top), block_of(cells.begin)};
  if (last_ == nullptr || place != last_place_) {
    last_ = &blocks_[place];
    last_place_ = place;
  }
  CellRectangle& around = last_->cells;
  if (last_->shapes.empty()) around = cells;
  around = {std::min(around.begin, cells.begin), std::max(around.end, cells.end), std::min(around.top, cells.top),
            std::max(around.bottom, cells.bottom)};
  last_->shapes.push_back(std::move(shape));
}

TileBlock TileBlocks::joined(Pieces pieces) {
  if (pieces.shapes.size() == 1) return {pieces.cells, std::move(pieces.shapes.front())};
  return {pieces.cells, compound_of<2, double>(std::move(pieces.shapes))};
}

}  // namespace graze::io
