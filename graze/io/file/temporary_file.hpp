// SPDX-License-Identifier: MIT
// Files that are to take another's place when they are complete, and are removed otherwise.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

#include <graze/io/file/open_file_lock.hpp>

namespace graze::io {

/// A new file in a folder, called `.graze-<16 hex digits>.tmp`, which is removed when this goes and nothing has renamed
/// it. The system keeps a lock on it as long as this lives, by which others know that it is in use.
class TemporaryFile {
 public:
  /// Opens the file; whether that worked is the stream's to say. Files of this name in the folder that nobody has a
  /// lock on, as a program leaves them that was killed, are removed first.
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
  std::size_t slot_;  // in the list for remove_temporary_files
  std::ofstream out_;
};

/// Removes the temporary files that are being written. For handlers of signals that are about to end the program:
/// async-signal-safe.
void remove_temporary_files() noexcept;

}  // namespace graze::io
