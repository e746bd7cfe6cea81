// SPDX-License-Identifier: MIT
// Files that replace another file when they are complete, and are removed otherwise.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

#include <graze/io/file/open_file_lock.hpp>
#include <graze/math/platform/export.hpp>

namespace graze::io {

/// A new file in a folder, named `.graze-<16 hex digits>.tmp`. The destructor removes it unless it was renamed. It
/// stays locked during its lifetime, which tells other processes that it is in use.
class TemporaryFile {
 public:
  /// Opens the file; check `stream()` for success. First removes files of this naming pattern in the folder that nobody
  /// holds a lock on: killed programs leave them behind.
  explicit TemporaryFile(const std::filesystem::path& folder);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  std::ofstream& stream() { return out_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  OpenFileLock lock_;
  std::size_t slot_;  // in the list that remove_temporary_files reads
  std::ofstream out_;
};

/// Removes the temporary files being written. For handlers of signals that end the program: async-signal-safe.
GRAZE_EXPORT void remove_temporary_files() noexcept;

}  // namespace graze::io
