// SPDX-License-Identifier: MIT
// The inner loop of sorting pairs, once for every set of vector instructions that the compiler knows, as in
// block_kernels.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// A row of so many pairs, of one first index, is sorted by counting for each how many have a smaller second index.
inline constexpr std::uint32_t short_row = 16;

/// A row of so many pairs is sorted as a whole, where place_rows pays.
inline constexpr std::uint32_t placed_row = 32;

/// A row of so many pairs is sorted by counting smaller ones among all keys near to each.
inline constexpr std::uint32_t very_short_row = 8;

struct SortKernels {
  /// Whether place_keys takes less time than place: where a vector holds eight keys.
  bool keys_pay;

  /// Puts pairs in their places, given by keys that are in the order of their rows: the number of the row in the upper
  /// half, the second index in the lower. The first index of row 0 is `first`. `keys` can be read by very_short_row
  /// further to either side, where there are keys less than all before the first and greater than all after the last.
  /// Longer rows come in any order, not even each pair once, but where they belong.
  void (*place_keys)(const std::int64_t* keys, std::size_t count, std::uint32_t first, Pair* out);

  /// Puts pairs in their places. The row of a pair is `a & row_mask`; its row begins at begins[row] and ends before
  /// begins[row + 1], where `seconds` has the second indices of the row in any order, and `out` wants the pairs sorted.
  /// `seconds` can be read 16 numbers further than the last row. Pairs of rows that are not short are left out.
  void (*place)(const Pair* pairs, std::size_t count, std::uint32_t row_mask, const std::uint32_t* begins,
                const std::uint32_t* seconds, Pair* out);

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
