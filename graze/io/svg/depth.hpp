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

/// Something to be painted: a body in a box, or a sheet, a piece of a plane that the box surrounds.
struct Layered {
  Aabb<3, double> box;
  std::optional<Plane<3, double>> sheet;
};

/// The order in which to paint (Newell, Newell and Sancha 1972, for boxes): of two things seen one over the other, the
/// one behind comes first, decided by the axis along which their boxes are farthest apart; a sheet comes before what
/// lies on the viewer's side of it. Circles of things each partly behind the next are broken at the farthest. Beyond
/// tens of millions of comparisons everything goes by the depth of its middle alone.
std::vector<std::size_t> back_to_front(std::span<const Layered> things, const View<3>& view);

}  // namespace graze::io::svg
