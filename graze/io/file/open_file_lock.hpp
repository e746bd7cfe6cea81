// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

namespace graze::io {

/// A lock on a file: an advisory one (flock), or on Windows an open handle beside which others may not be opened for
/// writing. The system releases it when the process ends for any reason. On systems without such locks, none is ever
/// held.
class OpenFileLock {
 public:
  OpenFileLock() = default;

  /// Creates a new file and locks it. Holds no lock if the file exists or cannot be created or locked.
  static OpenFileLock of_new(const std::filesystem::path& path);

  /// Locks an existing regular file of this user. Holds no lock if there is no such file or another process has locked
  /// it.
  static OpenFileLock of_existing(const std::filesystem::path& path);

  OpenFileLock(OpenFileLock&& other) noexcept : file_(std::exchange(other.file_, none)) {}
  OpenFileLock& operator=(OpenFileLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  OpenFileLock(const OpenFileLock&) = delete;
  OpenFileLock& operator=(const OpenFileLock&) = delete;
  ~OpenFileLock();

  bool is_held() const { return file_ != none; }

 private:
  using File = std::intptr_t;  // a file descriptor, or a HANDLE
  static constexpr File none = -1;

  explicit OpenFileLock(File file) : file_(file) {}

  File file_ = none;
};

}  // namespace graze::io
