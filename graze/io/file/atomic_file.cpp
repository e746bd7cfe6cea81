// SPDX-License-Identifier: MIT
#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <graze/io/file/atomic_file.hpp>
#include <graze/io/file/temporary_file.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/text/in_quotes.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

OutputError cannot_write(const fs::path& path, std::string_view reason) {
  return OutputError(fmt::format("cannot write {}: {}", in_quotes(utf8_from_path(path)), reason));
}

/// The description of the last system error.
std::string system_reason() {
  const int error = errno;
  return error == 0 ? "the system gives no reason" : std::generic_category().message(error);
}

/// Where a chain of symbolic links ends; the final target need not exist.
fs::path link_target(const fs::path& path) {
  constexpr int longest_chain = 40;  // as in Linux
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target)); ++links) {
    if (links == longest_chain) throw cannot_write(path, "its symbolic links form a loop");
    target = target.parent_path() / fs::read_symlink(target);
  }
  return target;
}

/// /dev/stdout and /dev/fd/3 refer to whatever the process has open, possibly a regular file that others also write to.
bool names_open_stream(const fs::path& path) {
  const std::string name = utf8_from_path(path.lexically_normal());
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// Appends, so that existing content of an open stream's file is kept. For devices and pipes it makes no difference.
void write_directly(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::app);
  if (!out) throw cannot_write(path, system_reason());
  write(out);
  out.close();
  if (!out) throw cannot_write(path, system_reason());
}

/// Moves the temporary file onto the target.
void take_place(TemporaryFile& file, const fs::path& target, const fs::file_status& old) {
  std::ofstream& out = file.stream();
  out.close();
  if (!out) throw cannot_write(target, system_reason() + "; the target is unchanged");
  std::error_code error;
  if (fs::exists(old)) fs::permissions(file.path(), old.permissions(), error);
  if (!error) fs::rename(file.path(), target, error);
  if (error) throw cannot_write(target, error.message() + "; the target is unchanged");
}

/// Replacing a file needs write permission for its folder only, but a write-protected file must not be replaced.
void require_writable(const fs::path& path) {
  errno = 0;
  const std::ofstream probe(path, std::ios::binary | std::ios::app);
  if (!probe) throw cannot_write(path, system_reason());
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  const fs::file_status status = fs::status(path);
  if (path.empty() || fs::is_directory(status) || !path.has_filename()) {
    throw cannot_write(path, "it is a folder; give the name of a file");
  }
  const bool is_special = !fs::is_regular_file(status) || names_open_stream(path);
  if (fs::exists(status) && is_special) return write_directly(path, write);
  const fs::path target = link_target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) {
    throw cannot_write(path, fmt::format("there is no folder {}", in_quotes(utf8_from_path(folder))));
  }
  if (fs::exists(status)) require_writable(target);
  errno = 0;
  TemporaryFile file(target.parent_path());
  if (!file.stream()) throw cannot_write(target, "no file can be created in its folder: " + system_reason());
  write(file.stream());
  take_place(file, target, status);
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  try {
    write_file(path, write);
  } catch (const fs::filesystem_error& error) {
    throw cannot_write(path, error.code().message());
  }
}

}  // namespace graze::io
