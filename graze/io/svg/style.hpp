// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <graze/math/vec.hpp>

namespace graze::io::svg {

/// How much a picture of so many objects shows of each, so that few are rich and many still make a file that opens.
struct Detail {
  double stroke = 1.3;     ///< Width of a line, in pixels.
  double mark_size = 4.5;  ///< Arm of the cross that stands for a point, in pixels.
  bool labels = true;      ///< Names written into the picture, as many as fit.
  bool titles = true;      ///< Name, type and partners of each object, shown under the mouse.
  bool patterns = true;    ///< Lines over what overlaps, dots over what touches; else plain colour and width.
  bool faces = true;       ///< In 3D boxes with their faces; else their silhouettes.
};

Detail detail_for(std::size_t objects);

/// What `detail` leaves out, as a sentence for a comment in the file; empty when nothing is.
std::string omission(const Detail& detail, std::size_t objects);

/// The shades of a face in 3D: "l0" (turned away from the light) to "l5" (facing it).
inline constexpr int shades = 6;

/// The style sheet, and the patterns and gradients that it refers to. Elements that show objects lie in a group of the
/// class "shapes", those of objects in pairs within it in a group of the class that `class_of` gives.
std::string style_sheet(const Detail& detail, Dim dimension);

}  // namespace graze::io::svg
