// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/io/text/file_name.hpp>

namespace graze::io::file_name_test {
namespace {

TEST(FileName, is_the_last_part_of_a_path) {
  EXPECT_EQ(file_name("cave.tmx"), "cave.tmx");
  EXPECT_EQ(file_name("/home/somebody/levels/cave.tmx"), "cave.tmx");
  EXPECT_EQ(file_name("C:\\levels\\cave.tmx"), "cave.tmx");
  EXPECT_EQ(file_name("-"), "-");
  EXPECT_EQ(file_name(""), "");
  EXPECT_EQ(file_name("folder/"), "folder/");
}

}  // namespace
}  // namespace graze::io::file_name_test
