// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <graze/shape/aabb.hpp>

namespace graze::io::svg {

/// A name, and the box of its object in pixels. A box without a name is only an obstacle.
struct Label {
  std::string text;
  Aabb<2, double> box;
  bool in_pair = false;  ///< These are named first.
};

/// The names as SVG elements, each inside or beside its box; left out if the edge of the card, other boxes or other
/// names leave no room. Objects in pairs come first, and larger before smaller ones. At most the first thousand names
/// are tried.
std::string placed_labels(std::span<const Label> labels, const Aabb<2, double>& card);

/// The approximate width of a text in pixels; an upper estimate, because the viewer chooses the font.
double text_width(const std::string& text, double font_size);

}  // namespace graze::io::svg
