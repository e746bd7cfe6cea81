// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/data.hpp>

namespace graze::io::tiled_data_test {
namespace {

using Gids = std::vector<std::uint32_t>;

const TiledText file{"m.tmx", "<map/>"};

TEST(TiledData, ReadsNumbersWithCommasBetween) {
  for (const char* text : {"1,20,4294967295", "\n 1 , 20 ,\r\n4294967295\n", "1,20,4294967295,\n"}) {
    EXPECT_EQ(tiled_gids_of_csv(text, {file, 0}), (Gids{1, 20, 4294967295})) << text;
  }
  EXPECT_EQ(tiled_gids_of_csv(" \n", {file, 0}), Gids{});
  for (const char* text : {"1,,2", ",1", "1 2", "1.5", "-1", "0x1", "4294967296", "1;2"}) {
    EXPECT_THROW(tiled_gids_of_csv(text, {file, 0}), InputError) << text;
  }
}

TEST(TiledData, ReadsBytesFromTheLowestOn) {
  std::vector<Omission> omissions;
  EXPECT_EQ(tiled_gids("AQAAAAIAAIA=", {"base64", ""}, 2, {file, 0}, omissions), (Gids{1, 0x80000002}));
  EXPECT_THROW(tiled_gids("AQAAAAIAAIA=", {"base64", ""}, 3, {file, 0}, omissions), InputError);
  EXPECT_THROW(tiled_gids("1,2", {"csv", ""}, 1, {file, 0}, omissions), InputError);
  EXPECT_TRUE(omissions.empty());
  EXPECT_EQ(tiled_gids("1,2", {"csv", ""}, 3, {file, 0}, omissions), (Gids{1, 2}));
  EXPECT_EQ(omissions.at(0).what, "tile layer with fewer tiles than cells");
}

TEST(TiledData, CountsFormatsThatItDoesNotKnow) {
  std::vector<Omission> omissions;
  EXPECT_FALSE(tiled_gids("", {"base64", "lz4"}, 1, {file, 0}, omissions));
  EXPECT_FALSE(tiled_gids("", {"base32", "zlib"}, 1, {file, 0}, omissions));
  ASSERT_EQ(omissions.size(), 2U);
  EXPECT_EQ(omissions[0].what, "tile layer in the format \"lz4\"");
  EXPECT_EQ(omissions[0].loss, Loss::shape);
  EXPECT_EQ(omissions[1].what, "tile layer in the format \"base32\"");
}

}  // namespace
}  // namespace graze::io::tiled_data_test
