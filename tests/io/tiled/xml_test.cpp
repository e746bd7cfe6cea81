// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/xml.hpp>

#include "io/tiled/same_content.hpp"

namespace graze::io::tiled_xml_test {
namespace {

TiledMap read(std::string_view text) { return read_tiled_xml_map({"m.tmx", text}); }

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The error of a map whose line 2 is one object with these attributes and children.
std::string object_error(std::string_view attributes, std::string_view children = "") {
  return error_of(std::string("<map><objectgroup>\n<object ") + std::string(attributes) + ">" + std::string(children) +
                  "</object></objectgroup></map>");
}

TEST(TiledXml, ReadsEveryFieldOfAnObject) {
  const TiledMap map = read(R"(<?xml version="1.0"?>
<map orientation="isometric" tilewidth="64" tileheight="32">
 <objectgroup name="things" offsetx="3" offsety="-4.5">
  <object id="7" name="box" type="crate" gid="2147483651" x="1.5" y="-2" width="3" height="4e1" rotation="-270"
          template="t/x.tx" visible="0">
   <properties><property name="a" value="1"/><property name="b" value="2"/></properties>
  </object>
 </objectgroup>
</map>)");
  expect_every_field(map, "t/x.tx");
}

TEST(TiledXml, ReadsEveryOutline) {
  const TiledMap map = read(R"(<map><objectgroup>
    <object/> <object><ellipse/></object> <object><capsule/></object> <object><point/></object>
    <object><polygon points="0,0 8,-2.5
      1e1,4"/></object>
    <object><polyline points=" 0,0   8,0 "/></object> <object><text>Hello</text></object></objectgroup></map>)");
  expect_every_outline(map);
}

TEST(TiledXml, KeepsGroupsAndCountsWhatItDoesNotRead) {
  const TiledMap map = read(R"(<map><properties><property/></properties><editorsettings/>
    <layer width="1000000000" height="1000000000"/>
    <group name="g" parallaxx="0.5"><imagelayer/><group name="h"><objectgroup name="o"><object/></objectgroup></group>
    </group><surprise/></map>)");
  expect_groups(map, "1 custom property; 1 layer parallax; 1 image layer; 1 unknown element; ");
}

using Gids = std::vector<std::uint32_t>;

TEST(TiledXml, ReadsTheCellsOfTileLayers) {
  const TiledMap map = read(R"(<map>
    <layer width="2" height="2"><data encoding="csv">
1,0,
2147483650,4294967295
</data></layer>
    <layer width="2" height="1"><data encoding="base64">
   AQAAAAIAAIA=
  </data></layer>
    <layer width="2" height="2"><data><tile gid="1"/><tile/> <tile gid="2147483650"></tile></data></layer>
    <layer width="2" height="2"><data><tile gid="1"/><!-- two --><tile gid='2'/></data></layer>
    <layer><data encoding="csv"><chunk x="-16" y="32" width="1" height="2">5,6</chunk>
      <chunk x="0" y="0" width="1" height="1">7</chunk></data></layer>
    <layer><data><chunk x="-16" y="32" width="1" height="2"><tile gid="5"/>
      <tile gid="6"/></chunk></data></layer>
    <layer width="0" height="1"><data encoding="csv"></data></layer></map>)");
  ASSERT_EQ(map.layers.size(), 7U);
  EXPECT_EQ(map.layers[0].cells.at(0).gids, (Gids{1, 0, 2147483650, 4294967295}));
  EXPECT_EQ(map.layers[0].cells.at(0).width, 2U);
  EXPECT_EQ(map.layers[1].cells.at(0).gids, (Gids{1, 2147483650}));
  EXPECT_EQ(map.layers[2].cells.at(0).gids, (Gids{1, 0, 2147483650})) << "the rest of the cells is empty";
  EXPECT_EQ(map.layers[3].cells.at(0).gids, (Gids{1, 2}));
  expect_chunks(map.layers[4]);
  EXPECT_EQ(map.layers[5].cells.at(0).gids, (Gids{5, 6}));
  EXPECT_TRUE(map.layers[6].cells.empty());
}

TEST(TiledXml, RefusesCellsThatAreNone) {
  const auto error_with = [](const std::string& data) {
    return error_of("<map><layer width=\"2\" height=\"1\">\n" + data + "</layer></map>");
  };
  EXPECT_EQ(error_with("<data encoding=\"csv\">1,2,3</data>"),
            "m.tmx: line 2, column 1: there are 3 tiles here, but width times height is 2");
  EXPECT_EQ(error_with("<data encoding=\"csv\">1,x</data>"),
            "m.tmx: line 2, column 1: tile 2 of the data is \"x\"; it must be a whole number from 0 to 4294967295");
  EXPECT_NE(error_with("<data encoding=\"csv\">1;2</data>").find("a comma is missing after tile 1 of the data"),
            std::string::npos);
  EXPECT_NE(error_with("<data><tile/><tile/><tile/></data>").find("there are 3 tiles here"), std::string::npos);
  EXPECT_NE(error_with("<data><tile gid=\"-1\"/></data>").find("gid=\"-1\", which is not a whole number"),
            std::string::npos);
  EXPECT_EQ(error_of("<map><layer width=\"8193\" height=\"8192\">\n<data encoding=\"base64\"/></layer></map>"),
            "m.tmx: line 1, column 6: with this one of 8193 x 8192 the compressed tile layers of the map have 67117056 "
            "cells; "
            "the most is 67108864");
  EXPECT_NE(error_of("<map><layer><data encoding=\"csv\"><chunk x=\"0.5\" width=\"1\" height=\"1\">1</chunk></data>"
                     "</layer></map>")
                .find("the x here is 0.5; it must be a whole number"),
            std::string::npos);
}

TEST(TiledXml, CountsALayerThatEndsEarly) {
  const TiledMap map =
      read(R"(<map><layer width="1000000000" height="1000000000"><data encoding="csv">1,2</data></layer>
    </map>)");
  EXPECT_EQ(map.layers.at(0).cells.at(0).gids, (Gids{1, 2}));
  EXPECT_EQ(map.omissions.at(0).what, "tile layer with fewer tiles than cells");
}

TEST(TiledXml, ReadsATilesetOfOneImage) {
  const TiledTileset tileset = read_tiled_xml_tileset({"t.tsx", R"(<tileset tilewidth="32" tileheight="16" tilecount="8"
    objectalignment="center"><tileoffset x="0" y="3"/><image source="i.png" width="128" height="32"/>
    <tile id="5"><objectgroup><object/><object/></objectgroup></tile></tileset>)"});
  expect_tileset_of_one_image(tileset);
}

TEST(TiledXml, ReadsATilesetOfManyImages) {
  const TiledTileset tileset = read_tiled_xml_tileset({"t.tsx", R"(<tileset objectalignment="unspecified">
    <tile id="3"><image width="64" height="96"/></tile>
    <tile id="9" x="0" y="0" width="10" height="20"><image width="64" height="96"/></tile></tileset>)"});
  expect_tileset_of_many_images(tileset);
}

TEST(TiledXml, ReadsATemplate) {
  const TiledTemplate read = read_tiled_xml_template(
      {"t.tx", R"(<template><tileset firstgid="4" source="a.tsx"/><object gid="5" width="7"/></template>)"});
  expect_template(read);
  EXPECT_THROW(read_tiled_xml_template({"t.tx", "<template/>"}), InputError);
}

TEST(TiledXml, NamesThePlaceOfBrokenXml) {
  EXPECT_EQ(error_of("<map>\n <objectgroup>\n  <object x=5/>"),
            "m.tmx: line 3, column 13: the XML is broken or cut off: Error parsing element attribute");
  EXPECT_NE(error_of("<map>\n <objectgroup>").find("m.tmx: line 2, column"), std::string::npos);
  EXPECT_NE(error_of("<map></tilemap>").find("Start-end tags mismatch"), std::string::npos);
  EXPECT_NE(error_of("").find("m.tmx: line 1, column 1: "), std::string::npos);
  EXPECT_NE(error_of("<map name=\"\xff\"/>").find("m.tmx"), std::string::npos);
}

TEST(TiledXml, RefusesAnotherKindOfFile) {
  EXPECT_NE(error_of("<tileset/>").find("is a Tiled tileset, but a Tiled map is needed"), std::string::npos);
  EXPECT_NE(error_of("<svg/>").find("of the kind \"svg\""), std::string::npos);
}

TEST(TiledXml, RefusesNumbersThatAreNone) {
  for (const char* bad : {"abc", "", "nan", "NaN", "inf", "-infinity", "1e999", "1,5", "3px", "0x10", " 1", "--1"}) {
    EXPECT_EQ(object_error("x=\"" + std::string(bad) + "\""),
              "m.tmx: line 2, column 1: <object> has x=\"" + std::string(bad) + "\", which is not a finite number");
  }
  EXPECT_EQ(object_error("x=\"1e-999\""), "no error") << "too small is zero, as everywhere";
}

TEST(TiledXml, RefusesWholeNumbersThatAreNone) {
  for (const char* bad : {"-1", "1.5", "4294967296", "1e3", "", "x"}) {
    EXPECT_EQ(object_error("gid=\"" + std::string(bad) + "\""),
              "m.tmx: line 2, column 1: <object> has gid=\"" + std::string(bad) +
                  "\", which is not a whole number from 0 to 4294967295");
  }
}

TEST(TiledXml, RefusesPointsThatAreNone) {
  EXPECT_EQ(object_error("id=\"4\"", R"(<polygon points="0,0 8;2 4,4"/>)"),
            "m.tmx: line 2, column 16: point 2 of the <polygon> is \"8;2\"; a point is two finite numbers with a comma "
            "between, as in \"8,-2.5\"");
  for (const char* bad : {"0,0 1", "0,0 1,", "0,0 ,1", "0,0 1,2,3", "0,0 nan,1", "0,0 1e999,1", "0 0"}) {
    EXPECT_NE(object_error("", "<polyline points=\"" + std::string(bad) + "\"/>").find("a point is two"),
              std::string::npos)
        << bad;
  }
  EXPECT_NE(object_error("", "<polygon points=\"1,1\"/>").find("has 1 point; it needs at least 2"), std::string::npos);
  EXPECT_NE(object_error("", "<polyline/>").find("has 0 points; it needs at least 2"), std::string::npos);
}

TEST(TiledXml, RefusesNegativeSizes) {
  EXPECT_EQ(object_error("name=\"pit\" width=\"-3\""),
            "m.tmx: line 2, column 1: object \"pit\" has the width -3; it must be 0 or more");
}

TEST(TiledXml, SurvivesNestingWithoutLimit) {
  constexpr std::size_t depth = 200'000;
  std::string groups = "<map>";
  std::string unknown = "<map>";
  for (std::size_t i = 0; i < depth; ++i) {
    groups += "<group>";
    unknown += "<x>";
  }
  for (std::size_t i = 0; i < depth; ++i) {
    groups += "</group>";
    unknown += "</x>";
  }
  EXPECT_NE(error_of(groups + "</map>").find("nested deeper than 32 groups"), std::string::npos);
  EXPECT_EQ(error_of(unknown + "</map>"), "no error");
}

TEST(TiledXml, RefusesWhatIsNoXmlToOthers) {
  EXPECT_NE(error_of(R"(<!DOCTYPE map [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>
    <map><objectgroup name="&b;"/></map>)")
                .find("the entity \"&b;\" is not supported"),
            std::string::npos);
  EXPECT_NE(error_of("<map/>\ngarbage").find("m.tmx: line 2, column 1: \"garbage\" appears after"), std::string::npos);
  EXPECT_NE(error_of("<map/>\n<map/>").find("second root"), std::string::npos);
  EXPECT_NE(object_error("x='1' x='2'").find("the attribute \"x\" is given twice"), std::string::npos);
}

}  // namespace
}  // namespace graze::io::tiled_xml_test
