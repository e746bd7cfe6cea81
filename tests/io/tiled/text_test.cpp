// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/text.hpp>

namespace graze::io::tiled_text_test {
namespace {

TEST(TiledText, NamesThePlaceOfAnError) {
  const TiledText file{"level.tmx", "<map>\n <object/>\n</map>"};
  try {
    fail_at(TiledPlace{file, 7}, "bad");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "level.tmx: line 2, column 2: bad");
  }
}

}  // namespace
}  // namespace graze::io::tiled_text_test
