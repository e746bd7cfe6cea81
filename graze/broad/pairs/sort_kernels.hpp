// SPDX-License-Identifier: MIT
// Inner loops of sorting pairs, compiled for each instruction set as in block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_code.hpp>

namespace graze::detail {

/// A row is the pairs of one first index. A row up to this length is sorted by counting, for each pair, the smaller
/// second indices.
inline constexpr std::uint32_t short_row = 16;

/// A row up to this length is sorted as a whole if place_rows pays.
inline constexpr std::uint32_t placed_row = 32;

/// A row up to this length is sorted by counting the smaller keys among all nearby keys.
inline constexpr std::uint32_t very_short_row = 8;

/// The meaning of the codes of a bucket.
struct CodeBucket {
  PairCode code;
  std::uint32_t first;  ///< The first index of row 0.
};

/// For codes of one width.
template <class Code>
struct CodeKernels {
  /// Whether place_keys is faster than place: true if a vector holds eight codes.
  bool keys_pay;

  /// Writes pairs to their final positions, given codes sorted by row. `codes` must be readable for very_short_row
  /// elements on either side, with numbers less than all before the first code and not less than any after the last.
  /// Rows longer than very_short_row are left in unspecified order, possibly with duplicates, but in the right range.
  void (*place_keys)(const Code* codes, std::size_t count, const CodeBucket& bucket, Pair* out);

  /// Writes pairs to their final positions, given codes in any order. A row occupies the range from begins[row] to
  /// begins[row + 1], where `seconds` contains its second indices in any order and `out` receives the sorted pairs.
  /// `seconds` must be readable for 16 numbers after the last row. Skips rows longer than short_row.
  void (*place)(const Code* codes, std::size_t count, const CodeBucket& bucket, const std::uint32_t* begins,
                const std::uint32_t* seconds, Pair* out);
};

struct SortKernels {
  CodeKernels<std::int32_t> narrow;
  CodeKernels<std::int64_t> wide;

  template <class Code>
  const CodeKernels<Code>& of() const {
    if constexpr (sizeof(Code) == sizeof(std::int32_t)) {
      return narrow;
    } else {
      return wide;
    }
  }

  /// Whether place_rows is faster than place: true if a vector holds sixteen indices.
  bool rows_pay;

  /// Like place, row by row, from the second indices alone. Skips rows longer than placed_row, whose range of `out` is
  /// overwritten.
  void (*place_rows)(const std::uint32_t* begins, std::uint32_t rows, std::uint32_t first, const std::uint32_t* seconds,
                     Pair* out);
};

/// The kernels for this machine.
const SortKernels& sort_kernels();

}  // namespace graze::detail
