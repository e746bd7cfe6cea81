// SPDX-License-Identifier: MIT
#include <cstdint>
#include <utility>

#include <graze/broad/pair_buckets.hpp>
#include <graze/broad/prefetch.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t pairs_per_line = 64 / sizeof(Pair);

}

/// Chunks begin at multiples of their size, so that the place of a pair tells whether it is the last of its chunk.
Pair* PairBuckets::Slab::first() {
  constexpr std::size_t size = chunk * sizeof(Pair);
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  return memory.data() + (size - address % size) % size / sizeof(Pair);
}

Pair* PairBuckets::take_chunks(std::size_t count) {
  while (slab_ < slabs_.size() && taken_ + count > slabs_[slab_].chunks) {
    ++slab_;
    taken_ = 0;
  }
  if (slab_ == slabs_.size()) {
    Slab slab;
    slab.chunks = count;
    for (const Slab& other : slabs_) slab.chunks += other.chunks;  // twice as much in all
    slab.memory.require((slab.chunks + 1) * chunk);
    slabs_.push_back(std::move(slab));
    taken_ = 0;
  }
  Pair* const result = slabs_[slab_].first() + taken_ * chunk;
  taken_ += count;
  return result;
}

void PairBuckets::clear(std::size_t buckets, std::uint32_t shift) {
  shift_ = shift;
  slab_ = 0;
  taken_ = 0;
  parts_.clear();
  next_.resize(buckets);
  full_parts_.assign(buckets, no_part);
  Pair* const first = take_chunks(buckets);
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    // Not all at the same place of their chunks: their lines would share a few sets of the caches.
    next_[bucket] = first + bucket * chunk + bucket * pairs_per_line % chunk;
  }
  begins_ = next_;
}

/// Makes a part of a chunk that is full, and begins another.
void PairBuckets::close(std::size_t bucket) {
  parts_.push_back({open_part(bucket), full_parts_[bucket]});
  full_parts_[bucket] = static_cast<std::uint32_t>(parts_.size() - 1);
  begins_[bucket] = next_[bucket] = take_chunks(1);
}

void PairBuckets::add(std::span<const Pair> pairs) {
  const auto add_one = [this](const Pair& pair) {
    const std::size_t bucket = pair.a >> shift_;
    Pair*& next = next_[bucket];
    prefetch_to_write(next + pairs_per_line);
    *next++ = pair;
    if (reinterpret_cast<std::uintptr_t>(next) % (chunk * sizeof(Pair)) == 0) [[unlikely]]
      close(bucket);
  };
  // From four places in turns: neighbours are often of one bucket, and each would wait for the one before.
  const std::size_t quarter = pairs.size() / 4;
  for (std::size_t k = 0; k < quarter; ++k) {
    for (std::size_t place = 0; place < 4; ++place) add_one(pairs[place * quarter + k]);
  }
  for (const Pair& pair : pairs.subspan(4 * quarter)) add_one(pair);
}

std::size_t PairBuckets::count(std::size_t bucket) const {
  std::size_t result = 0;
  for_each_part(bucket, [&result](std::span<const Pair> pairs) { result += pairs.size(); });
  return result;
}

std::size_t PairBuckets::bytes() const {
  std::size_t result = (next_.capacity() + begins_.capacity()) * sizeof(void*) +
                       full_parts_.capacity() * sizeof(std::uint32_t) + parts_.capacity() * sizeof(Part);
  for (const Slab& slab : slabs_) result += slab.memory.bytes();
  return result;
}

}  // namespace graze::detail
