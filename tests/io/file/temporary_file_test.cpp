// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/file/temporary_file.hpp>

#include "io/tiled_folder.hpp"

namespace graze::io::temporary_file_test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

TEST(TemporaryFile, IsThereUntilItGoesUnlessItIsRenamed) {
  const TiledFolder folder;
  {
    TemporaryFile file(folder.path());
    file.stream() << "text";
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{file.path().filename().string()});
  }
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{});
  {
    TemporaryFile file(folder.path());
    fs::rename(file.path(), folder.path() / "kept");
  }
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"kept"});
}

TEST(TemporaryFile, RemovesThoseThatNobodyWritesAndNothingElse) {
  const TiledFolder folder;
  const std::set<std::string> others = {".graze-0123456789abcdeg.tmp", ".graze-0123456789abcde.tmp", "graze.tmp",
                                        ".graze-0123456789abcdef.tmp2", "report.json"};
  for (const std::string& name : others) folder.write(name, "precious");
  folder.write(".graze-0123456789abcdef.tmp", "left behind");
  fs::create_directory(folder.path() / ".graze-00000000000000ff.tmp");
  const TemporaryFile first(folder.path());
  const TemporaryFile second(folder.path());
  std::set<std::string> expected = others;
  expected.insert({first.path().filename().string(), second.path().filename().string(), ".graze-00000000000000ff.tmp"});
  EXPECT_EQ(names_in(folder.path()), expected);
}

TEST(TemporaryFile, IsRemovedForAHandlerOfSignals) {
  const TiledFolder folder;
  const TemporaryFile first(folder.path());
  const TemporaryFile second(folder.path());
  { const TemporaryFile gone(folder.path()); }
  remove_temporary_files();
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{});
}

TEST(TemporaryFile, SaysWhereThereCanBeNone) {
  const TiledFolder folder;
  TemporaryFile file(folder.path() / "none");
  EXPECT_FALSE(file.stream());
}

TEST(TemporaryFile, CanBeMany) {
  const TiledFolder folder;
  std::vector<std::unique_ptr<TemporaryFile>> files;
  for (int i = 0; i < 40; ++i) files.push_back(std::make_unique<TemporaryFile>(folder.path()));
  EXPECT_EQ(names_in(folder.path()).size(), 40U);
  files.clear();
  EXPECT_EQ(names_in(folder.path()).size(), 0U);
}

}  // namespace
}  // namespace graze::io::temporary_file_test
