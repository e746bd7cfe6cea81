// SPDX-License-Identifier: MIT
// All overlapping pairs of many boxes at once.
#pragma once

#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// How pairs are found. The answer never depends on it.
enum class PairMethod {
  automatic,    ///< By the number of boxes.
  brute_force,  ///< Every box against every other: the oracle of the rest, and the best for a few dozen.
  tree,         ///< A balanced tree of boxes, built anew and then met with itself.
};

struct PairOptions {
  PairMethod method = PairMethod::automatic;
};

/// Every pair of boxes that share a point (touching counts), once, with a < b, in ascending order. Comparisons are
/// exact. Infinite boxes are welcome, boxes that contain nothing (min above max) overlap none. Throws
/// std::invalid_argument when a coordinate is NaN, std::length_error beyond 2^32 - 1 boxes. Instantiated for 2D and 3D,
/// float and double.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options = {});

/// Every pair of a box of one set (index a) and a box of another (index b) that share a point, in ascending order.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                    const PairOptions& options = {});

/// The same for a vector, whose type deduces where a span's does not.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes, const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes), options);
}

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes_a, const std::vector<Aabb<N, T>>& boxes_b,
                                    const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes_a), std::span<const Aabb<N, T>>(boxes_b), options);
}

}  // namespace graze
