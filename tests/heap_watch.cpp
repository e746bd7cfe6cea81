// SPDX-License-Identifier: MIT
#include "heap_watch.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace graze::test {

thread_local HeapWatch heap_watch;

namespace {

void* take_if_there_is_some(std::size_t bytes, std::size_t alignment = 1) noexcept {
  if (heap_watch.grants_left == 0) return nullptr;
  if (heap_watch.grants_left != HeapWatch::no_end) --heap_watch.grants_left;
  ++heap_watch.requests;
  heap_watch.bytes += bytes;
  if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes == 0 ? 1 : bytes);
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
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
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
