// SPDX-License-Identifier: MIT
// mass_properties(shape) of the solids that are hulls of a few corners, beside rational numbers.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

/// The errors of one type in one space, in epsilon of double: of a box that is as large as the shape, or as far from
/// the origin.
struct MassTally {
  SpaceName space{};
  std::string shape;
  std::size_t cases = 0;
  std::size_t solid = 0;  ///< Those that have a volume.
  std::size_t wrong = 0;  ///< Farther off than documented.
  double volume = 0;
  double centroid = 0;  ///< Times the volume.
  double inertia = 0;
};

/// Boxes and polytopes, and in the plane triangles. The type by its place in AnyShape.
constexpr bool can_examine_mass(Dim dimension, std::size_t type) {
  constexpr std::size_t aabb = 4;
  constexpr std::size_t obb = 5;
  constexpr std::size_t triangle = 8;
  constexpr std::size_t polytope = 10;
  return type == aabb || type == obb || type == polytope || (type == triangle && dimension == 2);
}

/// Puts shapes of all kinds of cases, in turn, to graze and to rational numbers.
template <Dim N, class T>
MassTally examine_mass(std::size_t type, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
