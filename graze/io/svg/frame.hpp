// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/outline.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::io::svg {

/// The picture's fixed measures, in pixels.
inline constexpr double picture_width = 1200;
inline constexpr double side_margin = 20;
inline constexpr double header_height = 68;
inline constexpr double footer_height = 64;
/// Kept free between the things drawn and the edge of the card they are drawn on.
inline constexpr double card_padding = 40;

/// How the flat coordinates of a view (y up) become those of the picture (pixels, y down): `center` lies in the middle
/// of the card, the part of the picture that shows the scene.
struct Frame {
  Vec<2, double> center = Vec<2, double>(0.0);
  double scale = 1;  ///< pixels per unit
  Aabb<2, double> card;
  double height = 0;  ///< of the whole picture
};

/// The frame that shows `content` as large as it goes. Flat and empty content is valid: a width and height of zero show
/// two units around the point.
Frame frame_around(const Aabb<2, double>& content);

/// Where a point of the view lies in the picture, clamped to the card: what is drawn at a finite place stays in the
/// picture.
Vec<2, double> to_picture(const Frame& frame, const Vec<2, double>& point);

/// The part of the view that the card shows.
Aabb<2, double> visible(const Frame& frame);

/// The box around an outline, up to rounding; `Aabb::nothing()` around an empty one.
Aabb<2, double> box_around(const Outline& outline);

/// The same for an outline that is not empty, in pixels.
Aabb<2, double> picture_box(const Frame& frame, const Outline& outline);

/// The largest 1, 2 or 5 times a power of ten that is not above `limit`, which is positive.
double round_length(double limit);

}  // namespace graze::io::svg
