// SPDX-License-Identifier: MIT
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
#ifdef __linux__
  // Boxes are scattered over tens of megabytes: with pages of 4 KiB every second access would look up its page anew.
  // Only advice, so nothing is lost where it is refused.
  if (bytes >= large_page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

void release_pages(void* memory, std::size_t bytes) noexcept { ::operator delete(memory, alignment_of(bytes)); }

}  // namespace graze::detail
