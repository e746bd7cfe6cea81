// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace graze::io {

/// Writes a file whole or not at all: `write` fills a temporary file in the same folder, which takes the target's place
/// only when all has been written (temporary_file.hpp). If `write` throws or the disk is full, an existing target stays
/// as it was and no temporary file remains. A symbolic link is followed, an existing file's permissions are kept; a
/// pipe, a device or an open stream by its name (/dev/stdout) is written directly, at its end. Throws OutputError, and
/// whatever `write` throws.
void write_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace graze::io
