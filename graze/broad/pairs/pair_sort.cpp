// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/bucket_sort.hpp>
#include <graze/broad/pairs/pair_sort.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t most_buckets = 1024;
constexpr std::uint32_t least_row_bits = 7;
constexpr std::size_t buckets_per_task = 16;

}  // namespace

void PairSort::begin(const PairLimits& limits, std::size_t threads) {
  constexpr std::size_t few_threads = 4;
  remember_last(limits);
  code_.row_bits = std::max(least_row_bits, static_cast<std::uint32_t>(std::bit_width(limits.a / most_buckets)));
  code_.second_bits = static_cast<std::uint32_t>(std::bit_width(std::max<std::size_t>(limits.b, 1) - 1));
  if (!code_.narrow()) code_.second_bits = 32;
  limits_ = limits;
  ends_.assign((limits.a >> code_.row_bits) + 1, 0);
  chunk_ = threads <= few_threads ? PairChunk::large : PairChunk::small;
  loans_.clear();
  for (const auto& buckets : buckets_.all()) clear(*buckets);
}

/// Must be called before any other state is cleared.
void PairSort::remember_last(const PairLimits& limits) {
  last_ = {};
  if (!(limits == limits_) || ends_.empty()) return;
  last_.count = static_cast<std::size_t>(ends_.back());
  for (std::size_t k = 0; k < last_.firsts.size(); ++k) {
    const auto end = static_cast<std::uint64_t>(shares()[k] * static_cast<double>(last_.count));
    const auto past = std::upper_bound(ends_.begin(), ends_.end(), end);
    last_.firsts[k] = static_cast<std::uint32_t>(static_cast<std::size_t>(past - ends_.begin()) << code_.row_bits);
  }
}

/// The first range of pairs is stored where the second is sorted to, the second where the rest is sorted to; so each is
/// as large as the codes, compared with pairs, permit.
std::array<double, 2> PairSort::ideal_shares() const {
  const double ratio = static_cast<double>(code_bytes()) / sizeof(Pair);
  const double first = 1 / (1 + ratio + ratio * ratio);
  return {first, first + first * ratio};
}

std::array<double, 2> PairSort::shares() const {
  constexpr double wanted = 0.97;  // the rest is reserve for low forecasts and incomplete chunks
  const std::array<double, 2> ideal = ideal_shares();
  return {wanted * ideal[0], wanted * ideal[1]};
}

void PairSort::wait_in(PairSink& room, const PairForecast& forecast) {
  constexpr std::size_t many = 8;  // bytes of codes per index
  if (forecast.count * code_bytes() <= many * (limits_.a + limits_.b)) return;
  const std::span<Pair> ahead = room.ahead(forecast.count);
  if (ahead.empty()) return;
  ahead_size_ = ahead.size();
  const auto place = [&](double share) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(forecast.count)), ahead.size());
  };
  const std::array<double, 2> ideal = ideal_shares();
  ahead_firsts_ = {place(ideal[0]), place(ideal[1])};
  const std::array<std::size_t, 2> lasts = {ahead_firsts_[1], place(1)};
  for (std::size_t k = 0; k < lasts.size(); ++k) {
    const std::span<Pair> part = ahead.subspan(ahead_firsts_[k], lasts[k] - ahead_firsts_[k]);
    loans_.ahead[k].memory.give(std::as_writable_bytes(part));
    const std::size_t buckets = (forecast.firsts[k] >> code_.row_bits) / buckets_per_task * buckets_per_task;
    loans_.ahead[k].buckets_end = std::min(buckets, ends_.size());
  }
}

/// Whether sorting overwrites only memory that no unsorted pairs occupy.
bool PairSort::is_as_forecast() const {
  if (ends_.back() > ahead_size_) return false;
  for (std::size_t k = 0; k < ahead_firsts_.size(); ++k) {
    const std::size_t end = loans_.ahead[k].buckets_end;
    if (end > 0 && ends_[end - 1] > ahead_firsts_[k]) return false;
  }
  return true;
}

void PairSort::clear(PairBuckets& buckets) { buckets.clear(ends_.size(), code_, chunk_, &loans_); }

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
void PairSort::sort_codes(const Executor& executor, PairSink& room, Pair* out) {
  Pool<BucketMemory<Code>> memories;  // temporary: a bucket may contain most of the pairs
  const auto sort_some = [&](std::size_t task) {
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
      sort_bucket<Code>({code_, static_cast<std::uint32_t>(k << code_.row_bits), {out + begin, end - begin}}, limits_.b,
                        memory);
    }
  };
  const std::size_t tasks = (ends_.size() + buckets_per_task - 1) / buckets_per_task;
  std::size_t done = 0;
  const auto sort_until = [&](std::size_t end) {
    if (end == done) return;
    if (executor.concurrency() > 1) {
      room.reach_by_all(static_cast<std::size_t>(ends_[std::min(ends_.size(), end * buckets_per_task) - 1]));
    }
    executor.parallel_for(end - done, [&](std::size_t task) { sort_some(done + task); });
    done = end;
  };
  for (const PairLoans::Ahead& ahead : loans_.ahead) sort_until(std::max(done, ahead.buckets_end / buckets_per_task));
  sort_until(tasks);  // where the others were stored
  passing_bytes_ = 0;
  for (const auto& memory : memories.all()) passing_bytes_ += memory->bytes();
}

Pair* PairSort::sort(const Executor& executor, PairSink& room) {
  const std::size_t count = ends_.empty() ? 0 : static_cast<std::size_t>(ends_.back());
  const bool some_wait = loans_.ahead[0].buckets_end > 0 || loans_.ahead[1].buckets_end > 0;
  if (some_wait && !is_as_forecast()) {
    for (const auto& buckets : buckets_.all()) buckets->leave_ahead();
    loans_.clear();
  }
  Pair* const out = room.all_in_turns(count);
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
