// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>

namespace graze::io::svg {

/// The objects of a 2D scene as SVG, one element each, in painting order: unbounded shapes first, then from large to
/// small, so that nothing is hidden.
std::string paint_flat(const Subject<2>& subject, const Stage<2>& stage, const Detail& detail);

}  // namespace graze::io::svg
