// SPDX-License-Identifier: MIT
// convex_hull(points), and what the rivals say: which points are corners, on sets of points of one kind in one space.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string_view>

#include <graze/math/vec.hpp>

#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

/// What the points of a set have to do with each other.
enum class HullKind {
  uniform,          ///< -10 to 10.
  lattice,          ///< Whole numbers from 0 to 3: many points on faces and edges, some of them twice.
  nearly_coplanar,  ///< Of a lattice on one or two planes in any direction, up to the rounding of the coordinates.
  sphere,           ///< Around the origin at one distance, up to rounding: all are corners.
  far,              ///< A lattice of steps of 0.1, up to rounding, a million units from the origin.
  cube,             ///< A cube and points of its faces, all moved by up to three ulp.
};
inline constexpr std::size_t hull_kind_count = 6;
inline constexpr std::array<std::string_view, hull_kind_count> hull_kind_names = {
    "uniform", "lattice", "nearly coplanar", "sphere", "far", "cube"};

/// The answers of one program to the same sets.
struct CornerTally {
  std::size_t sets = 0;
  std::size_t given_up = 0;  ///< Sets without an answer; the others count below.
  std::size_t missing = 0;   ///< Corners that it does not name.
  std::size_t extra = 0;     ///< Points that it names though they lie in the hull of the others.
  double worst = 0;          ///< How far a corner is outside of the hull of what it names, as a share of the size.

  CornerTally& operator+=(const CornerTally& other);
};

/// The sets of one kind in one space.
struct HullTally {
  SpaceName space{};
  HullKind kind{};
  std::size_t points = 0;
  std::size_t corners = 0;
  std::map<std::string_view, CornerTally> programs;  ///< By name, graze among them.
};

/// Puts sets of up to twenty points to graze, to whole numbers and to the rivals.
template <Dim N, class T>
HullTally examine_hulls(HullKind kind, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
