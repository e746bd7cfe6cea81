// SPDX-License-Identifier: MIT
// put_in_spatial_order<width>(boxes, order, executor): sorts boxes for a tree of nodes with `width` children.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/pieces.hpp>

namespace graze::detail {

/// The center of a box.
template <Dim N, class T>
struct BoxCenter {
  Vec<N, T> center;
  std::uint32_t box;
};

template <Dim N, class T>
Dim longest_axis(std::span<const BoxCenter<N, T>> centers) {
  Aabb<N, T> around = Aabb<N, T>::nothing();
  for (const BoxCenter<N, T>& one : centers) around.grow(one.center);
  const Vec<N, T> size = around.max * T(0.5) - around.min * T(0.5);
  Dim longest = 0;
  for (Dim i = 1; i < N; ++i) {
    if (size[i] > size[longest]) longest = i;
  }
  return longest;
}

/// Halves blocks along the axis on which their centers differ most. Returns the number in the first half.
template <std::size_t width, Dim N, class T>
std::size_t halve(std::span<BoxCenter<N, T>> centers) {
  if (centers.size() <= width) return centers.size();
  std::size_t block = width;
  while (block * width < centers.size()) block *= width;
  const std::size_t blocks = (centers.size() + block - 1) / block;
  const std::size_t middle = (blocks + 1) / 2 * block;
  const Dim axis = longest_axis<N, T>(centers);
  const auto is_before = [axis](const BoxCenter<N, T>& a, const BoxCenter<N, T>& b) {
    return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis] : a.box < b.box;
  };
  std::nth_element(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(middle), centers.end(), is_before);
  return middle;
}

template <std::size_t width, Dim N, class T>
void sort_centers(std::span<BoxCenter<N, T>> centers) {
  if (centers.size() <= width) return;
  const std::size_t middle = halve<width>(centers);
  sort_centers<width>(centers.first(middle));
  sort_centers<width>(centers.subspan(middle));
}

/// Sorts indices of finite boxes so that every block of width, width^2, ... is compact; the same for every executor.
template <std::size_t width, Dim N, class T, class Executor>
void put_in_spatial_order(std::span<const Aabb<N, T>> boxes, std::span<std::uint32_t> order, const Executor& executor) {
  using Centers = std::span<BoxCenter<N, T>>;
  std::vector<BoxCenter<N, T>> centers(order.size());
  for_pieces(executor, order.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Aabb<N, T>& box = boxes[order[i]];
      centers[i] = {box.min * T(0.5) + box.max * T(0.5), order[i]};
    }
  });
  std::vector<Centers> parts = {Centers(centers)};
  while (parts.front().size() > length_of_piece) {  // the first part is the longest
    std::vector<Centers> halves(2 * parts.size());
    executor.parallel_for(parts.size(), [&](std::size_t i) {
      const std::size_t middle = halve<width>(parts[i]);
      halves[2 * i] = parts[i].first(middle);
      halves[2 * i + 1] = parts[i].subspan(middle);
    });
    parts = std::move(halves);
  }
  executor.parallel_for(parts.size(), [&](std::size_t i) { sort_centers<width>(parts[i]); });
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = centers[i].box;
}

}  // namespace graze::detail
