// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <graze/broad/simd/block.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Measures how well an order of boxes still clusters them after they have moved: the number of other blocks that a
/// block would overlap if all had typical extents and were evenly distributed. In integers, so that sums do not depend
/// on the order.
template <Dim N, class T>
class BlockSpread {
 public:
  /// Sets the typical extents to the median of some blocks, whose bounds are in the lanes of `above`.
  void take_as_usual(const Block<N, T>* above, std::size_t count) {
    most_ = static_cast<double>(count);
    const std::size_t stride = count / most_samples + 1;
    std::vector<T> extents;
    for (Dim i = 0; i < N; ++i) {
      extents.clear();
      for (std::size_t k = 0; k < count; k += stride) extents.push_back(extent_of(above, k, i));
      const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
      std::nth_element(extents.begin(), middle, extents.end());
      per_extent_[i] = *middle > 0 && std::isfinite(*middle) ? 1 / static_cast<double>(*middle) : 0;
    }
  }

  /// The measure of one block, in units of 1 / 64.
  std::uint64_t of(const Block<N, T>* above, std::size_t block) const {
    double met = 1;
    for (Dim i = 0; i < N; ++i) met *= static_cast<double>(extent_of(above, block, i)) * per_extent_[i] + 1;
    return static_cast<std::uint64_t>(met < most_ ? met * 64 : most_ * 64);
  }

  /// The sum over the blocks in [first, last).
  std::uint64_t of(const Block<N, T>* above, std::size_t first, std::size_t last) const {
    std::uint64_t sum = 0;
    for (std::size_t k = first; k < last; ++k) sum += of(above, k);
    return sum;
  }

 private:
  static constexpr std::size_t most_samples = 1024;

  /// Replaces NaN by infinity, so that extents can be sorted.
  static T extent_of(const Block<N, T>* above, std::size_t block, Dim i) {
    const Block<N, T>& bounds = above[block / block_size];
    const T extent = bounds.max[i][block % block_size] - bounds.min[i][block % block_size];
    return std::isnan(extent) ? std::numeric_limits<T>::infinity() : extent;
  }

  Vec<N, double> per_extent_ = Vec<N, double>(0.0);
  double most_ = 0;  // no block overlaps more than there are
};

}  // namespace graze::detail
