// SPDX-License-Identifier: MIT
// The loop that finds out how deep the boxes of pairs are in each other, once for every set of vector instructions that
// the compiler knows, as in block_kernels.hpp.
#pragma once

#include <cstddef>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N>
struct DepthKernels {
  /// Marks each pair by 1 if its box_depth is above `certain`, else by 0. Of the others lists those that are not below
  /// its negative, by their places, and returns how many. The row of boxes is longer by one than the last that is
  /// named; `boxes_in_row` says only how far apart they lie in memory.
  std::size_t (*judge)(const Aabb<N, float>* boxes, std::size_t boxes_in_row, const Pair* pairs, std::size_t count,
                       float certain, char* touches, std::size_t* open);
};

/// The kernels of one instruction set.
struct AllDepthKernels {
  DepthKernels<2> flat;
  DepthKernels<3> solid;
};

/// The kernels for this machine.
template <Dim N>
const DepthKernels<N>& depth_kernels();

extern template const DepthKernels<2>& depth_kernels<2>();
extern template const DepthKernels<3>& depth_kernels<3>();

}  // namespace graze::detail
