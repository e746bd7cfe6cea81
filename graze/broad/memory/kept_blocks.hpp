// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace graze::detail {

/// Blocks of memory that nobody uses at present, kept for the next one who needs as much: what comes from the system
/// has to be cleared page by page. Holds a few blocks, of a limited size in all, and gives up those for which there was
/// no use for long. A program that works with much may keep much: the limit is a share of what is in use, where that is
/// more. Safe to use from many threads.
class KeptBlocks {
 public:
  using Release = void (*)(void* block, std::size_t bytes) noexcept;

  /// How many times blocks are asked for until one that none of them needed is given up.
  static constexpr std::uint64_t patience = 1024;

  /// Keeps at most `most_bytes`, or one byte for `used_per_kept` that are in use; what is given up goes to `release`.
  KeptBlocks(std::size_t most_bytes, std::size_t used_per_kept, Release release) noexcept
      : most_bytes_(most_bytes), used_per_kept_(used_per_kept), release_(release) {}
  KeptBlocks(const KeptBlocks&) = delete;
  KeptBlocks& operator=(const KeptBlocks&) = delete;
  ~KeptBlocks();

  /// A block of just so many bytes, or null.
  void* take(std::size_t bytes) noexcept;

  /// A new block of so many bytes is in use.
  void note_new(std::size_t bytes) noexcept;

  /// Nobody uses the block any more. Keeps it, or gives it up, or others for it.
  void keep(void* block, std::size_t bytes) noexcept;

  /// All that is held now.
  std::size_t bytes() const noexcept;

 private:
  struct Block {
    void* memory;
    std::size_t bytes;
    std::uint64_t kept_at;
  };

  std::size_t most() const noexcept { return std::max(most_bytes_, used_ / used_per_kept_); }
  Block remove(std::size_t place) noexcept;
  void release_oldest() noexcept;

  const std::size_t most_bytes_;
  const std::size_t used_per_kept_;
  const Release release_;
  mutable std::mutex mutex_;
  std::array<Block, 64> blocks_{};  // the oldest first
  std::size_t count_ = 0;
  std::size_t bytes_ = 0;
  std::size_t used_ = 0;  // bytes of blocks that somebody uses
  std::uint64_t clock_ = 0;
};

}  // namespace graze::detail
