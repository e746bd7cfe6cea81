// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/files.hpp>

#include "io/tiled_folder.hpp"

namespace graze::io::tiled_files_test {
namespace {

constexpr std::string_view sheet =
    R"(<tileset tilewidth="32" tileheight="16" tilecount="8"><image source="i.png"/></tileset>)";

/// Resolves one object of "m.tmx" in the folder, with the given tilesets.
struct Fixture {
  TiledFolder folder;
  TiledText file{"m.tmx", "<map>\n<object/></map>"};
  std::vector<TiledTileset> written;
  TiledFiles files;

  TiledResolvedObject resolve(const TiledObject& object) {
    const std::vector<TiledTilesetUse> tilesets = files.tilesets(written, file, folder.path());
    return files.resolve(object, {file, folder.path(), tilesets});
  }

  std::string error_of(const TiledObject& object) {
    try {
      resolve(object);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  void use_tileset(std::uint32_t first_gid, const std::string& source) {
    TiledTileset tileset;
    tileset.first_gid = first_gid;
    tileset.source = source;
    tileset.offset = 6;
    written.push_back(tileset);
  }

  std::string quoted_path(const std::string& name) const { return "\"" + (folder.path() / name).string() + "\""; }
};

TiledObject with_gid(std::uint32_t gid) {
  TiledObject object;
  object.offset = 6;
  object.gid = gid;
  return object;
}

TiledObject with_template(const std::string& source) {
  TiledObject object;
  object.offset = 6;
  object.template_source = source;
  return object;
}

TEST(TiledFiles, FindsATilesTilesetAndSizeWhateverItsFlips) {
  Fixture map;
  map.folder.write("sets/a.tsx", sheet);
  map.folder.write("sets/b.tsj", R"({"type": "tileset", "tilewidth": 99, "tiles":
    [{"id": 40, "image": "x.png", "imagewidth": 5, "imageheight": 6}]})");
  map.use_tileset(9, "sets/b.tsj");  // not in numeric order
  map.use_tileset(1, "sets/a.tsx");
  EXPECT_EQ(map.resolve(with_gid(8)).object.width, 32.0);
  EXPECT_EQ(map.resolve(with_gid(8)).object.height, 16.0);
  for (const std::uint32_t flip : {0x80000000U, 0x40000000U, 0x20000000U, 0x10000000U, 0xf0000000U}) {
    EXPECT_EQ(map.resolve(with_gid(flip | 49U)).object.width, 5.0);
  }
  EXPECT_FALSE(map.resolve(with_gid(0)).tile);
  EXPECT_FALSE(map.resolve(with_gid(0x80000000U)).tile) << "no tile, however flipped";
}

TEST(TiledFiles, PrefersTheObjectsOwnSizeToTheTiles) {
  Fixture map;
  map.folder.write("a.tsx", sheet);
  map.use_tileset(1, "a.tsx");
  TiledObject object = with_gid(1);
  object.width = 7;
  object.height = 0;
  EXPECT_EQ(map.resolve(object).object.width, 7.0);
  EXPECT_EQ(map.resolve(object).object.height, 16.0) << "0 is Tiled's word for the tile's own size";
}

TEST(TiledFiles, RefusesATileThatNoTilesetHolds) {
  Fixture map;
  map.folder.write("a.tsx", sheet);
  map.folder.write("b.tsx",
                   R"(<tileset tilewidth="32" tileheight="16" tilecount="9"><tile id="2"><image/></tile></tileset>)");
  EXPECT_EQ(map.error_of(with_gid(5)),
            "m.tmx: line 2, column 1: the object shows tile 5 (gid 5), which none of the 0 tilesets here holds");
  map.use_tileset(2, "a.tsx");
  map.use_tileset(20, "b.tsx");
  EXPECT_NE(map.error_of(with_gid(1)).find("shows tile 1"), std::string::npos) << "before the first";
  EXPECT_EQ(map.error_of(with_gid(9)), "no error");
  EXPECT_NE(map.error_of(with_gid(0x80000000U | 10U)).find("shows tile 10 (gid 2147483658)"), std::string::npos)
      << "beyond the first tileset's 8";
  EXPECT_EQ(map.error_of(with_gid(22)), "no error");
  EXPECT_NE(map.error_of(with_gid(21)).find("shows tile 21"), std::string::npos) << "a collection holds what it lists";
}

TEST(TiledFiles, RefusesATileWithoutAnySize) {
  Fixture map;
  map.written.push_back({});
  EXPECT_NE(map.error_of(with_gid(1)).find("the object has no size, and neither its tile"), std::string::npos);
}

TEST(TiledFiles, LetsTheObjectsWordsWinOverTheTemplates) {
  Fixture map;
  map.folder.write("t/x.tx", R"(<template><object name="crate" type="c" x="1000" width="8" height="9" rotation="30">
    <properties><property/></properties><ellipse/></object></template>)");
  TiledObject object = with_template("t/x.tx");
  object.x = 5;
  object.properties = 2;
  TiledObject read = map.resolve(object).object;
  EXPECT_EQ(read.name, "crate");
  EXPECT_EQ(read.x, 5.0);
  EXPECT_FALSE(read.y);
  EXPECT_EQ(read.width, 8.0);
  EXPECT_EQ(read.rotation, 30.0);
  EXPECT_EQ(read.outline, TiledOutline::ellipse);
  EXPECT_EQ(read.properties, 3U);
  EXPECT_TRUE(read.has_class);

  object.name = "mine";
  object.width = 1;
  object.rotation = 0;
  object.outline = TiledOutline::polygon;
  object.points = {{0, 0}, {1, 0}, {0, 1}};
  read = map.resolve(object).object;
  EXPECT_EQ(read.name, "mine");
  EXPECT_EQ(read.width, 1.0);
  EXPECT_EQ(read.height, 9.0);
  EXPECT_EQ(read.rotation, 0.0);
  EXPECT_EQ(read.outline, TiledOutline::polygon);
  EXPECT_EQ(read.points.size(), 3U);
}

TEST(TiledFiles, LooksUpATemplatesTileInTheTemplatesOwnTileset) {
  Fixture map;
  map.folder.write("a.tsx", sheet);
  map.folder.write("sets/big.tsx", R"(<tileset tilewidth="64" tileheight="64" tilecount="4"/>)");
  map.folder.write("t/x.tx",
                   R"(<template><tileset firstgid="1" source="../sets/big.tsx"/><object gid="2"/></template>)");
  map.use_tileset(1, "a.tsx");
  EXPECT_EQ(map.resolve(with_template("t/x.tx")).object.width, 64.0);
  TiledObject object = with_template("t/x.tx");
  object.gid = 2;
  EXPECT_EQ(map.resolve(object).object.width, 32.0) << "the object's own gid counts in the map's tilesets";
  object = with_template("t/x.tx");
  object.outline = TiledOutline::point;
  EXPECT_FALSE(map.resolve(object).tile) << "an outline of its own replaces the template's tile";
}

TEST(TiledFiles, FollowsATemplateMadeFromATemplate) {
  Fixture map;
  map.folder.write("t/x.tj", R"({"type": "template", "object": {"template": "deep/y.tx", "width": 4}})");
  map.folder.write("t/deep/y.tx", R"(<template><object name="y" width="1" height="2"/></template>)");
  const TiledObject read = map.resolve(with_template("t/x.tj")).object;
  EXPECT_EQ(read.name, "y");
  EXPECT_EQ(read.width, 4.0);
  EXPECT_EQ(read.height, 2.0);
}

TEST(TiledFiles, NamesWhoAsksAndWhatIsMissing) {
  Fixture map;
  EXPECT_EQ(map.error_of(with_template("t/no.tx")),
            "m.tmx: line 2, column 1: the template " + map.quoted_path("t/no.tx") +
                " cannot be read: there is no such file; references are relative to the file that makes them");
  map.folder.write("t/x.tx", "<template>\n<tileset source=\"../no.tsx\"/><object gid=\"1\"/></template>");
  EXPECT_EQ(map.error_of(with_template("t/x.tx")),
            (map.folder.path() / "t/x.tx").string() + ": line 2, column 1: the tileset " + map.quoted_path("no.tsx") +
                " cannot be read: there is no such file; references are relative to the file that makes them");
  EXPECT_NE(map.error_of(with_template("t")).find("cannot be read: it is a folder"), std::string::npos);
  EXPECT_NE(map.error_of(with_template("/dev/zero")).find("it is not a regular file"), std::string::npos);
  EXPECT_NE(map.error_of(with_template(std::string("t/x.tx\0y", 8))).find("no such file"), std::string::npos);
  map.use_tileset(1, "gone.tsx");
  EXPECT_NE(map.error_of(with_gid(1)).find("m.tmx: line 2, column 1: the tileset " + map.quoted_path("gone.tsx")),
            std::string::npos);
}

TEST(TiledFiles, MissesATilesetOnlyWhereItIsNeeded) {
  Fixture map;
  map.folder.write("a.tsx", sheet);
  map.use_tileset(1, "a.tsx");
  map.use_tileset(9, "gone.tsx");
  EXPECT_EQ(map.resolve(with_gid(8)).object.width, 32.0);
  EXPECT_NE(map.error_of(with_gid(9)).find("the tileset " + map.quoted_path("gone.tsx") + " cannot be read"),
            std::string::npos);
  const std::vector<TiledTilesetUse> tilesets = map.files.tilesets(map.written, map.file, map.folder.path());
  EXPECT_EQ(tilesets.at(0).fault, "");
  EXPECT_NE(tilesets.at(1).fault, "");
  EXPECT_EQ(find_tiled_tile(0x80000000U | 9U, tilesets).use, &tilesets[1]);
  EXPECT_FALSE(find_tiled_tile(0, tilesets).use);
}

TEST(TiledFiles, NamesWhoRefersToABrokenFile) {
  Fixture map;
  map.folder.write("a.tsx", "root:x:0:0\n");
  map.use_tileset(1, "a.tsx");
  EXPECT_EQ(map.error_of(with_gid(1)), (map.folder.path() / "a.tsx").string() +
                                           ": line 1, column 1: this is not a Tiled tileset: it begins with neither < "
                                           "(XML) nor { (JSON); m.tmx refers to it as a "
                                           "tileset in line 2, column 1");
}

TEST(TiledFiles, RefusesAFileOfAnotherKind) {
  Fixture map;
  map.folder.write("a.tsx", sheet);
  EXPECT_EQ(
      map.error_of(with_template("a.tsx")),
      (map.folder.path() / "a.tsx").string() +
          ": line 1, column 1: the file is a Tiled tileset, but a Tiled template is needed; check the reference to it; "
          "m.tmx refers to it as a template in line 2, column 1");
}

TEST(TiledFiles, RefusesATemplateThatIncludesItself) {
  Fixture map;
  map.folder.write("self.tx", "<template>\n <object template=\"self.tx\"/></template>");
  const std::string self = map.quoted_path("self.tx");
  EXPECT_EQ(map.error_of(with_template("self.tx")),
            (map.folder.path() / "self.tx").string() + ": line 2, column 2: the template includes itself: " + self +
                " -> " + self + "; the object in a template must not use that template");

  map.folder.write("a.tx", "<template><object template=\"t/b.tj\"/></template>");
  map.folder.write("t/b.tj", R"({"type": "template", "object": {"template": "../t/../a.tx"}})");
  EXPECT_NE(map.error_of(with_template("a.tx"))
                .find("the template includes itself: " + map.quoted_path("a.tx") + " -> " + map.quoted_path("t/b.tj") +
                      " -> " + map.quoted_path("a.tx")),
            std::string::npos);
}

TEST(TiledFiles, LimitsHowManyTemplatesAreMadeFromEachOther) {
  Fixture map;
  for (int i = 0; i < 20; ++i) {
    map.folder.write("t" + std::to_string(i) + ".tx",
                     "<template><object template=\"t" + std::to_string(i + 1) + ".tx\"/></template>");
  }
  map.folder.write("t20.tx", "<template><object width=\"1\"/></template>");
  EXPECT_NE(map.error_of(with_template("t0.tx")).find("nested deeper than 16 levels"), std::string::npos);
  EXPECT_EQ(map.error_of(with_template("t5.tx")), "no error");
}

TEST(TiledFiles, TellsXmlFromJsonByTheText) {
  EXPECT_TRUE(is_tiled_xml("<map/>"));
  EXPECT_TRUE(is_tiled_xml(" \r\n\t<?xml?>"));
  EXPECT_FALSE(is_tiled_xml("{\"a\": \"<\"}"));
  EXPECT_FALSE(is_tiled_xml(""));
}

}  // namespace
}  // namespace graze::io::tiled_files_test
