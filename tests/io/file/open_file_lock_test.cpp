// SPDX-License-Identifier: MIT
#include <filesystem>
#include <utility>

#include <gtest/gtest.h>

#include <graze/io/file/open_file_lock.hpp>

#include "io/tiled_folder.hpp"

namespace graze::io::open_file_lock_test {
namespace {

TEST(OpenFileLock, IsHeldByOneAtATime) {
  const TiledFolder folder;
  const std::filesystem::path path = folder.path() / "a";
  {
    OpenFileLock first = OpenFileLock::of_new(path);
    ASSERT_TRUE(first.is_held());
    EXPECT_FALSE(OpenFileLock::of_existing(path).is_held());
    EXPECT_FALSE(OpenFileLock::of_new(path).is_held()) << "it is not new any more";
    const OpenFileLock taken = std::move(first);
    EXPECT_TRUE(taken.is_held());
    EXPECT_FALSE(OpenFileLock::of_existing(path).is_held());
  }
  EXPECT_TRUE(OpenFileLock::of_existing(path).is_held());
}

TEST(OpenFileLock, IsOfRegularFilesOnly) {
  const TiledFolder folder;
  EXPECT_FALSE(OpenFileLock().is_held());
  EXPECT_FALSE(OpenFileLock::of_existing(folder.path()).is_held());
  EXPECT_FALSE(OpenFileLock::of_existing(folder.path() / "none").is_held());
  folder.write("a", "text");
  std::filesystem::create_symlink("a", folder.path() / "link");
  EXPECT_FALSE(OpenFileLock::of_existing(folder.path() / "link").is_held());
}

}  // namespace
}  // namespace graze::io::open_file_lock_test
