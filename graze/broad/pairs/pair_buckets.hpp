// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/scratch_arena.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_code.hpp>

namespace graze::detail {

/// The size of a chunk in bytes. Each bucket has one incomplete chunk; if many threads have buckets of their own, large
/// ones would take more memory than the pairs.
enum class PairChunk : std::uint32_t { large = 2048, small = 512 };

/// Borrowed memory for pairs until they are sorted.
struct PairLoans {
  /// For some of the first buckets.
  struct Ahead {
    ScratchArena memory;
    /// End of the range of buckets stored here; those of an earlier range may be stored there.
    std::size_t buckets_end = 0;
  };

  ScratchArena idle;  ///< For all buckets.
  std::array<Ahead, 2> ahead;

  void clear() {
    idle.clear();
    for (Ahead& one : ahead) {
      one.memory.clear();
      one.buckets_end = 0;
    }
  }
};

/// Pairs as codes in buckets of neighbouring first indices. Each bucket is a chain of chunks, so that the number of its
/// pairs need not be known in advance. Keeps its memory, unless the chunk size changes.
class PairBuckets {
 public:
  /// Removes all pairs. New pairs go to this many buckets, as codes of this form, also in borrowed memory while it
  /// lasts.
  void clear(std::size_t buckets, PairCode code, PairChunk chunk = PairChunk::large, PairLoans* loans = nullptr);

  /// The number of buckets; none initially.
  std::size_t buckets() const { return next_.size(); }

  void add(std::span<const Pair> pairs);

  std::size_t count(std::size_t bucket) const;

  /// Moves the content of memory that was lent for some buckets only. No pairs may be added afterwards.
  void leave_ahead();

  /// The incomplete part of a bucket, the first that for_each_part visits.
  template <class Code>
  std::span<const Code> open_part(std::size_t bucket) const {
    return codes_of<Code>({begins_[bucket], next_[bucket]});
  }

  /// Calls use(codes) for each part of a bucket, in unspecified order. Code must match the form of the codes.
  template <class Code, class Use>
  void for_each_part(std::size_t bucket, const Use& use) const {
    const std::span<const Code> last = open_part<Code>(bucket);
    if (!last.empty()) use(last);
    for (std::uint32_t part = full_parts_[bucket]; part != no_part; part = parts_[part].previous) {
      use(codes_of<Code>(parts_[part]));
    }
  }

  std::size_t bytes() const;

 private:
  static constexpr std::uint32_t no_part = 0xFFFF'FFFF;

  struct Part {
    std::byte* begin;
    std::byte* end;
    std::uint32_t previous = no_part;  // of the same bucket
  };

  struct Slab {
    Buffer<std::byte> memory;
    std::byte* first = nullptr;
    std::size_t chunks = 0;
  };

  /// The rest of a borrowed piece.
  struct Rest {
    ScratchArena* lender = nullptr;  // null once it is exhausted
    std::byte* next = nullptr;
    std::byte* end = nullptr;
  };

  template <class Code>
  static std::span<const Code> codes_of(const Part& part) {
    return {reinterpret_cast<const Code*>(part.begin), reinterpret_cast<const Code*>(part.end)};
  }

  template <class Code>
  void add_codes(std::span<const Pair> pairs);
  void add_slab(std::size_t chunks);
  std::byte* take_chunks(std::size_t count);
  std::byte* take_scratch(Rest& rest) const;
  std::byte* take_chunk(std::size_t bucket);
  void move_home(Part& part);
  void close(std::size_t bucket);

  PairCode code_;
  std::size_t chunk_ = static_cast<std::size_t>(PairChunk::large);
  std::vector<std::byte*> next_;           // where the next pair of a bucket goes
  std::vector<std::byte*> begins_;         // of the incomplete part
  std::vector<std::uint32_t> full_parts_;  // the last one of each bucket
  std::vector<Part> parts_;
  std::vector<Slab> slabs_;
  std::size_t slab_ = 0;   // from which chunks are taken
  std::size_t taken_ = 0;  // of its chunks
  PairLoans* loans_ = nullptr;
  Rest idle_;
  std::array<Rest, 2> ahead_;
};

}  // namespace graze::detail
