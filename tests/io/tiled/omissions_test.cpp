// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/omissions.hpp>

namespace graze::io::tiled_omissions_test {
namespace {

const TiledText file{"level.tmx", "<map>\n <object/>\n</map>"};

TEST(TiledOmissions, AreCountedByKindInOrderOfAppearance) {
  std::vector<Omission> omissions;
  count_omission(omissions, tiled_omission::image_layer, {file, 7});
  count_omission(omissions, tiled_omission::text_object, {file, 0}, 2);
  count_omission(omissions, tiled_omission::image_layer, {file, 0}, 3);
  count_omission(omissions, tiled_omission::unknown_layer, {file, 0}, 0);
  ASSERT_EQ(omissions.size(), 2U);
  EXPECT_EQ(omissions[0].what, "image layer");
  EXPECT_EQ(omissions[0].count, 4U);
  EXPECT_EQ(omissions[1].count, 2U);
}

TEST(TiledOmissions, SayWhereTheFirstIsAndWhatTheSceneLacksByIt) {
  std::vector<Omission> omissions;
  count_omission(omissions, tiled_omission::large_polygon, {file, 7});
  count_omission(omissions, tiled_omission::large_polygon, {file, 0});
  EXPECT_EQ(omissions[0].where, "level.tmx, line 2, column 2");
  EXPECT_EQ(omissions[0].loss, Loss::shape);
  EXPECT_EQ(omissions[0].why, "cutting it would take too long; draw it as several polygons");
}

}  // namespace
}  // namespace graze::io::tiled_omissions_test
