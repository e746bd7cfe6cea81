// SPDX-License-Identifier: MIT
#include "file_ending.hpp"

#include <algorithm>
#include <cctype>

#include <graze/io/file/utf8_path.hpp>

namespace graze::cli {

std::string file_ending(const std::string& name) {
  std::string ending = io::utf8_from_path(io::path_from_utf8(name).extension());
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

}  // namespace graze::cli
