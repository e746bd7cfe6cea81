// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/bvh/build_kernels.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Centers that are to be parted, and as much room beside them.
template <Dim N, class T>
struct BvhCenters {
  CenterLists<N, T> here;
  CenterLists<N, T> beside;
  std::size_t count;

  BvhCenters first(std::size_t some) const { return {here, beside, some}; }
  BvhCenters behind(std::size_t some) const { return {here.behind(some), beside.behind(some), count - some}; }
};

/// What of centers is still wanted after they are parted.
enum class BvhWanted : std::uint8_t { all, slots };

/// Copies centers, or their slots, into the room beside, the `lower` first ones along an axis before the others; of
/// equal ones those of the lower slots are first. Returns where along the axis the first of the others is, which there
/// are some of. What is in a part depends on nothing but the centers. They are finite, and slots differ. O(count)
/// steps, O(count log count) where that fails.
template <Dim N, class T>
T part_centers(const BvhCenters<N, T>& centers, std::size_t lower, Dim axis, BvhWanted wanted = BvhWanted::all);

}  // namespace graze::detail
