// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <graze/io/tiled/shapes.hpp>
#include <graze/io/tiled/tile_shapes.hpp>
#include <graze/math/rotation.hpp>

namespace graze::io {
namespace {

using Point = Vec<2, double>;
using Shape = AnyShape<2, double>;

// The upper bits of a gid. The third reflects at the diagonal from the top left; on hexagonal maps it rotates by 60
// degrees, and the fourth by 120.
constexpr std::uint32_t mirror_x_bit = 0x80000000U;
constexpr std::uint32_t mirror_y_bit = 0x40000000U;
constexpr std::uint32_t diagonal_bit = 0x20000000U;
constexpr std::uint32_t turn_120_bit = 0x10000000U;

/// The transformation of a tile's image in its cell: scaled (negative for a reflection), then rotated.
struct Lay {
  double degrees = 0;
  Point scale = {1.0, 1.0};
};

Lay lay_of(std::uint32_t gid, const Point& scale, const TiledProjection& projection) {
  double degrees = 0;
  bool mirrors_x = (gid & mirror_x_bit) != 0;
  bool mirrors_y = (gid & mirror_y_bit) != 0;
  if (projection.is_hexagonal()) {
    if ((gid & diagonal_bit) != 0) degrees += 60;
    if ((gid & turn_120_bit) != 0) degrees += 120;
  } else if ((gid & diagonal_bit) != 0) {
    // Reflection at the diagonal is a quarter turn after a vertical flip.
    degrees = 90;
    mirrors_x = std::exchange(mirrors_y, !mirrors_x);
  }
  return {degrees, {mirrors_x ? -scale.x : scale.x, mirrors_y ? -scale.y : scale.y}};
}

/// From the pixels of a tile's image, y down from its top, to a cell whose bottom left corner is the origin.
TiledFrame picture_frame(const TiledTileUse& tile, const Point& picture, std::uint32_t gid,
                         const TiledProjection& projection) {
  const TiledTileset& tileset = *tile.tileset;
  const Point size = tileset.fills_grid ? projection.cell_size() : picture;
  Point scale = size / picture;
  if (tileset.keeps_aspect) scale = Point(std::min(scale.x, scale.y));
  const Lay lay = lay_of(gid, scale, projection);
  // Tiles rotate about the center of their rectangle. After a quarter turn, the same corner is kept in place.
  Point middle = Point(size.x / 2, -size.y / 2) + tileset.drawing_offset * scale;
  if (lay.degrees == 90) middle += (size.y - size.x) / 2;
  const Mat<2, double> turn = rotation_matrix(lay.degrees);
  TiledFrame frame{Mat<2, double>(turn[0] * lay.scale.x, turn[1] * lay.scale.y), Point(0.0), std::nullopt};
  frame.origin = middle - frame.linear * (picture / 2.0);
  if (scale.x == scale.y) frame.scale = scale.x;
  return frame;
}

/// True if the shape is a box or polygon with exactly these corners.
bool has_corners(const Shape& shape, const std::array<Point, 4>& corners) {
  std::vector<Point> own;
  if (const auto* box = std::get_if<Aabb<2, double>>(&shape)) {
    own = {box->min, {box->max.x, box->min.y}, box->max, {box->min.x, box->max.y}};
  } else if (const auto* polygon = std::get_if<Polytope<2, double>>(&shape)) {
    own.assign(polygon->vertices().begin(), polygon->vertices().end());
  }
  return own.size() == corners.size() && std::is_permutation(own.begin(), own.end(), corners.begin());
}

}  // namespace

TiledTileShapes tiled_tile_shapes(const TiledTileUse& tile, std::uint32_t gid, const TiledProjection& projection) {
  TiledTileShapes result;
  if (tile.tile == nullptr || tile.tile->shapes.empty()) return result;
  const Point picture = tiled_picture_size(tile);
  if (!(picture.x > 0 && picture.y > 0)) {
    result.omissions.assign(tile.tile->shapes.size(), tiled_omission::tile_without_size);
    return result;
  }
  // Collision shapes are drawn on their own grid, which is at the bottom of the image if it is isometric.
  TiledFrame frame = picture_frame(tile, picture, gid, projection);
  const TiledGrid& grid = tile.tileset->grid;
  const TiledProjection drawn_on(grid);
  if (!drawn_on.is_identity()) frame.origin += frame.linear * Point(0.0, picture.y - grid.tile_height);
  for (const TiledObject& object : tile.tile->shapes) {
    TiledShape read = tiled_shape(object, drawn_on, frame);
    if (!read.omission.what.empty()) result.omissions.push_back(read.omission);
    if (read.shape) result.shapes.push_back(*std::move(read.shape));
  }
  if (projection.has_rows() && result.shapes.size() == 1 && result.omissions.empty()) {
    std::array<Point, 4> cell = tiled_corners_of_cells(projection, {0, 0}, {1, 1});
    for (Point& corner : cell) corner -= projection.corner_of_cell(0, 0);
    result.fills_cell = has_corners(result.shapes.front(), cell);
  }
  return result;
}

std::array<Point, 4> tiled_corners_of_cells(const TiledProjection& projection, const Vec<2, std::int64_t>& begin,
                                            const Vec<2, std::int64_t>& end) {
  const auto corner = [&](std::int64_t x, std::int64_t y) { return projection.place(projection.pixel_of_cell(x, y)); };
  return {corner(begin.x, begin.y), corner(end.x, begin.y), corner(end.x, end.y), corner(begin.x, end.y)};
}

}  // namespace graze::io
