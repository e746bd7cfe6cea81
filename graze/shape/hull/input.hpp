// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <graze/math/platform/throw.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Throws std::invalid_argument, naming `function`, if there are no points or a coordinate is not finite;
/// std::length_error if there are more than 2^32 - 1 points in 3D, where indices have 32 bits.
template <Dim N, class T>
void check_hull_points(std::string_view function, std::span<const Vec<N, T>> points) {
  const auto error = [function](std::string_view fact) { return std::string(function) + ": " + std::string(fact); };
  if (points.empty()) GRAZE_THROW(std::invalid_argument(error("there are no points")));
  for (const Vec<N, T>& point : points) {
    if (!is_finite(point)) GRAZE_THROW(std::invalid_argument(error("a point has a coordinate that is not finite")));
  }
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (N == 3 && points.size() > most) GRAZE_THROW(std::length_error(error("there are more than 2^32 - 1 points")));
}

}  // namespace graze::detail
