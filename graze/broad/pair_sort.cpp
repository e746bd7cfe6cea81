// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include <graze/broad/buffer.hpp>
#include <graze/broad/pair_sort.hpp>
#include <graze/broad/sort_kernels.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t most_buckets = 1024;
constexpr std::size_t pairs_per_bucket = 1024;
constexpr std::uint32_t most_bits = 8;  // of first indices in a bucket, where buckets are few enough

/// Memory to sort a bucket in.
struct Spare {
  Buffer<Pair> pairs;
  Buffer<std::uint32_t> seconds;      // second indices by row, then the same sorted
  std::vector<std::uint32_t> begins;  // of rows
  std::vector<std::uint32_t> next;    // the place of the next one of a row
  std::vector<std::uint64_t> bits;    // of second indices
  Buffer<std::int64_t> keys;          // rows and second indices, by row
  std::uint32_t longest = 0;          // of the rows
};

/// Sorts by one digit, from one place to another.
void sort_by_digit(const std::uint32_t* from, std::size_t count, std::uint32_t shift, std::uint32_t* to) {
  std::array<std::uint32_t, 257> ends{};
  for (std::size_t k = 0; k < count; ++k) ++ends[(from[k] >> shift & 0xFFU) + 1];
  for (std::size_t d = 0; d < 256; ++d) ends[d + 1] += ends[d];
  for (std::size_t k = 0; k < count; ++k) to[ends[from[k] >> shift & 0xFFU]++] = from[k];
}

/// Sorts many numbers below a limit, none of which comes twice. `to` is memory for as many.
void sort_numbers(std::uint32_t* numbers, std::size_t count, std::size_t limit, std::uint32_t* to,
                  std::vector<std::uint64_t>& bits) {
  constexpr std::size_t many = 96;
  constexpr std::size_t dense = 32;  // a word of bits for two numbers
  if (count * dense >= limit) {
    bits.assign(limit / 64 + 1, 0);
    for (std::size_t k = 0; k < count; ++k) bits[numbers[k] / 64] |= std::uint64_t{1} << numbers[k] % 64;
    for (std::size_t word = 0; word < bits.size(); ++word) {
      for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1) {
        *numbers++ = static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
      }
    }
  } else if (count <= many) {
    std::sort(numbers, numbers + count);
  } else {
    for (std::uint32_t shift = 0; shift < 32 && limit >> shift != 0; shift += 16) {
      sort_by_digit(numbers, count, shift, to);
      sort_by_digit(to, count, shift + 8, numbers);
    }
  }
}

/// Sorts a bucket whose rows are nearly all very short: keys by row, then all rows at once. `ends` has where rows
/// begin.
void sort_very_short_rows(std::span<Pair> pairs, std::uint32_t first, std::uint32_t row_mask, Spare& spare) {
  constexpr std::size_t margin = very_short_row;
  spare.keys.require(pairs.size() + 2 * margin);
  std::int64_t* const keys = spare.keys.data() + margin;
  std::fill(keys - margin, keys, std::numeric_limits<std::int64_t>::min());
  std::fill(keys + pairs.size(), keys + pairs.size() + margin, std::numeric_limits<std::int64_t>::max());
  std::uint32_t* const ends = spare.begins.data();
  for (const Pair& pair : pairs) {
    const std::uint32_t row = pair.a & row_mask;
    keys[ends[row]++] = static_cast<std::int64_t>(std::uint64_t{row} << 32U | pair.b);
  }
  sort_kernels().place_keys(keys, pairs.size(), first, pairs.data());
  if (spare.longest <= very_short_row) return;
  for (std::uint32_t row = 0; row <= row_mask; ++row) {
    const std::uint32_t begin = row == 0 ? 0 : ends[row - 1];
    if (ends[row] - begin <= very_short_row) continue;
    std::sort(keys + begin, keys + ends[row]);
    for (std::uint32_t k = begin; k < ends[row]; ++k) pairs[k] = {first + row, static_cast<std::uint32_t>(keys[k])};
  }
}

