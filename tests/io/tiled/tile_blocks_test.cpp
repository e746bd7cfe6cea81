// SPDX-License-Identifier: MIT
#include <cstdint>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/tile_blocks.hpp>

namespace graze::io::tile_blocks_test {
namespace {

using Point = Vec<2, double>;

/// A piece of this many cells, and a point that identifies it.
struct Piece {
  CellRectangle cells;
  double x;
};

struct Block {
  CellRectangle cells;
  std::vector<double> xs;

  friend bool operator==(const Block&, const Block&) = default;
};

std::vector<Block> blocks_of(const std::vector<Piece>& pieces) {
  TileBlocks gathered;
  for (const Piece& piece : pieces) gathered.add(piece.cells, Point(piece.x, 0));
  std::vector<Block> result;
  gathered.drain([&](const TileBlock& block) {
    Block& read = result.emplace_back(Block{block.cells, {}});
    if (const auto* point = std::get_if<Point>(&block.shape)) {
      read.xs = {point->x};
    } else {
      for (const auto& part : std::get<Compound<2, double>>(block.shape).parts) read.xs.push_back(part.box.min.x);
    }
  });
  gathered.drain([](const TileBlock&) { ADD_FAILURE() << "what was drained is still there"; });
  return result;
}

TEST(TileBlocks, JoinWhatBeginsInOneBlockAndKeepTheOrder) {
  EXPECT_EQ(blocks_of({{{0, 1, 0, 1}, 3}, {{14, 18, 2, 3}, 1}, {{15, 16, 15, 20}, 2}}),
            (std::vector<Block>{{{0, 18, 0, 20}, {3, 1, 2}}}));
}

TEST(TileBlocks, ComeRowByRowAlsoLeftOfAndAboveCellZero) {
  EXPECT_EQ(
      blocks_of(
          {{{16, 17, 0, 1}, 1}, {{0, 1, 16, 17}, 2}, {{-1, 0, 0, 1}, 3}, {{-16, -15, 15, 16}, 4}, {{0, 1, -1, 0}, 5}}),
      (std::vector<Block>{
          {{0, 1, -1, 0}, {5}}, {{-16, 0, 0, 16}, {3, 4}}, {{16, 17, 0, 1}, {1}}, {{0, 1, 16, 17}, {2}}}));
}

TEST(TileBlocks, GiveUpThoseAboveARow) {
  TileBlocks blocks;
  std::vector<std::int64_t> tops;
  const auto note = [&tops](const TileBlock& block) { tops.push_back(block.cells.top); };
  for (const std::int64_t top : {-17, -1, 15, 16}) blocks.add({0, 1, top, top + 1}, Point(0, 0));
  blocks.drain_above(-17, note);
  EXPECT_TRUE(tops.empty());
  blocks.drain_above(15, note);
  EXPECT_EQ(tops, (std::vector<std::int64_t>{-17, -1}));
  blocks.add({0, 1, 14, 15}, Point(0, 0));
  blocks.drain(note);
  EXPECT_EQ(tops, (std::vector<std::int64_t>{-17, -1, 14, 16}));
}

TEST(TileBlocks, LeaveAPieceThatIsAloneAsItIs) {
  TileBlocks blocks;
  blocks.add({5, 6, 7, 8}, Point(1, 2));
  blocks.drain([](const TileBlock& block) { EXPECT_TRUE(std::holds_alternative<Point>(block.shape)); });
}

TEST(TileBlocks, HoldRectanglesOfTheirOwnSideAtMost) {
  EXPECT_TRUE(fits_tile_block({3, 19, 5, 21}));
  EXPECT_FALSE(fits_tile_block({3, 20, 5, 6}));
  EXPECT_FALSE(fits_tile_block({3, 4, 5, 22}));
}

}  // namespace
}  // namespace graze::io::tile_blocks_test
