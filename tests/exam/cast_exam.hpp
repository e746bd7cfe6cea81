// SPDX-License-Identifier: MIT
// shape_cast(a, motion, b), and what the rivals say, on one pair of types in one space. Compiled once for each space,
// in cast_exam_*.cpp.
#pragma once

#include <array>
#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exam/measure.hpp"
#include "exam/settings.hpp"

namespace graze::exam {

/// Whether the oracle can tell when shapes of these types meet: convex ones that are bounded, one of which may be a
/// plane or a half-space. The types by their places in AnyShape.
constexpr bool can_examine_casts(std::size_t a, std::size_t b) {
  constexpr std::array<bool, shape_type_names.size()> is_solid = {true,  true,  false, true, true, true,
                                                                  false, false, true,  true, true, false};
  constexpr std::size_t plane = 6;
  constexpr std::size_t half_space = 7;
  return is_solid[a] && (b == plane || b == half_space || (is_solid[b] && a <= b));
}

/// Puts cases of all kinds, in turn, to graze, to the oracle and, in 3D, to the rivals.
template <Dim N, class T>
MeasuredPair examine_casts(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