/// Sorts a bucket by rows, then each row by second indices.
void sort_rows(std::span<Pair> pairs, std::uint32_t first, std::uint32_t row_mask, std::size_t limit_b, Spare& spare) {
  const std::size_t count = pairs.size();
  spare.next.assign(spare.begins.begin(), spare.begins.end() - 1);
  spare.pairs.require(count);
  spare.seconds.require(2 * (count + short_row));
  std::uint32_t* const seconds = spare.seconds.data();
  for (std::size_t k = 0; k < count; ++k) {
    spare.pairs[k] = pairs[k];
    seconds[spare.next[pairs[k].a & row_mask]++] = pairs[k].b;
  }
  std::fill(seconds + count, seconds + count + short_row, 0U);
  sort_kernels().place(spare.pairs.data(), count, row_mask, spare.begins.data(), seconds, pairs.data());
  if (spare.longest <= short_row) return;
  for (std::uint32_t row = 0; row <= row_mask; ++row) {
    const std::uint32_t begin = spare.begins[row];
    const std::uint32_t end = spare.begins[row + 1];
    if (end - begin <= short_row) continue;
    sort_numbers(seconds + begin, end - begin, limit_b, seconds + count + short_row, spare.bits);
    for (std::uint32_t k = begin; k < end; ++k) pairs[k] = {first + row, seconds[k]};
  }
}

/// Sorts a bucket whose first indices are 2^bits in a row.
void sort_bucket(std::span<Pair> pairs, std::uint32_t bits, std::size_t limit_b, Spare& spare) {
  if (pairs.size() < std::size_t{1} << bits >> 4U) {  // few pairs of many boxes: counting would take longer
    std::sort(pairs.begin(), pairs.end());
    return;
  }
  const std::uint32_t rows = 1U << bits;
  const std::uint32_t row_mask = rows - 1;
  const std::uint32_t first = pairs[0].a & ~row_mask;
  spare.begins.assign(rows + 1, 0);
  for (const Pair& pair : pairs) ++spare.begins[pair.a & row_mask];
  spare.longest = 0;
  std::uint32_t in_longer_rows = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& begin : spare.begins) {
    const std::uint32_t length = std::exchange(begin, next);
    spare.longest = std::max(spare.longest, length);
    in_longer_rows += length > very_short_row ? length : 0U;
    next += length;
  }
  if (sort_kernels().keys_pay && in_longer_rows <= pairs.size() / 16) {
    sort_very_short_rows(pairs, first, row_mask, spare);
  } else {
    sort_rows(pairs, first, row_mask, limit_b, spare);
  }
}

}  // namespace

void PairSort::sort(std::span<const std::span<const Pair>> pieces, std::size_t limit_a, std::size_t limit_b,
                    const Executor& executor, Pair* out) {
  std::size_t total = 0;
  for (const auto& piece : pieces) total += piece.size();
  // So many first indices in a bucket that its pairs fit the first caches, but not more buckets than those have room
  // for.
  const auto fitting = static_cast<std::uint32_t>(std::bit_width(limit_a * pairs_per_bucket / (total + 1)));
  const auto bits =
      std::max(std::min(most_bits, fitting), static_cast<std::uint32_t>(std::bit_width(limit_a / most_buckets)));
  const std::size_t buckets = (limit_a >> bits) + 1;
  places_.assign(pieces.size() * buckets, 0);
  executor.parallel_for(pieces.size(), [&](std::size_t piece) {
    std::uint64_t* const counts = places_.data() + piece * buckets;
    for (const Pair& pair : pieces[piece]) ++counts[pair.a >> bits];
  });
  ends_.assign(buckets, 0);
  std::uint64_t next = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
      next += std::exchange(places_[piece * buckets + bucket], next);
    }
    ends_[bucket] = next;
  }
  executor.parallel_for(pieces.size(), [&](std::size_t piece) {
    std::uint64_t* const places = places_.data() + piece * buckets;
    for (const Pair& pair : pieces[piece]) out[places[pair.a >> bits]++] = pair;
  });
  constexpr std::size_t buckets_per_task = 16;
  executor.parallel_for((buckets + buckets_per_task - 1) / buckets_per_task, [&](std::size_t task) {
    Spare spare;
    for (std::size_t k = task * buckets_per_task; k < std::min(buckets, (task + 1) * buckets_per_task); ++k) {
      const auto begin = static_cast<std::size_t>(k == 0 ? 0 : ends_[k - 1]);
      const auto end = static_cast<std::size_t>(ends_[k]);
      if (end > begin) sort_bucket({out + begin, end - begin}, bits, limit_b, spare);
    }
  });
}

std::size_t PairSort::bytes() const { return (places_.capacity() + ends_.capacity()) * sizeof(std::uint64_t); }

}  // namespace graze::detail
