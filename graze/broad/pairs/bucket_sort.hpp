// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_code.hpp>

namespace graze::detail {

/// A bucket whose pairs are sorted into `out`.
template <class Code>
struct SortedBucket {
  PairCode code;
  std::uint32_t first;  ///< The bucket's lowest first index.
  std::span<Pair> out;
};

/// Scratch memory for sorting one bucket after another.
template <class Code>
struct BucketMemory {
  std::vector<std::span<const Code>> parts;  ///< Of the bucket.
  Buffer<std::uint32_t> seconds;             ///< Second indices by row, then the same sorted.
  std::vector<std::uint32_t> begins;         ///< Where each row begins.
  std::vector<std::uint32_t> next;           ///< Where the next pair of each row goes.
  std::vector<std::uint64_t> bits;           ///< A bit set of second indices.
  Buffer<Code> keys;                         ///< Codes by row.
  std::uint32_t longest = 0;                 ///< Length of the longest row.

  std::size_t bytes() const;
};

/// Sorts the parts of a bucket. Pairs must be distinct, and second indices below `limit_b`.
template <class Code>
void sort_bucket(const SortedBucket<Code>& bucket, std::size_t limit_b, BucketMemory<Code>& memory);

}  // namespace graze::detail
