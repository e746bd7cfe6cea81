// SPDX-License-Identifier: MIT
#include "heap_watch.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef _WIN32
#include <malloc.h>
#endif

namespace graze::test {

thread_local HeapWatch heap_watch;

namespace {

// Windows has no aligned_alloc, whose memory std::free could release.
#ifdef _WIN32
void* aligned_memory(std::size_t bytes, std::size_t alignment) { return _aligned_malloc(bytes, alignment); }
void release(void* memory, std::align_val_t) { _aligned_free(memory); }
#else
void* aligned_memory(std::size_t bytes, std::size_t alignment) { return std::aligned_alloc(alignment, bytes); }
void release(void* memory, std::align_val_t) { std::free(memory); }
#endif

void* take_if_there_is_some(std::size_t bytes, std::size_t alignment = 1) noexcept {
  if (heap_watch.grants_left == 0) return nullptr;
  if (heap_watch.grants_left != HeapWatch::no_end) --heap_watch.grants_left;
  ++heap_watch.requests;
  heap_watch.bytes += bytes;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes == 0 ? 1 : bytes);
  return aligned_memory((bytes + alignment - 1) / alignment * alignment, alignment);
}

void* take(std::size_t bytes, std::size_t alignment = 1) {
  if (void* const memory = take_if_there_is_some(bytes, alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace
}  // namespace graze::test

void* operator new(std::size_t bytes) { return graze::test::take(bytes); }
void* operator new[](std::size_t bytes) { return graze::test::take(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return graze::test::take_if_there_is_some(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return graze::test::take_if_there_is_some(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return graze::test::take(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return graze::test::take(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t alignment) noexcept { graze::test::release(memory, alignment); }
void operator delete[](void* memory, std::align_val_t alignment) noexcept { graze::test::release(memory, alignment); }
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  graze::test::release(memory, alignment);
}
void operator delete[](void* memory, std::size_t, std::align_val_t alignment) noexcept {
  graze::test::release(memory, alignment);
}
