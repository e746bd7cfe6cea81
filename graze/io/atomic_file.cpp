// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <graze/io/atomic_file.hpp>
#include <graze/io/in_quotes.hpp>
#include <graze/io/output_error.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

OutputError cannot_write(const fs::path& path, std::string_view reason) {
  return OutputError(fmt::format("cannot write {}: {}", in_quotes(path.string()), reason));
}

/// What the system said last, in words.
std::string system_reason() {
  const int error = errno;
  return error == 0 ? "the system gives no reason" : std::generic_category().message(error);
}

/// Where a chain of symbolic links ends; there need not be a file.
fs::path link_target(const fs::path& path) {
  constexpr int longest_chain = 40;  // as in Linux
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target)); ++links) {
    if (links == longest_chain) throw cannot_write(path, "its symbolic links go round in a circle");
    target = target.parent_path() / fs::read_symlink(target);
  }
  return target;
}

/// /dev/stdout and /dev/fd/3 lead to whatever was opened for the process, perhaps a regular file that others write to
/// too.
bool names_open_stream(const fs::path& path) {
  const std::string name = path.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// Appends, so that nothing is lost of what an open stream's file holds already; to devices and pipes it is all the
/// same.
void write_directly(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::app);
  if (!out) throw cannot_write(path, system_reason());
  write(out);
  out.close();
  if (!out) throw cannot_write(path, system_reason());
}

/// A file that is removed again unless it takes the target's place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), path_(target.parent_path() / random_name()) {
    errno = 0;
    out_.open(path_, std::ios::binary);
    if (!out_) throw cannot_write(target_, "its folder takes no new file: " + system_reason());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile() {
    if (is_in_place_) return;
    out_.close();
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  std::ostream& stream() { return out_; }

  void take_place(const fs::file_status& old) {
    out_.close();
    if (!out_) throw cannot_write(target_, system_reason() + "; what was there is unchanged");
    std::error_code error;
    if (fs::exists(old)) fs::permissions(path_, old.permissions(), error);
    if (!error) fs::rename(path_, target_, error);
    if (error) throw cannot_write(target_, error.message() + "; what was there is unchanged");
    is_in_place_ = true;
  }

 private:
  static std::string random_name() {
    std::random_device random;
    return fmt::format(".graze-{:08x}{:08x}.tmp", random(), random());
  }

  fs::path target_;
  fs::path path_;
  std::ofstream out_;
  bool is_in_place_ = false;
};

/// Replacing a file needs no right to write to it, only to its folder; but a file that is protected is meant to stay.
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
    throw cannot_write(path, fmt::format("there is no folder {}", in_quotes(folder.string())));
  }
  if (fs::exists(status)) require_writable(target);
  TemporaryFile file(target);
  write(file.stream());
  file.take_place(status);
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
