// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/scene_file.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// Draws a scene as SVG: every shape, those of the `reported` pairs in other colours and patterns (one for overlapping,
/// one for touching) with a mark where they meet, and a legend, which also lists what was not read from the file. 2D as
/// it is, with y as in the file; 3D in isometric projection. Unbounded shapes are cut off at the edge of the picture;
/// what lies beyond 1e100 is counted, not drawn. With thousands of objects each is drawn with less detail, so that
/// 100,000 make about 10 MB. Nothing is written before the picture is complete. Throws std::invalid_argument if a pair
/// names no object of the scene.
void write_svg(std::ostream& out, const SceneFile& file, std::span<const ObjectPair> reported);

}  // namespace graze::io
