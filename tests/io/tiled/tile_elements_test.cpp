// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/tiled/tile_elements.hpp>

namespace graze::io::tile_elements_test {
namespace {

std::string shortened(std::string_view xml) {
  std::string text(xml);
  shorten_tile_elements(text);
  EXPECT_EQ(text.size(), xml.size()) << "everything else stays where it is";
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }), text.end());
  return text;
}

TEST(TileElements, BecomeNumbers) {
  EXPECT_EQ(shortened("<data>\n <tile gid=\"1\"/>\n<tile gid=\"20\" /><tile/><tile gid=\"3\"></tile>\n</data>x"),
            "<data>1,20,0,3, </data>x");
  EXPECT_EQ(shortened("<data><chunk x=\"0\"><tile gid=\"4294967295\"/></chunk><chunk><tile /></chunk></data>"),
            "<data><chunk x=\"0\">4294967295, </chunk><chunk>0, </chunk></data>");
}

TEST(TileElements, StayWhereTheyAreNotAlone) {
  for (const char* text :
       {"<data/>", "<data></data>", "<data><tile gid=\"-1\"/></data>", "<data><tile gid='1'/></data>",
        "<data><tile gid=\"1\"/><!-- 2 --><tile gid=\"2\"/></data>", "<data><tile gid=\"1\" x=\"2\"/></data>",
        "<data><tile gid=\"1\"/>", "<data><tile gid=\"1\"", "<data><tile", "<tile/>", "<a><tile/></a>",
        "<tileset><tile id=\"1\"/></tileset>", "<data/><tile/></x>", "<data><tile><x/></tile></data>",
        "<data><tilex/></data>", "<data><tile gid=\"\"/></data>"}) {
    EXPECT_EQ(shortened(text), text);
  }
}

TEST(TileElements, AreAllPassedAtOnce) {
  const std::string_view text = "<a><tile/> <tile gid=\"7\" />\n<tile gid='8'/>";
  EXPECT_EQ(behind_tile_elements(text, 3), text.find('\n'));
  EXPECT_EQ(behind_tile_elements(text, 0), 0U);
  EXPECT_EQ(behind_tile_elements(text, text.size()), text.size());
  EXPECT_EQ(behind_tile_elements("<tile gid=\"1\"", 0), 0U) << "cut off";
}

}  // namespace
}  // namespace graze::io::tile_elements_test
