// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gtest/gtest.h>

#include <graze/io/file/whole_file.hpp>

#include "io/scene_text.hpp"

namespace graze::io::whole_file_test {
namespace {

TEST(WholeFile, HasAllBytes) {
  const auto file = project_file("data/workshop.json");
  EXPECT_EQ(read_whole_file(file, "the file"), text_of(file));
}

TEST(WholeFile, ErrorsNameTheFileAndWhatWasWanted) {
  const auto folder = project_file("data");
  EXPECT_EQ(error_of([&] { read_whole_file(folder, "the log"); }),
            folder.string() + ": this is a folder; give the log in it");
  EXPECT_EQ(error_of([] { read_whole_file("no/such/file", "the log"); }), "no/such/file: there is no such file");
}

}  // namespace
}  // namespace graze::io::whole_file_test
