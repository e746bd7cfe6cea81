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
  std::uint32_t first;  ///< Of its first indices.
  std::span<Pair> out;
};

/// Memory to sort buckets in, one after the other.
template <class Code>
struct BucketMemory {
  std::vector<std::span<const Code>> parts;  ///< Of the bucket.
  Buffer<std::uint32_t> seconds;             ///< Second indices by row, then the same sorted.
  std::vector<std::uint32_t> begins;         ///< Of rows.
  std::vector<std::uint32_t> next;           ///< The place of the next one of a row.
  std::vector<std::uint64_t> bits;           ///< Of second indices.
  Buffer<Code> keys;                         ///< Codes by row.
  std::uint32_t longest = 0;                 ///< Of the rows.

  std::size_t bytes() const;
};

/// Sorts the parts of a bucket. No pair may be there twice; every second index is less than `limit_b`.
template <class Code>
void sort_bucket(const SortedBucket<Code>& bucket, std::size_t limit_b, BucketMemory<Code>& memory);

}  // namespace graze::detail
