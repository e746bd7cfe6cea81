// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// The number of boxes in a block: the lanes of the widest vector of floats. Fixed, so that the order of answers does
/// not depend on the width of the machine's vectors.
inline constexpr std::uint32_t block_size = 16;

/// Sixteen boxes as a structure of arrays. Unused lanes are NaN, which fails every comparison.
template <Dim N, class T>
struct alignas(64) Block {
  T min[N][block_size];
  T max[N][block_size];
};

/// The id of a lane without a box.
inline constexpr std::uint32_t no_box = 0xFFFF'FFFF;

/// The number of pairs of blocks that are compared in one batch.
inline constexpr std::uint32_t block_pairs_at_once = 32;

/// Two blocks of one level whose boxes are to be compared. For a tree paired with itself, a <= b, and a == b means all
/// pairs within the block.
struct BlockPair {
  std::uint32_t a;
  std::uint32_t b;
};

}  // namespace graze::detail
