// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/bvh/build_kernels.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Centers to partition, and space for a copy.
template <Dim N, class T>
struct BvhCenters {
  CenterLists<N, T> here;
  CenterLists<N, T> beside;
  std::size_t count;

  BvhCenters first(std::size_t some) const { return {here, beside, some}; }
  BvhCenters behind(std::size_t some) const { return {here.behind(some), beside.behind(some), count - some}; }
};

/// What is still needed after the partition.
enum class BvhWanted : std::uint8_t { all, slots };

/// Copies centers, or only their slots, to `beside`, the `lower` first ones along an axis before the others; ties go by
/// slot. Returns the smallest coordinate of the upper part, which must not be empty. The parts depend on the centers
/// alone. Centers must be finite and slots distinct. O(count) expected, O(count log count) in the worst case.
template <Dim N, class T>
T part_centers(const BvhCenters<N, T>& centers, std::size_t lower, Dim axis, BvhWanted wanted = BvhWanted::all);

}  // namespace graze::detail
