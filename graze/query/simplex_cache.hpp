// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <graze/math/vec.hpp>

namespace graze {

/// Between which corners two convex polytopes were nearest when they were last asked about: `closest_points` and
/// `distance` begin there if they are given it again, and are the faster the less the two have moved since. It is for
/// one pair, in one order of arguments; whatever it holds, also of other shapes, changes no more than the time and, of
/// several nearest points, which of them are found. Default: nothing is known.
template <Dim N>
struct SimplexCache {
  std::array<std::uint32_t, static_cast<std::size_t>(N) + 1> corners_a{};  ///< Places in `vertices()`.
  std::array<std::uint32_t, static_cast<std::size_t>(N) + 1> corners_b{};
  std::uint32_t size = 0;  ///< So many of each.
};

namespace detail {

/// For the same pair in the other order.
template <Dim N>
void exchange(SimplexCache<N>& cache) {
  std::swap(cache.corners_a, cache.corners_b);
}

}  // namespace detail
}  // namespace graze
