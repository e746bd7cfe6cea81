// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <graze/shape/aabb.hpp>

namespace graze::io::svg {

/// A name, and the box of the thing it belongs to, in pixels. Without a name the box is but in the way.
struct Label {
  std::string text;
  Aabb<2, double> box;
  bool in_pair = false;  ///< Named before those that are in no pair.
};

/// The names as SVG elements, each inside its box or beside it; those that fit in neither place, because the card ends
/// or other boxes or names are in the way, are left out. Things in pairs come first, of these and of the others the
/// largest. Of thousands of names the first thousand are tried.
std::string placed_labels(std::span<const Label> labels, const Aabb<2, double>& card);

/// About how wide a text is in the picture, in pixels; generous, for the font is the viewer's choice.
double text_width(const std::string& text, double font_size);

}  // namespace graze::io::svg
