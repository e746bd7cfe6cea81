// SPDX-License-Identifier: MIT
#include "file_ending.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace graze::cli {

std::string file_ending(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

}  // namespace graze::cli
