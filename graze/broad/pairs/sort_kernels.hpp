// SPDX-License-Identifier: MIT
// The inner loop of sorting pairs, once for every set of vector instructions that the compiler knows, as in
// block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_code.hpp>

namespace graze::detail {

/// A row of so many pairs, of one first index, is sorted by counting for each how many have a smaller second index.
inline constexpr std::uint32_t short_row = 16;

/// A row of so many pairs is sorted as a whole, where place_rows pays.
inline constexpr std::uint32_t placed_row = 32;

/// A row of so many pairs is sorted by counting smaller ones among all keys near to each.
inline constexpr std::uint32_t very_short_row = 8;

/// What codes of a bucket mean.
struct CodeBucket {
  PairCode code;
  std::uint32_t first;  ///< The first index of row 0.
};

/// For codes of one width.
template <class Code>
struct CodeKernels {
  /// Whether place_keys takes less time than place: where a vector holds eight codes.
  bool keys_pay;

  /// Puts pairs in their places, given by codes that are in the order of their rows. `codes` can be read by
  /// very_short_row further to either side, where there are numbers less than all before the first and not less than
  /// any after the last. Longer rows come in any order, not even each pair once, but where they belong.
  void (*place_keys)(const Code* codes, std::size_t count, const CodeBucket& bucket, Pair* out);

  /// Puts pairs in their places, given by codes in any order. A row begins at begins[row] and ends before
  /// begins[row + 1], where `seconds` has the second indices of the row in any order, and `out` wants the pairs sorted.
  /// `seconds` can be read 16 numbers further than the last row. Pairs of rows that are not short are left out.
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

  /// Whether place_rows takes less time than place: where a vector holds sixteen indices.
  bool rows_pay;

  /// Puts pairs in their places as place does, row by row, from their second indices alone. Rows longer than placed_row
  /// are left out; what they have in `out` is lost.
  void (*place_rows)(const std::uint32_t* begins, std::uint32_t rows, std::uint32_t first, const std::uint32_t* seconds,
                     Pair* out);
};

/// The kernels for this machine.
const SortKernels& sort_kernels();

}  // namespace graze::detail
