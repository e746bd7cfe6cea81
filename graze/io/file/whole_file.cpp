// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>
#include <graze/io/input_error.hpp>

namespace graze::io {

namespace {

namespace fs = std::filesystem;

/// The size that the system reports, to reserve memory at once. Zero for implausibly large sizes.
std::size_t expected_size(const fs::path& path) {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 32U;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error || size > most ? 0 : static_cast<std::size_t>(size);
}

}  // namespace

// Read to the end: a pipe has no size, and a reported size is not to be trusted.
std::string read_whole_file(const fs::path& path, std::string_view what) {
  const std::string source = utf8_from_path(path);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::status_known(status)) throw InputError(source + ": cannot be read: " + error.message());
  if (!fs::exists(status)) throw InputError(source + ": there is no such file");
  if (fs::is_directory(status)) throw InputError(source + ": this is a folder; give " + std::string(what) + " in it");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(source + ": cannot be opened: " + std::generic_category().message(errno));
  std::string text;
  text.reserve(expected_size(path));
  char chunk[1U << 16U];
  while (in.read(chunk, sizeof chunk) || in.gcount() > 0) text.append(chunk, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw InputError(source + ": reading failed: " + std::generic_category().message(errno));
  return text;
}

}  // namespace graze::io
