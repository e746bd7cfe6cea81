// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <utility>

namespace graze::io {

/// An advisory lock (flock) on a file. The system releases it when the process ends for any reason. On systems without
/// such locks, none is ever held.
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
  static constexpr int none = -1;

  explicit OpenFileLock(int file) : file_(file) {}

  int file_ = none;
};

}  // namespace graze::io
