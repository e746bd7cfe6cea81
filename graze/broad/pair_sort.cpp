// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>

#include <graze/broad/bucket_sort.hpp>
#include <graze/broad/pair_sort.hpp>
#include <graze/broad/prefetch.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t most_buckets = 1024;
constexpr std::uint32_t least_row_bits = 7;

}  // namespace

void PairSort::begin(const PairLimits& limits, std::size_t threads) {
  constexpr std::size_t few_threads = 4;
  code_.row_bits = std::max(least_row_bits, static_cast<std::uint32_t>(std::bit_width(limits.a / most_buckets)));
  code_.second_bits = static_cast<std::uint32_t>(std::bit_width(std::max<std::size_t>(limits.b, 1) - 1));
  if (!code_.narrow()) code_.second_bits = 32;
  limit_b_ = limits.b;
  ends_.resize((limits.a >> code_.row_bits) + 1);
  chunk_ = threads <= few_threads ? PairChunk::large : PairChunk::small;
  for (const auto& buckets : buckets_.all()) clear(*buckets);
}

void PairSort::clear(PairBuckets& buckets) const { buckets.clear(ends_.size(), code_, chunk_); }

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

template <class Code>
void PairSort::sort_codes(const Executor& executor, PairRoom& room, Pair* out) {
  constexpr std::size_t buckets_per_task = 16;
  Pool<BucketMemory<Code>> memories;  // not kept: a bucket may have most of the pairs
  executor.parallel_for((ends_.size() + buckets_per_task - 1) / buckets_per_task, [&](std::size_t task) {
    const typename Pool<BucketMemory<Code>>::Loan loan(memories);
    BucketMemory<Code>& memory = *loan;
    const std::size_t last = std::min(ends_.size(), (task + 1) * buckets_per_task);
    for (std::size_t k = task * buckets_per_task; k < last; ++k) {
      const auto begin = static_cast<std::size_t>(k == 0 ? 0 : ends_[k - 1]);
      const auto end = static_cast<std::size_t>(ends_[k]);
      if (end == begin) continue;
      memory.parts.clear();
      for (const auto& buckets : buckets_.all()) {
        buckets->for_each_part<Code>(k, [&memory](std::span<const Code> part) { memory.parts.push_back(part); });
      }
      if (k + 1 < last) prefetch_all(buckets_.all().front()->open_part<Code>(k + 1));
      room.reach(end);
      sort_bucket<Code>({code_, static_cast<std::uint32_t>(k << code_.row_bits), {out + begin, end - begin}}, limit_b_,
                        memory);
    }
  });
  passing_bytes_ = 0;
  for (const auto& memory : memories.all()) passing_bytes_ += memory->bytes();
}

Pair* PairSort::sort(const Executor& executor, PairRoom& room) {
  Pair* const out = room.all_in_turns(ends_.empty() ? 0 : static_cast<std::size_t>(ends_.back()));
  if (code_.narrow()) {
    sort_codes<std::int32_t>(executor, room, out);
  } else {
    sort_codes<std::int64_t>(executor, room, out);
  }
  return out;
}

std::size_t PairSort::bytes() const {
  std::size_t result = ends_.capacity() * sizeof(std::uint64_t) + passing_bytes_;
  for (const auto& buckets : buckets_.all()) result += buckets->bytes();
  return result;
}

}  // namespace graze::detail
