// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/outline.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/plane.hpp>

namespace graze::io::svg {

/// Something to paint: a body in a box, or a sheet, which is a piece of a plane bounded by the box.
struct Layered {
  Aabb<3, double> box;
  std::optional<Plane<3, double>> sheet;
};

/// The painting order (Newell, Newell and Sancha 1972, for boxes): of two items that overlap on screen, the one behind
/// comes first, decided along the axis on which their boxes are farthest apart; a sheet comes before everything on the
/// viewer's side of it. Cycles are broken at their farthest item. Beyond tens of millions of comparisons, items are
/// sorted by the depth of their centers alone.
std::vector<std::size_t> back_to_front(std::span<const Layered> things, const View<3>& view);

}  // namespace graze::io::svg
