// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <graze/math/vec.hpp>

namespace graze::io {

/// The cells of a map, as far as they determine drawing positions. Sizes are in pixels.
struct TiledGrid {
  std::string orientation = "orthogonal";  ///< Also isometric, staggered, hexagonal, oblique.
  double height = 0;                       ///< In cells.
  double tile_width = 0;
  double tile_height = 0;
  double hex_side = 0;       ///< Hexagonal maps: the length of the sides along the staggered axis.
  double skew_x = 0;         ///< Oblique maps: how far a cell leans to the right from its top to its bottom.
  double skew_y = 0;         ///< ... and down from its left to its right.
  bool staggers_x = false;   ///< Columns are shifted instead of rows.
  bool shifts_even = false;  ///< The even ones are shifted instead of the odd ones.
};

/// The positions at which Tiled draws: maps object coordinates ("pixels") and cell numbers to screen pixels, with y
/// down and the origin at the top left corner of the map's rectangle. On orthogonal, staggered and hexagonal maps
/// object coordinates are screen pixels; isometric and oblique maps transform them linearly. Sizes must satisfy
/// `require_sound`.
class TiledProjection {
 public:
  explicit TiledProjection(const TiledGrid& grid);

  /// The screen position of a point in object coordinates.
  Vec<2, double> place(const Vec<2, double>& pixel) const { return linear_ * pixel + origin_; }

  /// The linear part of `place`, for differences.
  const Mat<2, double>& linear() const { return linear_; }

  /// True when `place` is the identity.
  bool is_identity() const { return is_identity_; }

  /// The bottom left corner of the rectangle in which a cell's tile is drawn. Tiles larger than a cell extend up and to
  /// the right from there.
  Vec<2, double> corner_of_cell(std::int64_t x, std::int64_t y) const;

  Vec<2, double> cell_size() const { return cell_size_; }

  /// True if adjacent cells form a rectangle of pixels, as on orthogonal and isometric maps.
  bool has_rows() const { return !is_staggered_; }

  /// The top left corner of a cell in pixels, on maps with rows.
  Vec<2, double> pixel_of_cell(std::int64_t x, std::int64_t y) const {
    return Vec<2, double>(static_cast<double>(x), static_cast<double>(y)) * pixels_per_cell_;
  }

  /// True if tiles rotate in steps of 60 degrees.
  bool is_hexagonal() const { return is_hexagonal_; }

 private:
  Vec<2, double> corner_of_staggered_cell(std::int64_t x, std::int64_t y) const;

  TiledGrid grid_;
  bool is_staggered_;  ///< Also hexagonal.
  bool is_hexagonal_;
  bool is_identity_;
  Mat<2, double> linear_ = Mat<2, double>(1.0);
  Vec<2, double> origin_ = {0.0, 0.0};
  Vec<2, double> cell_size_;
  Vec<2, double> pixels_per_cell_;
};

}  // namespace graze::io
