// SPDX-License-Identifier: MIT
#include <cstdint>
#include <new>

#include <graze/broad/buffer.hpp>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace graze::detail {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t large_page = std::size_t{1} << 21U;

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes < large_page ? cache_line : large_page};
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  void* const memory = ::operator new(bytes, alignment_of(bytes));
  // Boxes are scattered over tens of megabytes: with pages of 4 KiB every second access would look up its page anew.
  if (bytes >= large_page) advise_large_pages(memory, bytes);
  return memory;
}

void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#ifdef __linux__
  const auto first = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t before = (large_page - first % large_page) % large_page;  // to where a large page can begin
  if (bytes < before + large_page) return;
  // Only advice, so nothing is lost where it is refused.
  madvise(static_cast<char*>(memory) + before, bytes - before, MADV_HUGEPAGE);
#endif
}

void release_pages(void* memory, std::size_t bytes) noexcept { ::operator delete(memory, alignment_of(bytes)); }

}  // namespace graze::detail
