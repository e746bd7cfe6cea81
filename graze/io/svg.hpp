// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/scene_file.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// Draws a scene as SVG: every shape, and a legend that also lists what was not read from the file. The shapes of the
/// `reported` pairs have other colours and patterns, one for overlapping and one for touching, and a mark where they
/// meet. 2D scenes keep the y direction of their file; 3D scenes are drawn in isometric projection. Unbounded shapes
/// are cut off at the edge of the picture; shapes beyond 1e100 are counted, not drawn. Thousands of objects are drawn
/// with less detail, so that 100,000 take about 10 MB. Writes nothing before the picture is complete. Throws
/// std::invalid_argument if a pair names no object of the scene.
GRAZE_EXPORT void write_svg(std::ostream& out, const SceneFile& file, std::span<const ObjectPair> reported);

}  // namespace graze::io
