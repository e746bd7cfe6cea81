// SPDX-License-Identifier: MIT
#include <bit>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/kept_blocks.hpp>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace graze::detail {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t large_page = std::size_t{1} << 21U;

// Under an address sanitizer, blocks are not reused, so that it sees every use and release.
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define GRAZE_ADDRESS_SANITIZER
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define GRAZE_ADDRESS_SANITIZER
#endif

/// Without kept blocks, allocation takes up to a fifth of the time of a call.
#ifdef GRAZE_ADDRESS_SANITIZER
constexpr std::size_t most_kept = 0;
constexpr std::size_t used_per_kept = std::numeric_limits<std::size_t>::max();
#else
constexpr std::size_t most_kept = std::size_t{64} << 20U;
constexpr std::size_t used_per_kept = 2;
#endif
constexpr std::size_t least_kept = std::size_t{1} << 15U;

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes < large_page ? cache_line : large_page};
}

/// The size of the block for a request: at most a quarter more, so that similar requests can share blocks.
std::size_t block_size_for(std::size_t bytes) {
  if (bytes < least_kept) return bytes;
  const std::size_t step = std::bit_floor(bytes) / 4;
  return (bytes + step - 1) / step * step;
}

void release_block(void* memory, std::size_t bytes) noexcept { ::operator delete(memory, alignment_of(bytes)); }

/// Never destroyed, because buffers may be released during program exit.
KeptBlocks& kept_blocks() {
  static KeptBlocks& blocks = *new KeptBlocks(most_kept, used_per_kept, release_block);
  return blocks;
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  bytes = block_size_for(bytes);
  if (bytes >= least_kept) {
    if (void* const kept = kept_blocks().take(bytes)) return kept;
  }
  void* const memory = ::operator new(bytes, alignment_of(bytes));
  advise_large_pages(memory, bytes);
  if (bytes >= least_kept) kept_blocks().note_new(bytes);
  return memory;
}

/// Boxes are scattered over tens of megabytes: with 4 KiB pages, every second access would miss the TLB.
void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  if (std::align(large_page, large_page, memory, bytes) == nullptr) return;
  madvise(memory, bytes - bytes % large_page, MADV_HUGEPAGE);
#endif
}

void release_pages(void* memory, std::size_t bytes) noexcept {
  bytes = block_size_for(bytes);
  if (bytes >= least_kept) {
    kept_blocks().keep(memory, bytes);
  } else {
    release_block(memory, bytes);
  }
}

}  // namespace graze::detail
