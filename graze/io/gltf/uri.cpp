// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <graze/io/gltf/uri.hpp>

namespace graze::io {
namespace {

/// "%" that no two hexadecimal digits follow stays as it is: some programs do not encode it.
std::string decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const auto [end, status] = std::from_chars(digits, digits + 2, value, 16);
      if (status == std::errc() && end == digits + 2) {
        text += static_cast<char>(static_cast<unsigned char>(value));
        i += 2;
        continue;
      }
    }
    text += uri[i];
  }
  return text;
}

}  // namespace

std::optional<std::string> file_of_gltf_uri(std::string_view uri) {
  std::string path = decoded(uri);
  if (path.empty() || path.front() == '/' || path.find_first_of(std::string_view(":\\\0", 3)) != std::string::npos) {
    return std::nullopt;
  }
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (std::string_view(path).substr(begin, end - begin) == "..") return std::nullopt;
    begin = end + 1;
  }
  return path;
}

}  // namespace graze::io
