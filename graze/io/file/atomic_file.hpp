// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// Writes a file completely or not at all: `write` fills a temporary file in the same folder, which replaces the target
/// once everything has been written (temporary_file.hpp). If `write` throws or the disk is full, an existing target
/// stays unchanged and no temporary file remains. Symbolic links are followed and an existing file's permissions are
/// kept. Pipes, devices and open streams given by name (/dev/stdout) are appended to directly. Throws OutputError, and
/// whatever `write` throws.
GRAZE_EXPORT void write_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace graze::io
