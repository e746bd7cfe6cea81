// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/bucket_sort.hpp>
#include <graze/broad/pairs/sort_kernels.hpp>

namespace graze::detail {
namespace {

/// One pass of a radix sort.
void sort_by_digit(const std::uint32_t* from, std::size_t count, std::uint32_t shift, std::uint32_t* to) {
  std::array<std::uint32_t, 257> ends{};
  for (std::size_t k = 0; k < count; ++k) ++ends[(from[k] >> shift & 0xFFU) + 1];
  for (std::size_t d = 0; d < 256; ++d) ends[d + 1] += ends[d];
  for (std::size_t k = 0; k < count; ++k) to[ends[from[k] >> shift & 0xFFU]++] = from[k];
}

/// Sorts distinct numbers below a limit. `to` is memory for as many.
void sort_numbers(std::uint32_t* numbers, std::size_t count, std::size_t limit, std::uint32_t* to,
                  std::vector<std::uint64_t>& bits) {
  constexpr std::size_t many = 96;
  constexpr std::size_t dense = 32;  // at most a word of bits for two numbers
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

/// Calls use(code) for all codes, alternating between two positions: neighbours are often of the same row, and would
/// wait for the same counter.
template <class Code, class Use>
void for_each_in_turns(std::span<const Code> codes, const Use& use) {
  const std::size_t half = codes.size() / 2;
  for (std::size_t k = 0; k < half; ++k) {
    use(codes[k]);
    use(codes[half + k]);
  }
  if (codes.size() % 2 != 0) use(codes.back());
}

/// Sorts a bucket whose rows are nearly all very short: codes by row, then all rows at once. `begins` contains where
/// each row begins.
template <class Code>
void sort_very_short_rows(const SortedBucket<Code>& bucket, BucketMemory<Code>& memory) {
  constexpr std::size_t margin = very_short_row;
  const std::size_t count = bucket.out.size();
  memory.keys.require(count + 2 * margin);
  Code* const keys = memory.keys.data() + margin;
  std::fill(keys - margin, keys, std::numeric_limits<Code>::min());
  std::fill(keys + count, keys + count + margin, std::numeric_limits<Code>::max());
  std::uint32_t* const ends = memory.begins.data();
  for (const auto& part : memory.parts) {
    for_each_in_turns(part, [=, form = bucket.code](Code code) { keys[ends[form.row_of(code)]++] = code; });
  }
  const CodeKernels<Code>& kernels = sort_kernels().of<Code>();
  kernels.place_keys(keys, count, {bucket.code, bucket.first}, bucket.out.data());
  if (memory.longest <= very_short_row) return;
  for (std::uint32_t row = 0; row < bucket.code.rows(); ++row) {
    const std::uint32_t begin = row == 0 ? 0 : ends[row - 1];
    if (ends[row] - begin <= very_short_row) continue;
    std::sort(keys + begin, keys + ends[row]);
    for (std::uint32_t k = begin; k < ends[row]; ++k) {
      bucket.out[k] = {bucket.first + row, bucket.code.second_of(keys[k])};
    }
  }
}

/// Sorts a bucket by rows, then each row by second indices.
template <class Code>
void sort_rows(const SortedBucket<Code>& bucket, std::size_t limit_b, BucketMemory<Code>& memory) {
  const std::size_t count = bucket.out.size();
  const std::uint32_t rows = bucket.code.rows();
  memory.next.assign(memory.begins.begin(), memory.begins.end() - 1);
  memory.seconds.require(2 * (count + short_row));
  std::uint32_t* const seconds = memory.seconds.data();
  std::uint32_t* const next = memory.next.data();
  for (const auto& part : memory.parts) {
    for_each_in_turns(
        part, [=, form = bucket.code](Code code) { seconds[next[form.row_of(code)]++] = form.second_of(code); });
  }
  std::fill(seconds + count, seconds + count + short_row, 0U);
  constexpr std::size_t many = 4;  // pairs per row
  const bool by_rows = sort_kernels().rows_pay && count >= many * rows;
  if (by_rows) {
    sort_kernels().place_rows(memory.begins.data(), rows, bucket.first, seconds, bucket.out.data());
  } else {
    for (const auto& part : memory.parts) {
      sort_kernels().of<Code>().place(part.data(), part.size(), {bucket.code, bucket.first}, memory.begins.data(),
                                      seconds, bucket.out.data());
    }
  }
  const std::uint32_t placed = by_rows ? placed_row : short_row;
  if (memory.longest <= placed) return;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t begin = memory.begins[row];
    const std::uint32_t end = memory.begins[row + 1];
    if (end - begin <= placed) continue;
    sort_numbers(seconds + begin, end - begin, limit_b, seconds + count + short_row, memory.bits);
    for (std::uint32_t k = begin; k < end; ++k) bucket.out[k] = {bucket.first + row, seconds[k]};
  }
}

/// Sorts a bucket of few pairs among many boxes, for which counting by row would take longer.
template <class Code>
void sort_few(const SortedBucket<Code>& bucket, const BucketMemory<Code>& memory) {
  Pair* out = bucket.out.data();
  for (const auto& part : memory.parts) {
    for (const Code code : part) *out++ = {bucket.first + bucket.code.row_of(code), bucket.code.second_of(code)};
  }
  std::sort(bucket.out.data(), out);
}

}  // namespace

template <class Code>
std::size_t BucketMemory<Code>::bytes() const {
  return parts.capacity() * sizeof(std::span<const Code>) + seconds.bytes() + bits.capacity() * sizeof(std::uint64_t) +
         (begins.capacity() + next.capacity()) * sizeof(std::uint32_t) + keys.bytes();
}

template <class Code>
void sort_bucket(const SortedBucket<Code>& bucket, std::size_t limit_b, BucketMemory<Code>& memory) {
  const std::uint32_t rows = bucket.code.rows();
  if (bucket.out.size() < rows / 16) {
    sort_few(bucket, memory);
    return;
  }
  memory.begins.assign(std::size_t{rows} + 1, 0);
  std::uint32_t* const counts = memory.begins.data();
  for (std::size_t k = 0; k < memory.parts.size(); ++k) {
    if (k + 1 < memory.parts.size()) prefetch_all(memory.parts[k + 1]);
    for_each_in_turns(memory.parts[k], [=, form = bucket.code](Code code) { ++counts[form.row_of(code)]; });
  }
  memory.longest = 0;
  std::size_t in_longer_rows = 0;
  std::uint32_t next = 0;
  for (std::uint32_t& begin : memory.begins) {
    const std::uint32_t length = std::exchange(begin, next);
    memory.longest = std::max(memory.longest, length);
    in_longer_rows += length > very_short_row ? length : 0U;
    next += length;
  }
  if (sort_kernels().of<Code>().keys_pay && in_longer_rows <= bucket.out.size() / 16) {
    sort_very_short_rows(bucket, memory);
  } else {
    sort_rows(bucket, limit_b, memory);
  }
}

template struct BucketMemory<std::int32_t>;
template struct BucketMemory<std::int64_t>;
template void sort_bucket<std::int32_t>(const SortedBucket<std::int32_t>&, std::size_t, BucketMemory<std::int32_t>&);
template void sort_bucket<std::int64_t>(const SortedBucket<std::int64_t>&, std::size_t, BucketMemory<std::int64_t>&);

}  // namespace graze::detail
