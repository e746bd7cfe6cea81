// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include <graze/broad/buffer.hpp>
#include <graze/broad/pair_sort.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/broad/sort_kernels.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t most_buckets = 1024;
constexpr std::uint32_t least_bits = 7;  // of first indices in a bucket

/// Memory to sort a bucket in.
struct Spare {
  std::vector<std::span<const Pair>> parts;  // of the bucket
  Buffer<std::uint32_t> seconds;             // second indices by row, then the same sorted
  std::vector<std::uint32_t> begins;         // of rows
  std::vector<std::uint32_t> next;           // the place of the next one of a row
  std::vector<std::uint64_t> bits;           // of second indices
  Buffer<std::int64_t> keys;                 // rows and second indices, by row
  std::uint32_t longest = 0;                 // of the rows

  std::size_t bytes() const {
    return parts.capacity() * sizeof(std::span<const Pair>) + seconds.bytes() +
           bits.capacity() * sizeof(std::uint64_t) + (begins.capacity() + next.capacity()) * sizeof(std::uint32_t) +
           keys.bytes();
  }
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

/// Calls use(pair) for all pairs, from two places in turns: neighbours are often of one row, whose counter each would
/// wait for.
template <class Use>
void for_each_in_turns(std::span<const Pair> pairs, const Use& use) {
  const std::size_t half = pairs.size() / 2;
  for (std::size_t k = 0; k < half; ++k) {
    use(pairs[k]);
    use(pairs[half + k]);
  }
  if (pairs.size() % 2 != 0) use(pairs.back());
}

/// A bucket that is sorted into `out`.
struct Bucket {
  std::uint32_t first;     // of its first indices
  std::uint32_t row_mask;  // gives the row of a first index
  std::span<Pair> out;
};

/// Sorts a bucket whose rows are nearly all very short: keys by row, then all rows at once. `begins` has where rows
/// begin.
void sort_very_short_rows(const Bucket& bucket, Spare& spare) {
  constexpr std::size_t margin = very_short_row;
  const std::size_t count = bucket.out.size();
  spare.keys.require(count + 2 * margin);
  std::int64_t* const keys = spare.keys.data() + margin;
  std::fill(keys - margin, keys, std::numeric_limits<std::int64_t>::min());
  std::fill(keys + count, keys + count + margin, std::numeric_limits<std::int64_t>::max());
  std::uint32_t* const ends = spare.begins.data();
  for (const auto& part : spare.parts) {
    for_each_in_turns(part, [=](const Pair& pair) {
      const std::uint32_t row = pair.a & bucket.row_mask;
      keys[ends[row]++] = static_cast<std::int64_t>(std::uint64_t{row} << 32U | pair.b);
    });
  }
  sort_kernels().place_keys(keys, count, bucket.first, bucket.out.data());
  if (spare.longest <= very_short_row) return;
  for (std::uint32_t row = 0; row <= bucket.row_mask; ++row) {
    const std::uint32_t begin = row == 0 ? 0 : ends[row - 1];
    if (ends[row] - begin <= very_short_row) continue;
    std::sort(keys + begin, keys + ends[row]);
    for (std::uint32_t k = begin; k < ends[row]; ++k) {
      bucket.out[k] = {bucket.first + row, static_cast<std::uint32_t>(keys[k])};
    }
  }
}

/// Sorts a bucket by rows, then each row by second indices.
void sort_rows(const Bucket& bucket, std::size_t limit_b, Spare& spare) {
  const std::size_t count = bucket.out.size();
  spare.next.assign(spare.begins.begin(), spare.begins.end() - 1);
  spare.seconds.require(2 * (count + short_row));
  std::uint32_t* const seconds = spare.seconds.data();
  std::uint32_t* const next = spare.next.data();
  for (const auto& part : spare.parts) {
    for_each_in_turns(part, [=](const Pair& pair) { seconds[next[pair.a & bucket.row_mask]++] = pair.b; });
  }
  std::fill(seconds + count, seconds + count + short_row, 0U);
  constexpr std::size_t many = 4;  // pairs a row
  const bool by_rows = sort_kernels().rows_pay && count >= many * (bucket.row_mask + 1);
  if (by_rows) {
    sort_kernels().place_rows(spare.begins.data(), bucket.row_mask + 1, bucket.first, seconds, bucket.out.data());
  } else {
    for (const auto& part : spare.parts) {
      sort_kernels().place(part.data(), part.size(), bucket.row_mask, spare.begins.data(), seconds, bucket.out.data());
    }
  }
  const std::uint32_t placed = by_rows ? placed_row : short_row;
  if (spare.longest <= placed) return;
  for (std::uint32_t row = 0; row <= bucket.row_mask; ++row) {
    const std::uint32_t begin = spare.begins[row];
    const std::uint32_t end = spare.begins[row + 1];
    if (end - begin <= placed) continue;
    sort_numbers(seconds + begin, end - begin, limit_b, seconds + count + short_row, spare.bits);
    for (std::uint32_t k = begin; k < end; ++k) bucket.out[k] = {bucket.first + row, seconds[k]};
  }
}

/// Sorts the parts of a bucket.
void sort_bucket(const Bucket& bucket, std::size_t limit_b, Spare& spare) {
  const std::uint32_t rows = bucket.row_mask + 1;
  if (bucket.out.size() < rows / 16) {  // few pairs of many boxes: counting would take longer
    Pair* out = bucket.out.data();
    for (const auto& part : spare.parts) out = std::copy(part.begin(), part.end(), out);
    std::sort(bucket.out.data(), out);
    return;
  }
  spare.begins.assign(rows + 1, 0);
  std::uint32_t* const counts = spare.begins.data();
  for (std::size_t k = 0; k < spare.parts.size(); ++k) {
    if (k + 1 < spare.parts.size()) prefetch_all(spare.parts[k + 1]);
    for_each_in_turns(spare.parts[k], [=](const Pair& pair) { ++counts[pair.a & bucket.row_mask]; });
  }
  spare.longest = 0;
  std::size_t in_longer_rows = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& begin : spare.begins) {
    const std::uint32_t length = std::exchange(begin, next);
    spare.longest = std::max(spare.longest, length);
    in_longer_rows += length > very_short_row ? length : 0U;
    next += length;
  }
  if (sort_kernels().keys_pay && in_longer_rows <= bucket.out.size() / 16) {
    sort_very_short_rows(bucket, spare);
  } else {
    sort_rows(bucket, limit_b, spare);
  }
}

}  // namespace

