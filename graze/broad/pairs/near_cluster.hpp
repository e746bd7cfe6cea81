// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/block_kernels.hpp>
#include <graze/broad/pairs/cluster.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Centers of gathered boxes, for sort_cluster; `in_order` of them have the indices 0, 1, ...
template <Dim N, class T>
struct NearCenters {
  const Aabb<N, T>* boxes;
  std::size_t in_order = 0;

  Vec<N, T> operator()(std::uint32_t k) const { return boxes[k].center(); }
  void prefetch(std::uint32_t /*k*/) const {}

  bool are_all(std::size_t count) const { return count == in_order; }
  Aabb<N, T> bounds() const { return block_kernels<N, T>().center_bounds(boxes, in_order); }
  void find_cells(const CellGrid<N, T>& grid, std::uint16_t* cells) const {
    block_kernels<N, T>().center_cells(boxes, in_order, grid, cells);
  }
};

/// Gathers boxes from scattered positions.
template <Dim N, class T>
void fetch_boxes(std::span<const Aabb<N, T>> from, const std::uint32_t* ids, std::size_t count, Aabb<N, T>* to) {
  for (std::size_t k = 0; k < count; ++k) {
    prefetch(&from[ids[std::min(k + prefetch_distance, count - 1)]]);
    std::memcpy(&to[k], &from[ids[k]], sizeof(Aabb<N, T>));
  }
}

/// A cluster that fits a core's cache, to be sorted as by sort_cluster; its boxes are gathered once.
template <Dim N, class T>
class NearCluster {
 public:
  static constexpr std::size_t most = std::size_t{1} << 17U;

  /// Sorts up to `most` ids of finite boxes, in ascending order on input; `cells` is memory for as many.
  void sort(std::span<const Aabb<N, T>> from, std::uint32_t* ids, std::size_t count, std::size_t small,
            std::uint16_t* cells) {
    boxes_.require(count);
    order_.require(count);
    spare_.require(count);
    fetch_boxes(from, ids, count, boxes_.data());
    std::iota(order_.data(), order_.data() + count, 0U);
    sort_cluster<N, T>(order_.data(), count, small, NearCenters<N, T>{boxes_.data(), count}, cells, spare_.data());
    std::copy(ids, ids + count, spare_.data());
    for (std::size_t k = 0; k < count; ++k) ids[k] = spare_[order_[k]];
  }

  std::size_t bytes() const { return boxes_.bytes() + order_.bytes() + spare_.bytes(); }

 private:
  Buffer<Aabb<N, T>> boxes_;
  Buffer<std::uint32_t> order_;
  Buffer<std::uint32_t> spare_;
};

}  // namespace graze::detail
