// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/outline.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::io::svg {

/// Fixed measures of the picture, in pixels.
inline constexpr double picture_width = 1200;
inline constexpr double side_margin = 20;
inline constexpr double header_height = 68;
inline constexpr double footer_height = 64;
/// Margin between the content and the edge of the card.
inline constexpr double card_padding = 40;

/// Maps the 2D coordinates of a view (y up) to those of the picture (pixels, y down): `center` lies in the middle of
/// the card, the part of the picture that shows the scene.
struct Frame {
  Vec<2, double> center = Vec<2, double>(0.0);
  double scale = 1;  ///< pixels per unit
  Aabb<2, double> card;
  double height = 0;  ///< of the whole picture
};

/// The frame that shows `content` as large as possible. Content of zero width or height is valid: if both are zero, the
/// frame shows two units around the point.
Frame frame_around(const Aabb<2, double>& content);

/// The position of a view point in the picture, clamped to the card, so that everything finite stays in the picture.
Vec<2, double> to_picture(const Frame& frame, const Vec<2, double>& point);

/// The part of the view that the card shows.
Aabb<2, double> visible(const Frame& frame);

/// The box around an outline, up to rounding; `Aabb::nothing()` for an empty outline.
Aabb<2, double> box_around(const Outline& outline);

/// The same for a nonempty outline, in pixels.
Aabb<2, double> picture_box(const Frame& frame, const Outline& outline);

/// The largest 1, 2 or 5 times a power of ten that is at most `limit`, which is positive.
double round_length(double limit);

}  // namespace graze::io::svg
