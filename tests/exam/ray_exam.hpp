// SPDX-License-Identifier: MIT
// ray_cast(shape, ray), and what the rivals say, on one type of shapes in one space. Compiled once for each space, in
// ray_exam_*.cpp.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>

#include "exam/measure.hpp"
#include "exam/settings.hpp"

namespace graze::exam {

/// Puts cases of all kinds, in turn, to graze, to the oracle and, in 3D, to the rivals. The type by its place in
/// AnyShape.
template <Dim N, class T>
MeasuredPair examine_rays(std::size_t type, const Settings& settings, RegressionLog& regressions);

}  // namespace graze::exam
