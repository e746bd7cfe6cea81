// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <graze/broad/executor.hpp>
#include <graze/math/platform/export.hpp>

namespace graze::detail {

/// Makes the system map and clear the pages of memory that is about to be written, on all threads of an executor:
/// otherwise the first writer would wait for it page by page, alone. Keeps the content. A hint only: does nothing with
/// one thread, for less than a few megabytes, or if the system does not support it.
GRAZE_EXPORT void prefault(void* memory, std::size_t bytes, const Executor& executor);

/// The same on the calling thread, for the whole pages of any memory. Pays if few enough pages are requested that they
/// are written while still cached.
GRAZE_EXPORT void prefault(void* memory, std::size_t bytes);

}  // namespace graze::detail
