// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/scene_file.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// Draws a scene: every shape, those of the `reported` pairs in other colours and patterns, one for what
/// overlaps and one for what only touches, with a mark where they meet, and a legend, which also says what of the file
/// was not read. 2D as it is, with y as the file has it; 3D seen isometrically. Unbounded shapes are cut off at the
/// edge of the picture; what lies beyond 1e100 is counted, not drawn. Of thousands of objects less is shown of each, so
/// that 100,000 make about 10 MB. Nothing is written before the picture is complete. Throws std::invalid_argument when
/// a pair names no object of the scene.
void write_svg(std::ostream& out, const SceneFile& file, std::span<const ObjectPair> reported);

}  // namespace graze::io
