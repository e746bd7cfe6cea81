// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include <graze/broad/populate.hpp>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace graze::detail {

#if defined(__linux__) && defined(MADV_POPULATE_WRITE)

namespace {

constexpr std::size_t part = std::size_t{1} << 20U;
constexpr std::size_t least = 4 * part;

}  // namespace

void populate(void* memory, std::size_t bytes, const Executor& executor) {
  if (bytes < least || executor.concurrency() < 2) return;
  // Whole pages only: others share theirs with the neighbours.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  void* first = memory;
  if (std::align(page, part, first, bytes) == nullptr) return;
  bytes -= bytes % page;
  executor.parallel_for((bytes + part - 1) / part, [&](std::size_t k) {
    const std::size_t begin = k * part;
    madvise(static_cast<char*>(first) + begin, std::min(part, bytes - begin), MADV_POPULATE_WRITE);
  });
}

#else

void populate(void* /*memory*/, std::size_t /*bytes*/, const Executor& /*executor*/) {}

#endif

}  // namespace graze::detail
