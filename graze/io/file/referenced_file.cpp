// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include <graze/io/file/referenced_file.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// Why a file cannot be read, or nothing.
std::string_view fault_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found ||
      path.native().find(fs::path::value_type{}) != fs::path::string_type::npos)
    return "there is no such file";
  if (status.type() == fs::file_type::directory) return "it is a folder";
  if (error || status.type() != fs::file_type::regular)
    return "it is not a regular file, or a folder in its path is not accessible";
  return "";
}

}  // namespace

ReferencedFile read_referenced_file(const fs::path& path) {
  ReferencedFile file{"", fault_of(path)};
  if (!file.fault.empty()) return file;
  std::ifstream stream(path, std::ios::binary);
  file.bytes.assign(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) file.fault = "it cannot be opened or read";
  return file;
}

}  // namespace graze::io
