// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <graze/io/file/atomic_file.hpp>
#include <graze/io/output_error.hpp>

#include "io/scene_text.hpp"
#include "io/tiled_folder.hpp"

namespace graze::io::atomic_file_test {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
  write_atomically(path, [&text](std::ostream& out) { out << text; });
}

std::string refusal(const fs::path& path) {
  try {
    write_text(path, "new");
  } catch (const OutputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no OutputError was thrown";
  return "";
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

TEST(AtomicFile, AFileIsMadeAndReplaced) {
  const TiledFolder folder;
  const fs::path path = folder.path() /
                        "gr\xC3\xB6\xC3\x9F"
                        "e 1.json";
  write_text(path, "first");
  EXPECT_EQ(text_of(path), "first");
  write_text(path, "2nd");
  EXPECT_EQ(text_of(path), "2nd");
  EXPECT_EQ(names_in(folder.path()).size(), 1U);
}

TEST(AtomicFile, AWriterThatThrowsLeavesTheOldFileAndNothingElse) {
  const TiledFolder folder;
  const fs::path path = folder.path() / "a.json";
  write_text(path, "old");
  const auto fail = [](std::ostream& out) {
    out << std::string(1000000, 'x');
    throw std::logic_error("on the way");
  };
  EXPECT_THROW(write_atomically(path, fail), std::logic_error);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_THROW(write_atomically(folder.path() / "new.json", fail), std::logic_error);
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a.json"}));
}

TEST(AtomicFile, AStreamThatFailedLeavesTheOldFile) {
  const TiledFolder folder;
  const fs::path path = folder.path() / "a.json";
  write_text(path, "old");
  EXPECT_THROW(write_atomically(path, [](std::ostream& out) { out.setstate(std::ios::badbit); }), OutputError);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(names_in(folder.path()).size(), 1U);
}

TEST(AtomicFile, PermissionsAreKept) {
  const TiledFolder folder;
  const fs::path path = folder.path() / "a.json";
  write_text(path, "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_exec);
  write_text(path, "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_exec);
}

TEST(AtomicFile, SymbolicLinksAreFollowed) {
  const TiledFolder folder;
  fs::create_directory(folder.path() / "deep");
  folder.write("deep/target.json", "old");
  fs::create_symlink("deep/target.json", folder.path() / "link.json");
  fs::create_symlink("link.json", folder.path() / "link to link.json");
  write_text(folder.path() / "link to link.json", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.json"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link to link.json"));
  EXPECT_EQ(text_of(folder.path() / "deep" / "target.json"), "new");
  EXPECT_EQ(names_in(folder.path() / "deep").size(), 1U);

  fs::create_symlink("deep/made.json", folder.path() / "dangling.json");
  write_text(folder.path() / "dangling.json", "new");
  EXPECT_EQ(text_of(folder.path() / "deep" / "made.json"), "new");

  fs::create_symlink("round.json", folder.path() / "round.json");
  EXPECT_NE(refusal(folder.path() / "round.json").find("cannot write "), std::string::npos);
}

TEST(AtomicFile, WhatCannotBeWrittenIsNamedWithTheReason) {
  const TiledFolder folder;
  EXPECT_NE(refusal(folder.path()).find("it is a folder; give the name of a file"), std::string::npos);
  EXPECT_NE(refusal(folder.path() / "").find("it is a folder; give the name of a file"), std::string::npos);
  EXPECT_NE(refusal("").find("it is a folder; give the name of a file"), std::string::npos);
  EXPECT_NE(refusal(folder.path() / "none" / "a.json").find("there is no folder "), std::string::npos);
  folder.write("file", "old");
  EXPECT_EQ(refusal(folder.path() / "file" / "a.json").find("cannot write "), 0U);
  EXPECT_EQ(refusal(folder.path() / std::string(300, 'x')).find("cannot write "), 0U);
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"file"}));
}

TEST(AtomicFile, AProtectedFileIsNotReplaced) {
  const TiledFolder folder;
  const fs::path path = folder.path() / "a.json";
  write_text(path, "old");
  fs::permissions(path, fs::perms::owner_read);
  if (std::ofstream(path, std::ios::app)) GTEST_SKIP() << "this user may write to protected files";
  EXPECT_NE(refusal(path).find("Permission denied"), std::string::npos);
  EXPECT_EQ(text_of(path), "old");
}

TEST(AtomicFile, SpecialFilesAreWrittenDirectly) {
  if (!fs::is_character_file("/dev/null")) GTEST_SKIP() << "there is no /dev/null";
  write_text("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, AnOpenStreamIsAppendedToEvenIfItIsAFile) {
  if (!fs::is_directory("/proc/self/fd")) GTEST_SKIP() << "there is no /proc/self/fd";
  const TiledFolder folder;
  folder.write("log", "old ");
  const int descriptor = open((folder.path() / "log").c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(descriptor, 0);
  write_text("/proc/self/fd/" + std::to_string(descriptor), "new ");
  EXPECT_EQ(write(descriptor, "last", 4), 4);
  close(descriptor);
  EXPECT_EQ(text_of(folder.path() / "log"), "old new last");
}

TEST(AtomicFile, AFullDiskIsNoticed) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_NE(refusal("/dev/full").find("No space left on device"), std::string::npos);
}

}  // namespace
}  // namespace graze::io::atomic_file_test
