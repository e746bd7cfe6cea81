// SPDX-License-Identifier: MIT
// Common helpers of the tests of scene files.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>

namespace graze::io {

/// A scene file around these objects.
inline std::string scene_2d(const std::string& objects) {
  return R"({"schema": "graze.scene/1", "dimension": 2, "objects": [)" + objects + "]}";
}

inline std::string scene_3d(const std::string& objects) {
  return R"({"schema": "graze.scene/1", "dimension": 3, "objects": [)" + objects + "]}";
}

/// The message of the InputError that a call throws.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return "";
}

/// A file of the project, located by GRAZE_ROOT.
inline std::filesystem::path project_file(const std::string& name) {
  const char* root = std::getenv("GRAZE_ROOT");
  return std::filesystem::path(root == nullptr ? "." : root) / name;
}

/// A file of real data: in GRAZE_SHARED_DATA, or in ../shared/data beside the project. It need not exist.
inline std::filesystem::path shared_file(const std::string& name) {
  const char* folder = std::getenv("GRAZE_SHARED_DATA");
  return folder == nullptr ? project_file("../shared/data/" + name) : std::filesystem::path(folder) / name;
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path << " cannot be read";
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The first code block of a language on a page.
inline std::string code_block(const std::string& page, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  const std::size_t begin = page.find(fence);
  const std::size_t end = page.find("\n```", begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  return page.substr(begin + fence.size(), end + 1 - begin - fence.size());
}

}  // namespace graze::io
