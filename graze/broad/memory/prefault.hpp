// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <graze/broad/executor.hpp>

namespace graze::detail {

/// Has the system find and clear the pages of memory that is about to be written, by all threads of an executor: who
/// writes first would wait for it page by page, alone. What was written before stays. Only advice: does nothing for one
/// thread, for memory of less than a few megabytes, or where the system cannot.
void prefault(void* memory, std::size_t bytes, const Executor& executor);

/// The same on the calling thread, for the whole pages of any memory. That pays where few enough are asked for at a
/// time that they are written while they are in a cache.
void prefault(void* memory, std::size_t bytes);

}  // namespace graze::detail
