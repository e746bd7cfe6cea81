// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>

#include <graze/io/tiled/projection.hpp>

namespace graze::io {
namespace {

using Point = Vec<2, double>;

/// Tiled halves lengths in integer arithmetic.
double half(double length) { return std::trunc(length / 2); }

}  // namespace

TiledProjection::TiledProjection(const TiledGrid& grid)
    : grid_(grid),
      is_staggered_(grid.orientation == "staggered" || grid.orientation == "hexagonal"),
      is_hexagonal_(grid.orientation == "hexagonal"),
      is_identity_(grid.orientation != "isometric" && grid.orientation != "oblique"),
      cell_size_(grid.tile_width, grid.tile_height),
      pixels_per_cell_(cell_size_) {
  if (grid.orientation == "isometric") {
    // A cell is tile_height pixels wide and high; its x axis points down to the right, its y axis down to the left.
    const double across = grid.tile_width / (2 * grid.tile_height);  // requires a height above 0
    linear_ = Mat<2, double>(Point(across, 0.5), Point(-across, 0.5));
    origin_ = Point(half(grid.height * grid.tile_width), 0.0);
    pixels_per_cell_ = Point(grid.tile_height);
  } else if (grid.orientation == "oblique" && grid.tile_width > 0 && grid.tile_height > 0) {
    linear_ = Mat<2, double>(Point(1.0, grid.skew_y / grid.tile_width), Point(grid.skew_x / grid.tile_height, 1.0));
  }
}

Point TiledProjection::corner_of_cell(std::int64_t x, std::int64_t y) const {
  if (is_staggered_) return corner_of_staggered_cell(x, y);
  if (grid_.orientation == "isometric") {
    // `place` returns the top corner of the cell's diamond.
    return place(pixel_of_cell(x, y)) + Point(-grid_.tile_width / 2, grid_.tile_height);
  }
  return place(pixel_of_cell(x, y + 1));
}

/// Rows or columns overlap their neighbours by the slanted part of a cell, and every second one is shifted by half a
/// cell. Staggered maps are hexagonal ones with sides of zero length.
Point TiledProjection::corner_of_staggered_cell(std::int64_t x, std::int64_t y) const {
  const Point side =
      is_hexagonal_ ? (grid_.staggers_x ? Point(grid_.hex_side, 0.0) : Point(0.0, grid_.hex_side)) : Point(0.0, 0.0);
  const Point cell(2 * half(grid_.tile_width), 2 * half(grid_.tile_height));
  const Point slant(half(cell.x - side.x), half(cell.y - side.y));
  const Point step = slant + side;  // from one row or column to the next
  const std::int64_t line = grid_.staggers_x ? x : y;
  const bool is_shifted = (line % 2 != 0) != grid_.shifts_even;
  const Point at(static_cast<double>(x), static_cast<double>(y));
  const Point corner = grid_.staggers_x ? Point(at.x * step.x, at.y * cell.y + (is_shifted ? step.y : 0.0))
                                        : Point(at.x * cell.x + (is_shifted ? step.x : 0.0), at.y * step.y);
  return corner + Point(0.0, cell.y);
}

}  // namespace graze::io
