// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <utility>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/pair_buckets.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t line_bytes = 64;
static_assert(ScratchArena::alignment % static_cast<std::size_t>(PairChunk::large) == 0);

}  // namespace

/// Adds a slab for at least `chunks` chunks and an eighth of all existing ones, in whole large pages if that is as
/// much: doubling would waste up to half of the memory. Chunks are aligned to their size, so that an address shows
/// whether it is the last of its chunk.
void PairBuckets::add_slab(std::size_t chunks) {
  constexpr std::size_t page = std::size_t{1} << 21U;
  std::size_t all = 0;
  for (const Slab& other : slabs_) all += other.chunks;
  std::size_t bytes = (std::max(chunks, all / 8) + 1) * chunk_;  // one for aligning the first
  if (all * chunk_ >= page) bytes = (bytes + page - 1) / page * page;
  Slab slab;
  slab.memory.require(bytes);
  const std::size_t beyond = reinterpret_cast<std::uintptr_t>(slab.memory.data()) % chunk_;
  slab.first = slab.memory.data() + (beyond == 0 ? 0 : chunk_ - beyond);
  slab.chunks = (bytes - static_cast<std::size_t>(slab.first - slab.memory.data())) / chunk_;
  slabs_.push_back(std::move(slab));
}

std::byte* PairBuckets::take_chunks(std::size_t count) {
  while (slab_ < slabs_.size() && taken_ + count > slabs_[slab_].chunks) {
    ++slab_;
    taken_ = 0;
  }
  if (slab_ == slabs_.size()) add_slab(count);
  std::byte* const result = slabs_[slab_].first + taken_ * chunk_;
  taken_ += count;
  return result;
}

std::byte* PairBuckets::take_scratch(Rest& rest) const {
  if (rest.next == rest.end) {
    if (rest.lender == nullptr) return nullptr;
    rest.next = rest.lender->take();
    if (rest.next == nullptr) {
      rest = {};
      return nullptr;
    }
    rest.end = rest.next + ScratchArena::piece;
  }
  std::byte* const result = rest.next;
  rest.next += chunk_;
  return result;
}

std::byte* PairBuckets::take_chunk(std::size_t bucket) {
  if (loans_ != nullptr) {
    for (std::size_t k = 0; k < ahead_.size(); ++k) {
      if (bucket >= loans_->ahead[k].buckets_end) continue;
      if (std::byte* const lent = take_scratch(ahead_[k])) return lent;
      break;
    }
    if (std::byte* const lent = take_scratch(idle_)) return lent;
  }
  return take_chunks(1);
}

void PairBuckets::clear(std::size_t buckets, PairCode code, PairChunk chunk, PairLoans* loans) {
  if (chunk_ != static_cast<std::size_t>(chunk)) slabs_.clear();
  chunk_ = static_cast<std::size_t>(chunk);
  code_ = code;
  loans_ = loans;
  idle_ = {loans == nullptr ? nullptr : &loans->idle};
  for (std::size_t k = 0; k < ahead_.size(); ++k) ahead_[k] = {loans == nullptr ? nullptr : &loans->ahead[k].memory};
  slab_ = 0;
  taken_ = 0;
  parts_.clear();
  next_.resize(buckets);
  full_parts_.assign(buckets, no_part);
  std::byte* const first = take_chunks(buckets);
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    // Staggered within their chunks: otherwise their lines would compete for a few sets of the caches.
    next_[bucket] = first + bucket * chunk_ + bucket * line_bytes % chunk_;
  }
  begins_ = next_;
}

/// Records a full chunk as a part, and starts another.
void PairBuckets::close(std::size_t bucket) {
  parts_.push_back({begins_[bucket], next_[bucket], full_parts_[bucket]});
  full_parts_[bucket] = static_cast<std::uint32_t>(parts_.size() - 1);
  begins_[bucket] = next_[bucket] = take_chunk(bucket);
}

template <class Code>
void PairBuckets::add_codes(std::span<const Pair> pairs) {
  const std::uintptr_t within_chunk = chunk_ - 1;
  const auto add_one = [this, within_chunk, code = code_](const Pair& pair) {
    const std::size_t bucket = code.bucket_of(pair);
    std::byte*& next = next_[bucket];
    prefetch_to_write(next + line_bytes);
    *reinterpret_cast<Code*>(next) = code.of<Code>(pair);
    next += sizeof(Code);
    if ((reinterpret_cast<std::uintptr_t>(next) & within_chunk) == 0) [[unlikely]]
      close(bucket);
  };
  // Alternates between four positions: neighbours are often of the same bucket, and each would wait for the one before.
  const std::size_t quarter = pairs.size() / 4;
  for (std::size_t k = 0; k < quarter; ++k) {
    for (std::size_t place = 0; place < 4; ++place) add_one(pairs[place * quarter + k]);
  }
  for (const Pair& pair : pairs.subspan(4 * quarter)) add_one(pair);
}

void PairBuckets::add(std::span<const Pair> pairs) {
  if (code_.narrow()) {
    add_codes<std::int32_t>(pairs);
  } else {
    add_codes<std::int64_t>(pairs);
  }
}

std::size_t PairBuckets::count(std::size_t bucket) const {
  std::size_t bytes = static_cast<std::size_t>(next_[bucket] - begins_[bucket]);
  for (std::uint32_t part = full_parts_[bucket]; part != no_part; part = parts_[part].previous) {
    bytes += static_cast<std::size_t>(parts_[part].end - parts_[part].begin);
  }
  return bytes / (code_.narrow() ? sizeof(std::int32_t) : sizeof(std::int64_t));
}

void PairBuckets::move_home(Part& part) {
  const auto& ahead = loans_->ahead;
  const auto has_it = [&part](const PairLoans::Ahead& one) { return one.memory.has(part.begin); };
  if (std::none_of(ahead.begin(), ahead.end(), has_it)) return;
  std::byte* const home = take_chunks(1);
  part.end = std::copy(part.begin, part.end, home);
  part.begin = home;
}

void PairBuckets::leave_ahead() {
  if (loans_ == nullptr) return;
  for (Part& part : parts_) move_home(part);
  for (std::size_t bucket = 0; bucket < next_.size(); ++bucket) {
    Part open{begins_[bucket], next_[bucket]};
    move_home(open);
    begins_[bucket] = open.begin;
    next_[bucket] = open.end;
  }
}

std::size_t PairBuckets::bytes() const {
  std::size_t result = (next_.capacity() + begins_.capacity()) * sizeof(void*) + slabs_.capacity() * sizeof(Slab) +
                       full_parts_.capacity() * sizeof(std::uint32_t) + parts_.capacity() * sizeof(Part);
  for (const Slab& slab : slabs_) result += slab.memory.bytes();
  return result;
}

}  // namespace graze::detail
