// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// How many boxes a block holds: the lanes of the widest vector of floats. Fixed, so that answers come in the same
/// order whatever the width of the machine's vectors.
inline constexpr std::uint32_t block_size = 16;

/// Sixteen boxes side by side, coordinate by coordinate. A lane without a box is NaN, which no comparison lets through.
template <Dim N, class T>
struct alignas(64) Block {
  T min[N][block_size];
  T max[N][block_size];
};

/// Stands for the box of a lane without one.
inline constexpr std::uint32_t no_box = 0xFFFF'FFFF;

/// How many pairs of blocks are compared in one go.
inline constexpr std::uint32_t block_pairs_at_once = 32;

/// Two blocks of one level whose boxes are to be compared. Of one tree with itself a <= b, and a == b means every two
/// boxes of the block.
struct BlockPair {
  std::uint32_t a;
  std::uint32_t b;
};

}  // namespace graze::detail