void PairSort::begin(std::size_t limit_a, std::size_t threads) {
  constexpr std::size_t few_threads = 4;
  bits_ = std::max(least_bits, static_cast<std::uint32_t>(std::bit_width(limit_a / most_buckets)));
  ends_.resize((limit_a >> bits_) + 1);
  chunk_ = threads <= few_threads ? PairChunk::large : PairChunk::small;
  for (const auto& buckets : buckets_.all()) clear(*buckets);
}

void PairSort::clear(PairBuckets& buckets) const { buckets.clear(ends_.size(), bits_, chunk_); }

PairSort::Sink::Sink(PairSort& sort) : buckets_(sort.buckets_) {
  if (buckets_->buckets() == 0) sort.clear(*buckets_);
}

std::size_t PairSort::count() {
  std::uint64_t count = 0;
  for (std::size_t bucket = 0; bucket < ends_.size(); ++bucket) {
    for (const auto& buckets : buckets_.all()) count += buckets->count(bucket);
    ends_[bucket] = count;
  }
  return static_cast<std::size_t>(count);
}

Pair* PairSort::sort(std::size_t limit_b, const Executor& executor, PairRoom& room) {
  constexpr std::size_t buckets_per_task = 16;
  Pair* const out = room.all_in_turns(ends_.empty() ? 0 : static_cast<std::size_t>(ends_.back()));
  Pool<Spare> spares;  // not kept: a bucket may have most of the pairs
  executor.parallel_for((ends_.size() + buckets_per_task - 1) / buckets_per_task, [&](std::size_t task) {
    const Pool<Spare>::Loan loan(spares);
    Spare& spare = *loan;
    const std::size_t last = std::min(ends_.size(), (task + 1) * buckets_per_task);
    for (std::size_t k = task * buckets_per_task; k < last; ++k) {
      const auto begin = static_cast<std::size_t>(k == 0 ? 0 : ends_[k - 1]);
      const auto end = static_cast<std::size_t>(ends_[k]);
      if (end == begin) continue;
      spare.parts.clear();
      for (const auto& buckets : buckets_.all()) {
        buckets->for_each_part(k, [&spare](std::span<const Pair> part) { spare.parts.push_back(part); });
      }
      if (k + 1 < last) prefetch_all(buckets_.all().front()->open_part(k + 1));
      const Bucket bucket{static_cast<std::uint32_t>(k << bits_), (1U << bits_) - 1, {out + begin, end - begin}};
      room.reach(end);
      sort_bucket(bucket, limit_b, spare);
    }
  });
  passing_bytes_ = 0;
  for (const auto& spare : spares.all()) passing_bytes_ += spare->bytes();
  return out;
}

std::size_t PairSort::bytes() const {
  std::size_t result = ends_.capacity() * sizeof(std::uint64_t) + passing_bytes_;
  for (const auto& buckets : buckets_.all()) result += buckets->bytes();
  return result;
}

}  // namespace graze::detail
