// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>

namespace graze::io::svg {

/// The objects of a 3D scene as SVG, one element each, from back to front. Boxes and triangles are shaded by the angle
/// between face and light, spheres and other bodies by a gradient; planes and half-spaces are translucent sheets, with
/// a grid if they are perpendicular to an axis.
std::string paint_solid(const Subject<3>& subject, const Stage<3>& stage, const Detail& detail);

}  // namespace graze::io::svg
