// SPDX-License-Identifier: MIT
// The pairs of a scene that the depth of their boxes decides without an exact test.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/update/box_depth.hpp>
#include <graze/scene/update/depth_kernels.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Notes for each pair whether its boxes overlap by more than `certain` and are the shapes themselves: then it touches.
/// Lists the positions of all other pairs that are not as clearly apart, and returns their number. No data-dependent
/// branches.
template <Dim N, class T, class AreBoxes>
// NOLINTNEXTLINE(readability-function-size): input and output arrays
std::size_t classify_bounds(const Aabb<N, T>* boxes, std::span<const Pair> pairs, T certain, const AreBoxes& are_boxes,
                            char* touches, std::size_t* open) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    prefetch(&boxes[pairs[std::min(i + prefetch_distance, pairs.size() - 1)].b]);
    const T depth = box_depth(boxes[pairs[i].a], boxes[pairs[i].b]);
    const unsigned is_deep = (depth > certain ? 1U : 0U) & (are_boxes(pairs[i]) ? 1U : 0U);
    const unsigned is_apart = depth >= -certain ? 0 : 1;  // NaN belongs to an empty box
    touches[i] = static_cast<char>(is_deep);
    open[count] = i;
    count += 1 - (is_deep | is_apart);
  }
  return count;
}

/// The same if all boxes are the shapes themselves.
template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): as above
std::size_t classify_boxes(const Aabb<N, T>* boxes, std::size_t /*boxes_in_row*/, std::span<const Pair> pairs,
                           T certain, char* touches, std::size_t* open) {
  return classify_bounds(
      boxes, pairs, certain, [](const Pair&) { return true; }, touches, open);
}

/// With vectors. The array of boxes has one more element than those referred to.
template <Dim N>
// NOLINTNEXTLINE(readability-function-size): as above
std::size_t classify_boxes(const Aabb<N, float>* boxes, std::size_t boxes_in_row, std::span<const Pair> pairs,
                           float certain, char* touches, std::size_t* open) {
  return depth_kernels<N>().judge(boxes, boxes_in_row, pairs.data(), pairs.size(), certain, touches, open);
}

}  // namespace graze::detail
