// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include <graze/broad/buffer.hpp>
#include <graze/broad/pair_sort.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t most_buckets = 1024;
constexpr std::uint32_t least_bits = 8;  // a bucket holds at least so many first indices, as a power of two

/// Sorts by one digit of the second index, from one place to another.
void sort_by_digit(const Pair* from, std::size_t count, std::uint32_t shift, Pair* to) {
  std::array<std::uint32_t, 257> ends{};
  for (std::size_t k = 0; k < count; ++k) ++ends[(from[k].b >> shift & 0xFFU) + 1];
  for (std::size_t d = 0; d < 256; ++d) ends[d + 1] += ends[d];
  for (std::size_t k = 0; k < count; ++k) to[ends[from[k].b >> shift & 0xFFU]++] = from[k];
}

/// Sorts pairs of one first index by the second: few by insertion, many of a small range by a bit for each.
void sort_row(Pair* pairs, std::size_t count, std::size_t limit_b, Pair* spare, std::vector<std::uint64_t>& bits) {
  constexpr std::size_t few = 24;
  constexpr std::size_t many = 96;
  constexpr std::size_t dense = 32;  // a word of bits for two pairs
  if (count <= few) {
    for (std::size_t k = 1; k < count; ++k) {
      const Pair pair = pairs[k];
      std::size_t at = k;
      for (; at > 0 && pairs[at - 1].b > pair.b; --at) pairs[at] = pairs[at - 1];
      pairs[at] = pair;
    }
  } else if (count * dense >= limit_b) {
    bits.assign(limit_b / 64 + 1, 0);
    for (std::size_t k = 0; k < count; ++k) bits[pairs[k].b / 64] |= std::uint64_t{1} << pairs[k].b % 64;
    std::size_t at = 0;
    for (std::size_t word = 0; word < bits.size(); ++word) {
      for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1, ++at) {
        pairs[at].b = static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
      }
    }
  } else if (count <= many) {
    std::sort(pairs, pairs + count, [](const Pair& p, const Pair& q) { return p.b < q.b; });
  } else {
    for (std::uint32_t shift = 0; limit_b >> shift != 0 && shift < 32; shift += 16) {
      sort_by_digit(pairs, count, shift, spare);
      sort_by_digit(spare, count, shift + 8, pairs);
    }
  }
}

/// Both indices as one number: a single comparison instead of two, of which the first is anybody's guess.
std::uint64_t rank(const Pair& pair) {
  if constexpr (std::endian::native == std::endian::little) return std::rotl(std::bit_cast<std::uint64_t>(pair), 32);
  return std::uint64_t{pair.a} << 32U | pair.b;
}

Pair pair_of(std::uint64_t rank) {
  return {static_cast<std::uint32_t>(rank >> 32U), static_cast<std::uint32_t>(rank & 0xFFFFFFFFU)};
}

/// Sorts pairs that are sorted by the first index, where few share one: most are in their places already, so that an
/// insertion sort seldom guesses wrong.
void sort_short_rows(Pair* pairs, std::size_t count) {
  std::uint64_t before = count > 0 ? rank(pairs[0]) : 0;
  for (std::size_t k = 1; k < count; ++k) {
    const std::uint64_t here = rank(pairs[k]);
    if (before <= here) {
      before = here;
      continue;
    }
    std::size_t at = k;  // `before` stays the greatest so far
    do {
      pairs[at] = pairs[at - 1];
      --at;
    } while (at > 0 && rank(pairs[at - 1]) > here);
    pairs[at] = pair_of(here);
  }
}

/// Sorts a bucket whose first indices are 2^bits in a row. `spare` is memory for as many pairs.
void sort_bucket(Pair* pairs, std::size_t count, std::uint32_t bits, std::size_t limit_b, Pair* spare,
                 std::vector<std::uint32_t>& ends, std::vector<std::uint64_t>& row_bits) {
  if (count < std::size_t{1} << bits >> 4U) {  // few pairs of many boxes: counting would take longer
    std::sort(pairs, pairs + count);
    return;
  }
  std::copy(pairs, pairs + count, spare);
  const std::uint32_t low = (1U << bits) - 1;
  ends.assign(std::size_t{1} << bits, 0);
  for (std::size_t k = 0; k < count; ++k) ++ends[spare[k].a & low];
  std::uint32_t next = 0;
  std::uint32_t longest = 0;
  for (std::uint32_t& end : ends) {
    longest = std::max(longest, end);
    next += std::exchange(end, next);
  }
  for (std::size_t k = 0; k < count; ++k) pairs[ends[spare[k].a & low]++] = spare[k];
  constexpr std::uint32_t short_row = 16;
  if (longest <= short_row) {
    sort_short_rows(pairs, count);
    return;
  }
  std::size_t begin = 0;
  for (const std::uint32_t end : ends) {
    if (end - begin > 1) sort_row(pairs + begin, end - begin, limit_b, spare, row_bits);
    begin = end;
  }
}

}  // namespace

void PairSort::sort(std::span<const std::span<const Pair>> pieces, std::size_t limit_a, std::size_t limit_b,
                    const Executor& executor, Pair* out) {
  const auto bits = std::max(least_bits, static_cast<std::uint32_t>(std::bit_width(limit_a / most_buckets)));
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
    std::vector<std::uint32_t> ends;
    std::vector<std::uint64_t> row_bits;
    Buffer<Pair> spare;
    for (std::size_t k = task * buckets_per_task; k < std::min(buckets, (task + 1) * buckets_per_task); ++k) {
      const std::size_t begin = k == 0 ? 0 : ends_[k - 1];
      spare.require(ends_[k] - begin);
      sort_bucket(out + begin, ends_[k] - begin, bits, limit_b, spare.data(), ends, row_bits);
    }
  });
}

std::size_t PairSort::bytes() const { return (places_.capacity() + ends_.capacity()) * sizeof(std::uint64_t); }

}  // namespace graze::detail
