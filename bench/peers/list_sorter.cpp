// SPDX-License-Identifier: MIT
#include "list_sorter.hpp"

#include <cstddef>

#include <hwy/contrib/sort/vqsort.h>

namespace graze::race {

std::span<const Pair> ListSorter::sort(std::span<const Pair> pairs) {
  keys_.resize(pairs.size());
  sorted_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) keys_[i] = std::uint64_t{pairs[i].a} << 32U | pairs[i].b;
  hwy::Sorter()(keys_.data(), keys_.size(), hwy::SortAscending());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    sorted_[i] = {static_cast<std::uint32_t>(keys_[i] >> 32U), static_cast<std::uint32_t>(keys_[i])};
  }
  return sorted_;
}

}  // namespace graze::race
