// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <graze/math/vec.hpp>

namespace graze::io::svg {

/// The level of detail for a number of objects: few objects are drawn in full detail, many still make a file that
/// opens.
struct Detail {
  double stroke = 1.3;     ///< Width of a line, in pixels.
  double mark_size = 4.5;  ///< Arm length of the cross that represents a point, in pixels.
  bool labels = true;      ///< Names in the picture, as many as fit.
  bool titles = true;      ///< Tooltips with name, type and partners of each object.
  bool patterns =
      true;           ///< Hatching on overlapping and dots on touching objects; otherwise plain colour and line width.
  bool faces = true;  ///< Faces of 3D boxes; otherwise their silhouettes.
};

Detail detail_for(std::size_t objects);

/// What `detail` omits, as a sentence for a comment in the file; empty if nothing is.
std::string omission(const Detail& detail, std::size_t objects);

/// The shades of a face in 3D: "l0" (turned away from the light) to "l5" (facing it).
inline constexpr int shades = 6;

/// The style sheet with its patterns and gradients. Elements that show objects lie in a group of class "shapes", and
/// within it those of objects in pairs in a group of the class that `class_of` returns.
std::string style_sheet(const Detail& detail, Dim dimension);

}  // namespace graze::io::svg
