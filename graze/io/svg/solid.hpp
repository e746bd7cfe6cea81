// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>

namespace graze::io::svg {

/// The objects of a 3D scene as SVG, one element each, those in front painted over those behind. Boxes and triangles
/// are shaded by how their faces turn to the light, spheres and other bodies by a gradient; planes and half-spaces are
/// translucent sheets, with a grid where they are perpendicular to an axis.
std::string paint_solid(const Subject<3>& subject, const Stage<3>& stage, const Detail& detail);

}  // namespace graze::io::svg
