// SPDX-License-Identifier: MIT
#include <graze/io/file/open_file_lock.hpp>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#define GRAZE_HAS_FLOCK 0
#elif __has_include(<sys/file.h>) && __has_include(<unistd.h>) && !defined(__EMSCRIPTEN__)
#define GRAZE_HAS_FLOCK 1
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#else
#define GRAZE_HAS_FLOCK 0
#endif

namespace graze::io {

#if GRAZE_HAS_FLOCK

namespace {

/// The file of that descriptor if it could be locked and still has a name: another process may have removed it between
/// opening and locking.
int locked(int file) {
  if (file == -1) return -1;
  struct stat status {};
  const bool is_good = flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &status) == 0 && status.st_nlink > 0 &&
                       S_ISREG(status.st_mode) && status.st_uid == geteuid();
  if (is_good) return file;
  close(file);
  return -1;
}

}  // namespace

OpenFileLock OpenFileLock::of_new(const std::filesystem::path& path) {
  constexpr mode_t usual = 0666;
  return OpenFileLock(locked(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usual)));
}

OpenFileLock OpenFileLock::of_existing(const std::filesystem::path& path) {
  return OpenFileLock(locked(open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)));
}

OpenFileLock::~OpenFileLock() {
  if (is_held()) close(static_cast<int>(file_));
}

#elif defined(_WIN32)

namespace {

constexpr DWORD readable_and_removable = FILE_SHARE_READ | FILE_SHARE_DELETE;

std::intptr_t opened(const std::filesystem::path& path, DWORD access, DWORD others, DWORD creation) {
  return reinterpret_cast<std::intptr_t>(
      CreateFileW(path.c_str(), access, others, nullptr, creation, FILE_ATTRIBUTE_NORMAL, nullptr));
}

}  // namespace

OpenFileLock OpenFileLock::of_new(const std::filesystem::path& path) {
  return OpenFileLock(opened(path, GENERIC_WRITE, readable_and_removable | FILE_SHARE_WRITE, CREATE_NEW));
}

OpenFileLock OpenFileLock::of_existing(const std::filesystem::path& path) {
  return OpenFileLock(opened(path, GENERIC_READ, readable_and_removable, OPEN_EXISTING));
}

OpenFileLock::~OpenFileLock() {
  if (is_held()) CloseHandle(reinterpret_cast<HANDLE>(file_));
}

#else

OpenFileLock OpenFileLock::of_new(const std::filesystem::path&) { return {}; }
OpenFileLock OpenFileLock::of_existing(const std::filesystem::path&) { return {}; }
OpenFileLock::~OpenFileLock() = default;

#endif

}  // namespace graze::io
