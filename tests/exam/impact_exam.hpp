// SPDX-License-Identifier: MIT
// time_of_impact(a, motion_a, b, motion_b), and what the rivals say, on one pair of types in one space. Compiled once
// for each space, in impact_exam_*.cpp.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>

#include "exam/measure.hpp"
#include "exam/settings.hpp"

namespace graze::exam {

/// Puts cases of all kinds, in turn, to graze, to the oracle and, in 3D, to the rivals.
template <Dim N, class T>
MeasuredPair examine_impacts(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
