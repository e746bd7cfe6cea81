// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>

#include "scratch_folder.hpp"

namespace graze::io::utf8_path_test {
namespace {

const std::string greek = "\xCE\xB3\xCF\x81.bin";

TEST(Utf8Path, IsTheSameTextBack) {
  EXPECT_EQ(utf8_from_path(path_from_utf8(greek)), greek);
  EXPECT_EQ(path_from_utf8(greek).u8string().size(), greek.size());
  EXPECT_EQ(utf8_from_path({}), "");
}

TEST(Utf8Path, NamesAFileThatIsWrittenAndReadBack) {
  const test::ScratchFolder folder("graze utf8");
  const std::filesystem::path path = folder.path() / path_from_utf8(greek);
  std::ofstream(path, std::ios::binary) << "x";
  EXPECT_EQ(read_whole_file(path, "the file"), "x");
  EXPECT_EQ(utf8_from_path(std::filesystem::directory_iterator(folder.path())->path().filename()), greek);
}

}  // namespace
}  // namespace graze::io::utf8_path_test
