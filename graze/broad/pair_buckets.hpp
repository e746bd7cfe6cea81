// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/buffer.hpp>
#include <graze/broad/pair.hpp>

namespace graze::detail {

/// How many pairs a chunk holds: each bucket has one that is not full. Where many threads have buckets of their own,
/// large ones would take more memory than the pairs.
enum class PairChunk : std::uint32_t { large = 256, small = 64 };

/// Pairs in buckets of neighbouring first indices: each bucket a chain of chunks, so that nobody has to know beforehand
/// how many pairs it gets. Keeps its memory, unless chunks become of another size.
class PairBuckets {
 public:
  /// Forgets all pairs. From now on the bucket of a pair is a >> shift, which is less than `buckets`.
  void clear(std::size_t buckets, std::uint32_t shift, PairChunk chunk = PairChunk::large);

  /// How many buckets there are: none at first.
  std::size_t buckets() const { return next_.size(); }

  void add(std::span<const Pair> pairs);

  std::size_t count(std::size_t bucket) const;

  /// The part of a bucket that is written to, the first that for_each_part gives.
  std::span<const Pair> open_part(std::size_t bucket) const {
    return {begins_[bucket], static_cast<std::size_t>(next_[bucket] - begins_[bucket])};
  }

  /// Calls use(pairs) for each part of a bucket, in no order that matters.
  template <class Use>
  void for_each_part(std::size_t bucket, const Use& use) const {
    const std::span<const Pair> last = open_part(bucket);
    if (!last.empty()) use(last);
    for (std::uint32_t part = full_parts_[bucket]; part != no_part; part = parts_[part].previous) {
      use(parts_[part].pairs);
    }
  }

  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t no_part = 0xFFFF'FFFF;

  struct Part {
    std::span<const Pair> pairs;
    std::uint32_t previous;  // of the same bucket
  };

  struct Slab {
    Buffer<Pair> memory;
    Pair* first = nullptr;
    std::size_t chunks = 0;
  };

  void add_slab(std::size_t chunks);
  Pair* take_chunks(std::size_t count);
  void close(std::size_t bucket);

  std::uint32_t shift_ = 0;
  std::size_t chunk_ = static_cast<std::size_t>(PairChunk::large);  // pairs
  std::vector<Pair*> next_;                                         // where the next pair of a bucket goes
  std::vector<Pair*> begins_;                                       // of what is not yet in a part
  std::vector<std::uint32_t> full_parts_;                           // the last one of each bucket
  std::vector<Part> parts_;
  std::vector<Slab> slabs_;
  std::size_t slab_ = 0;   // that chunks are taken from
  std::size_t taken_ = 0;  // of its chunks
};

}  // namespace graze::detail
