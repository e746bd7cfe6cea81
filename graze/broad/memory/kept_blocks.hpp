// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace graze::detail {

/// A cache of unused memory blocks: fresh memory must be cleared by the system page by page. Holds a few blocks of
/// limited total size and releases those that have not been needed for long. The limit is a share of what is in use, so
/// a program that works with much may keep much. Thread-safe.
class KeptBlocks {
 public:
  using Release = void (*)(void* block, std::size_t bytes) noexcept;

  /// A block is released after this many requests that did not use it.
  static constexpr std::uint64_t patience = 1024;

  /// Keeps at most `most_bytes`, or one byte for every `used_per_kept` bytes in use if that is more; surplus blocks go
  /// to `release`.
  KeptBlocks(std::size_t most_bytes, std::size_t used_per_kept, Release release) noexcept
      : most_bytes_(most_bytes), used_per_kept_(used_per_kept), release_(release) {}
  KeptBlocks(const KeptBlocks&) = delete;
  KeptBlocks& operator=(const KeptBlocks&) = delete;
  ~KeptBlocks();

  /// A block of exactly this size, or null.
  void* take(std::size_t bytes) noexcept;

  /// Records that a new block of this size is in use.
  void note_new(std::size_t bytes) noexcept;

  /// Returns a block that is no longer used. Keeps it, or releases it or others.
  void keep(void* block, std::size_t bytes) noexcept;

  /// The total size of the kept blocks.
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
  std::size_t used_ = 0;  // bytes of blocks in use
  std::uint64_t clock_ = 0;
};

}  // namespace graze::detail
