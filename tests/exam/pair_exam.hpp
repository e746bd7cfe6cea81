// SPDX-License-Identifier: MIT
// graze's verdicts, and its rivals', on one pair of types in one space. Compiled once for each space, in exam_*.cpp.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>

#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

/// Puts cases of all kinds, in turn, to graze in both orders, to the judges and, in 3D, to the rivals. The types by
/// their places in AnyShape.
template <Dim N, class T>
PairTally examine_pair(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions);

/// Puts shapes of one type and points to contains, closest_point, closest_boundary_point and signed_distance.
template <Dim N, class T>
PointTally examine_points(std::size_t type, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
