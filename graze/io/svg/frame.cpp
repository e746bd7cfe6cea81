// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <graze/io/svg/frame.hpp>
#include <graze/math/tolerance.hpp>

namespace graze::io::svg {
namespace {

constexpr double least_card_height = 320;
constexpr double greatest_card_height = 900;

/// Smaller extents are enlarged to this, so that no scale overflows.
constexpr double least_extent = 1e-100;

/// Extents below this, relative to the coordinates, are rounding errors.
constexpr double least_relative_extent = 64 * tolerance::epsilon;

Vec<2, double> extent_of(const Aabb<2, double>& content) {
  const Vec<2, double> extent = content.max - content.min;
  if (!(max_abs(extent) > 0)) return {4, 1};
  const double size = std::max(max_abs(content.min), max_abs(content.max));
  const double least = std::max(least_extent, size * least_relative_extent);
  return {std::max(extent.x, least), std::max(extent.y, least)};
}

}  // namespace

Frame frame_around(const Aabb<2, double>& content) {
  Frame frame;
  const Vec<2, double> extent = extent_of(content);
  frame.center = content.center();
  const double card_width = picture_width - 2 * side_margin;
  const double room = card_width - 2 * card_padding;
  const double wanted = extent.y / extent.x * room + 2 * card_padding;
  const double card_height = std::round(std::clamp(wanted, least_card_height, greatest_card_height));
  frame.scale = std::min(room / extent.x, (card_height - 2 * card_padding) / extent.y);
  frame.card = {{side_margin, header_height}, {side_margin + card_width, header_height + card_height}};
  frame.height = header_height + card_height + footer_height;
  return frame;
}

Vec<2, double> to_picture(const Frame& frame, const Vec<2, double>& point) {
  const Vec<2, double> middle = frame.card.center();
  const Vec<2, double> offset = (point - frame.center) * frame.scale;
  return {std::clamp(middle.x + offset.x, frame.card.min.x, frame.card.max.x),
          std::clamp(middle.y - offset.y, frame.card.min.y, frame.card.max.y)};
}

Aabb<2, double> visible(const Frame& frame) {
  return Aabb<2, double>::from_center(frame.center, frame.card.half_extents() / frame.scale);
}

Aabb<2, double> box_around(const Outline& outline) {
  Aabb<2, double> box = Aabb<2, double>::nothing();
  for (const Vec<2, double>& corner : outline.core) box.grow(corner);
  return {box.min - outline.radius, box.max + outline.radius};
}

Aabb<2, double> picture_box(const Frame& frame, const Outline& outline) {
  const Aabb<2, double> box = box_around(outline);
  return Aabb<2, double>::from_corners(to_picture(frame, box.min), to_picture(frame, box.max));
}

double round_length(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {10.0, 5.0, 2.0, 1.0}) {  // 10: log10 may have been rounded down to the integer below
    if (power * factor <= limit) return power * factor;
  }
  return power * 0.5;  // log10 was rounded up: the limit is slightly below the power
}

}  // namespace graze::io::svg
