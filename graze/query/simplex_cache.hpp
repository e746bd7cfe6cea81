// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <graze/math/vec.hpp>

namespace graze {

/// The corners between which two convex polytopes were nearest in the last query. `closest_points` and `distance` start
/// from them, and are faster the less the polytopes have moved. Keep one cache per pair and order of arguments. Its
/// contents, even of other shapes, affect only the time and, if there are several nearest points, which of them are
/// returned. Default: empty.
template <Dim N>
struct SimplexCache {
  std::array<std::uint32_t, static_cast<std::size_t>(N) + 1> corners_a{};  ///< Indices into `vertices()` of a.
  std::array<std::uint32_t, static_cast<std::size_t>(N) + 1> corners_b{};  ///< Indices into `vertices()` of b.
  std::uint32_t size = 0;  ///< The number of corners in use, the same for a and b.
};

namespace detail {

/// For the same pair in the other order.
template <Dim N>
void exchange(SimplexCache<N>& cache) {
  std::swap(cache.corners_a, cache.corners_b);
}

}  // namespace detail
}  // namespace graze
