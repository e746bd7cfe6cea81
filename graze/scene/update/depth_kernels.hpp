// SPDX-License-Identifier: MIT
// The loop that calculates how deeply the boxes of pairs overlap, compiled once for each vector instruction set, as in
// block_kernels.hpp.
#pragma once

#include <cstddef>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N>
struct DepthKernels {
  /// Marks each pair by 1 if its box_depth is above `certain`, otherwise by 0. Lists the positions of the others that
  /// are not below -certain, and returns their number. The array of boxes has one more element than those referred to;
  /// `boxes_in_row` is its size, used only to decide about prefetching.
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
