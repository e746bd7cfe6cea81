// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

namespace graze::io {

/// A folder of its own for a test, with a space and an umlaut in its name, gone when the test ends.
class TiledFolder {
 public:
  TiledFolder() {
    const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string("graze h\xc3\xb6hle ") + test.test_suite_name() + "." + test.name() + " " +
                             std::to_string(getpid());
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  TiledFolder(const TiledFolder&) = delete;
  TiledFolder& operator=(const TiledFolder&) = delete;
  TiledFolder(TiledFolder&&) = delete;
  TiledFolder& operator=(TiledFolder&&) = delete;
  ~TiledFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, std::string_view text) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace graze::io
