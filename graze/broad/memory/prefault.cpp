// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include <graze/broad/memory/prefault.hpp>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace graze::detail {

#if defined(__linux__) && defined(MADV_POPULATE_WRITE)

namespace {

constexpr std::size_t bytes_per_task = std::size_t{1} << 20U;
constexpr std::size_t least = 4 * bytes_per_task;

}  // namespace

void prefault(void* memory, std::size_t bytes) {
  // Whole pages only: others are shared with neighbouring memory.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  if (std::align(page, page, memory, bytes) == nullptr) return;
  madvise(memory, bytes - bytes % page, MADV_POPULATE_WRITE);
}

void prefault(void* memory, std::size_t bytes, const Executor& executor) {
  if (bytes < least || executor.concurrency() < 2) return;
  // Parts end at page boundaries, except the last.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  if (std::align(page, bytes_per_task, memory, bytes) == nullptr) return;
  executor.parallel_for((bytes + bytes_per_task - 1) / bytes_per_task, [&](std::size_t k) {
    const std::size_t begin = k * bytes_per_task;
    prefault(static_cast<char*>(memory) + begin, std::min(bytes_per_task, bytes - begin));
  });
}

#else

void prefault(void* /*memory*/, std::size_t /*bytes*/) {}
void prefault(void* /*memory*/, std::size_t /*bytes*/, const Executor& /*executor*/) {}

#endif

}  // namespace graze::detail
