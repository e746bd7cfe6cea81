// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include <graze/broad/block_kernels.hpp>

namespace graze::test {

/// Boxes in arrays; the first has the id 1000.
template <Dim N, class T>
class OwnedBoxArrays {
 public:
  explicit OwnedBoxArrays(const std::vector<Aabb<N, T>>& boxes) : ids_(boxes.size()) {
    for (Dim i = 0; i < N; ++i) {
      for (const auto& box : boxes) {
        min_[i].push_back(box.min[i]);
        max_[i].push_back(box.max[i]);
      }
      boxes_.min[i] = min_[i].data();
      boxes_.max[i] = max_[i].data();
    }
    std::iota(ids_.begin(), ids_.end(), 1000U);
    boxes_.ids = ids_.data();
  }
  const detail::BoxArrays<N, T>& operator*() const { return boxes_; }

 private:
  std::vector<T> min_[N];
  std::vector<T> max_[N];
  std::vector<std::uint32_t> ids_;
  detail::BoxArrays<N, T> boxes_{};
};

}  // namespace graze::test
