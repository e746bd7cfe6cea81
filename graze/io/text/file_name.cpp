// SPDX-License-Identifier: MIT
#include <graze/io/text/file_name.hpp>

namespace graze::io {

std::string file_name(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return std::string(slash == std::string_view::npos || slash + 1 == path.size() ? path : path.substr(slash + 1));
}

}  // namespace graze::io
