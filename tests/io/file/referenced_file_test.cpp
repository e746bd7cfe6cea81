// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/file/referenced_file.hpp>

#include "io/tiled_folder.hpp"

namespace graze::io::referenced_file_test {
namespace {

TEST(ReferencedFile, ARegularFileIsReadAsItIs) {
  const TiledFolder folder;
  const std::string bytes("a\0\r\nb", 5);
  folder.write("a.bin", bytes);
  const ReferencedFile file = read_referenced_file(folder.path() / "a.bin");
  EXPECT_EQ(file.fault, "");
  EXPECT_EQ(file.bytes, bytes);
}

TEST(ReferencedFile, WhatIsNoRegularFileIsRefused) {
  const TiledFolder folder;
  EXPECT_EQ(read_referenced_file(folder.path() / "none").fault, "there is no such file");
  EXPECT_EQ(read_referenced_file(folder.path()).fault, "it is a folder");
  EXPECT_EQ(read_referenced_file("/dev/null").fault,
            "it is not a regular file, or a folder in its path is not accessible");
}

}  // namespace
}  // namespace graze::io::referenced_file_test
