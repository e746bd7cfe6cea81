// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/tiled/map.hpp>
#include <graze/query/relation.hpp>

#include "io/scene_text.hpp"
#include "io/tiled_folder.hpp"

namespace graze::io::tiled_test {
namespace {

namespace fs = std::filesystem;
using Point = Vec<2, double>;
using Box = Aabb<2, double>;
using Shape = AnyShape<2, double>;

SceneFile read(std::string_view text) { return parse_tiled_map(text, "m.tmx", "nowhere"); }

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const Scene<2, double>& scene_of(const SceneFile& file) { return std::get<Scene<2, double>>(file.scene); }

std::vector<std::string> names_of(const SceneFile& file) {
  std::vector<std::string> names;
  for (const ObjectId id : scene_of(file).ids()) names.push_back(scene_of(file).object(id).name);
  return names;
}

std::string omissions_of(const SceneFile& file) {
  std::string text;
  for (const Omission& omission : file.omissions) text += std::to_string(omission.count) + " x " + omission.what + "; ";
  return text;
}

Box box_of(const SceneFile& file, std::string_view name) {
  const auto id = scene_of(file).find(name);
  EXPECT_TRUE(id) << name;
  return id ? scene_of(file).object(*id).box : Box{};
}

TEST(Tiled, SaysWhereASceneComesFromAndThatYPointsDown) {
  const SceneFile file = read("<map/>");
  EXPECT_EQ(file.source, "m.tmx");
  EXPECT_EQ(file.format, "tiled");
  EXPECT_EQ(file.y_axis, YAxis::down);
  EXPECT_EQ(scene_of(file).size(), 0U);
  EXPECT_TRUE(file.omissions.empty());
}

TEST(Tiled, AddsUpTheOffsetsOfGroupsAndLayers) {
  const SceneFile file = read(R"(<map><group name="a" offsetx="1000" offsety="-100"><group name="b" offsetx="200">
    <objectgroup name="c" offsetx="30" offsety="5"><object name="box" x="4" y="0.5" width="1" height="2"/></objectgroup>
    </group></group></map>)");
  EXPECT_EQ(box_of(file, "box"), (Box{{1234, -94.5}, {1235, -92.5}}));
  EXPECT_EQ(scene_of(file).layer_names(), std::vector<std::string>{"a/b/c"});
}

TEST(Tiled, PutsLayersOfOneNameTogetherAndKeepsOthersApart) {
  const SceneFile file = read(R"(<map><objectgroup name="a"><object name="1"/></objectgroup>
    <objectgroup name="b"><object name="2"/></objectgroup><objectgroup name="a"><object name="3"/></objectgroup>
    <group name="g"><objectgroup name="a"><object name="4"/></objectgroup></group>
    <objectgroup><object name="5"/></objectgroup><objectgroup name="empty"/></map>)");
  const Scene<2, double>& scene = scene_of(file);
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"a", "b", "g/a", "unnamed"}));
  std::vector<int> layers;
  for (const ObjectId id : scene.ids()) layers.push_back(scene.object(id).layer);
  EXPECT_EQ(layers, (std::vector<int>{0, 1, 0, 2, 3}));
}

TEST(Tiled, RefusesMoreLayersThanASceneHas) {
  std::string text = "<map>\n";
  for (int i = 0; i < 64; ++i) text += "<objectgroup name=\"" + std::to_string(i) + "\"><object/></objectgroup>\n";
  EXPECT_EQ(error_of(text + "<objectgroup name=\"5\"><object/></objectgroup></map>"), "no error");
  EXPECT_EQ(error_of(text + "<objectgroup name=\"last\"><object/></objectgroup></map>"),
            "m.tmx: line 66, column 26: layer \"last\" is one too many: a scene has at most 64 layers of different "
            "names");
}

TEST(Tiled, GivesEveryObjectAUniqueName) {
  const SceneFile file = read(R"(<map><objectgroup>
    <object id="1" name="hero"/> <object id="2" name="coin"/> <object id="3" name="coin"/> <object id="4"/>
    <object id="5" name="coin#2"/> <object id="5"/> <object id="5"/> <object/></objectgroup></map>)");
  EXPECT_EQ(names_of(file),
            (std::vector<std::string>{"hero", "coin#2+1", "coin#3", "#4", "coin#2", "#5", "#5+1", "#0"}));
}

TEST(Tiled, NamesTheObjectsOfATemplateByTheirIds) {
  const TiledFolder folder;
  folder.write("coin.tx", R"(<template><object name="coin" width="8" height="8"><ellipse/></object></template>)");
  const SceneFile file = parse_tiled_map(R"(<map><objectgroup name="l"><object id="11" template="coin.tx" x="1" y="2"/>
    <object id="12" template="coin.tx" x="3" y="4"/></objectgroup></map>)",
                                         "m.tmx", folder.path());
  EXPECT_EQ(names_of(file), (std::vector<std::string>{"coin#11", "coin#12"}));
  EXPECT_EQ(box_of(file, "coin#12"), (Box{{3, 4}, {11, 12}}));
}

TEST(Tiled, CountsWhatItDoesNotRead) {
  const SceneFile file = read(R"(<map orientation="spherical" infinite="1">
    <tileset firstgid="1" tilewidth="8" tileheight="8" tilecount="2">
     <tile id="0"><objectgroup><object/><object/></objectgroup></tile>
     <tile id="1"><objectgroup><object/></objectgroup></tile></tileset>
    <tileset firstgid="9" source="gone.tsx"/>
    <layer width="1" height="1"><data encoding="base64" compression="lz4">AAAA</data></layer>
    <layer width="1" height="1"><data encoding="base ier">AAAA</data></layer><imagelayer/>
    <objectgroup><object gid="1" type="x"/><object><text>hi</text></object>
     <object width="8" height="4"><ellipse/></object>
     <object><properties><property/></properties></object></objectgroup></map>)");
  EXPECT_EQ(
      omissions_of(file),
      "1 x tile layer in the format \"lz4\"; 1 x tile layer in the format \"base ier\"; 1 x image layer; "
      "1 x missing tileset; 1 x spherical projection of the map; 1 x object class; "
      "2 x collision shape of a tile object; 1 x text object; 1 x ellipse drawn as a 64-gon; 1 x custom property; ");
  EXPECT_EQ(scene_of(file).size(), 3U);
  EXPECT_EQ(file.omissions[0].loss, Loss::shape);
  EXPECT_EQ(file.omissions[0].where, "m.tmx, line 6, column 33");
  EXPECT_EQ(
      file.omissions[0].why,
      "graze cannot decompress it; choose CSV, or base64 uncompressed, in Tiled's map properties (Tile Layer Format)");
  EXPECT_EQ(file.omissions[1].why, file.omissions[0].why) << "no build of graze does";
}

TEST(Tiled, AnchorsTilesOfIsometricMapsAtTheMiddleOfTheirFoot) {
  const char* objects = R"( height="2" tilewidth="16" tileheight="8">
    <tileset firstgid="1" tilewidth="8" tileheight="6" tilecount="2"/><objectgroup>
    <object name="tile" gid="1" x="100" y="50"/></objectgroup></map>)";
  EXPECT_EQ(box_of(read("<map orientation=\"isometric\"" + std::string(objects)), "tile"), (Box{{62, 69}, {70, 75}}));
  EXPECT_EQ(box_of(read("<map orientation=\"staggered\"" + std::string(objects)), "tile"), (Box{{100, 44}, {108, 50}}));
}

/// A tileset of 16 x 16 tiles: 1 is full, 2 slopes up to the right, 3 has two shapes, 4 has none.
const std::string tiles = R"(<tileset firstgid="1" tilewidth="16" tileheight="16" tilecount="4">
  <tile id="0"><objectgroup><object width="16" height="16"/></objectgroup></tile>
  <tile id="1"><objectgroup><object x="0" y="16"><polygon points="0,0 16,0 16,-16"/></object></objectgroup></tile>
  <tile id="2"><objectgroup><object width="4" height="16"/><object x="12" width="4" height="16"/></objectgroup></tile>
  </tileset>)";

std::string map_of(const std::string& attributes, const std::string& rest) {
  return "<map tilewidth=\"16\" tileheight=\"16\" " + attributes + ">" + tiles + rest + "</map>";
}

TEST(Tiled, MakesObjectsOfTheCollisionShapesOfTiles) {
  const SceneFile file = read(map_of("", R"(<group name="g" offsetx="100"><layer name="walls" width="4" height="3"
    offsety="-8"><data encoding="csv">1,1,0,2, 1,1,3,4, 1,1,0,9</data></layer></group>)"));
  EXPECT_EQ(names_of(file),
            (std::vector<std::string>{"g/walls[3,0]", "g/walls[2,1]", "g/walls[2,1]#2", "g/walls[0..1,0..2]"}));
  EXPECT_EQ(box_of(file, "g/walls[0..1,0..2]"), (Box{{100, -8}, {132, 40}}));
  EXPECT_EQ(box_of(file, "g/walls[2,1]#2"), (Box{{144, 8}, {148, 24}}));
  EXPECT_EQ(box_of(file, "g/walls[3,0]"), (Box{{148, -8}, {164, 8}}));
  EXPECT_EQ(scene_of(file).layer_names(), std::vector<std::string>{"g/walls"});
  EXPECT_EQ(omissions_of(file), "1 x tile without collision shape; 1 x tile that no tileset holds; ");
  for (const ObjectId id : scene_of(file).ids()) EXPECT_EQ(scene_of(file).object(id).mobility, Mobility::fixed);
  EXPECT_TRUE(scene_of(file).pairs().empty()) << "tiles of a layer touch each other, but are no pairs";
}

TEST(Tiled, LetsObjectsTouchTiles) {
  const SceneFile file = read(map_of("", R"(<layer name="l" width="2" height="1"><data encoding="csv">1,2</data></layer>
    <objectgroup name="l"><object name="l[1,0]" x="14" y="2" width="4" height="4"/></objectgroup>)"));
  EXPECT_EQ(names_of(file), (std::vector<std::string>{"l[1,0]+", "l[0,0]", "l[1,0]"})) << "no name is given twice";
  ASSERT_EQ(scene_of(file).pairs().size(), 1U) << "the slope is below the box";
}

TEST(Tiled, MergesFullTilesAcrossChunks) {
  const SceneFile file = read(map_of("infinite=\"1\"", R"(<layer name="l"><data encoding="csv">
    <chunk x="0" y="-1" width="2" height="2">1,1,1,1</chunk><chunk x="-2" y="-1" width="2" height="2">1,1,0,1</chunk>
    </data></layer>)"));
  EXPECT_EQ(names_of(file), (std::vector<std::string>{"l[-2..1,-1]", "l[-1..1,0]"}));
  EXPECT_EQ(box_of(file, "l[-2..1,-1]"), (Box{{-32, -16}, {32, 0}}));
}

TEST(Tiled, FlipsAndTurnsTiles) {
  // The slope's right angle: at the bottom right, left, top right, top left.
  const auto right_angle = [](std::uint32_t flips) {
    const SceneFile file = read(map_of("", "<layer name=\"l\" width=\"1\" height=\"1\"><data encoding=\"csv\">" +
                                               std::to_string(flips | 2U) + "</data></layer>"));
    const auto& slope = std::get<Polytope<2, double>>(scene_of(file).object(*scene_of(file).find("l[0,0]")).shape);
    Point sum(0.0);
    for (const Point& corner : slope.vertices()) sum += corner;
    return Point(sum.x > 24 ? 16 : 0, sum.y > 24 ? 16 : 0);
  };
  EXPECT_EQ(right_angle(0), Point(16, 16));
  EXPECT_EQ(right_angle(0x80000000U), Point(0, 16));
  EXPECT_EQ(right_angle(0x40000000U), Point(16, 0));
  EXPECT_EQ(right_angle(0xC0000000U), Point(0, 0));
  EXPECT_EQ(right_angle(0x20000000U), Point(16, 16)) << "mirrored at the diagonal, on which its corner is";
  EXPECT_EQ(right_angle(0xA0000000U), Point(0, 16)) << "a quarter turn clockwise";
  EXPECT_EQ(right_angle(0x60000000U), Point(16, 0)) << "one back";
}

TEST(Tiled, MergesFullCellsOfIsometricMaps) {
  const SceneFile file = read(R"(<map orientation="isometric" height="4" tilewidth="64" tileheight="32">
    <tileset firstgid="1" tilewidth="64" tileheight="64" tilecount="1"><tile id="0"><objectgroup>
     <object x="0" y="48"><polygon points="0,0 32,-16 64,0 32,16"/></object></objectgroup></tile></tileset>
    <layer name="l" width="4" height="4"><data encoding="csv">0,0,0,0, 1,1,1,0, 1,1,1,0, 0,0,0,0</data></layer></map>)");
  EXPECT_EQ(names_of(file), std::vector<std::string>{"l[0..2,1..2]"});
  EXPECT_EQ(box_of(file, "l[0..2,1..2]"), (Box{{32, 16}, {192, 96}}));
}

TEST(Tiled, SaysThatTilesHaveNoShapes) {
  const SceneFile file = read(map_of("", R"(<layer width="2" height="1"><data encoding="csv">4,4</data></layer>)"));
  EXPECT_EQ(scene_of(file).size(), 0U);
  EXPECT_TRUE(scene_of(file).layer_names().empty());
  EXPECT_EQ(omissions_of(file), "2 x tile without collision shape; ");
  EXPECT_EQ(file.omissions[0].loss, Loss::none);
}

TEST(Tiled, ReadsHiddenObjectsAndLayers) {
  const SceneFile file =
      read(R"(<map><objectgroup name="l" visible="0"><object name="a" visible="0"/></objectgroup></map>)");
  EXPECT_EQ(names_of(file), std::vector<std::string>{"a"});
}

TEST(Tiled, AcceptsAByteOrderMark) { EXPECT_EQ(scene_of(read("\xef\xbb\xbf<map/>")).size(), 0U); }

TEST(Tiled, RefusesCoordinatesWhoseSumOverflows) {
  EXPECT_EQ(
      error_of(
          "<map><objectgroup>\n <object id=\"3\" x=\"1.7e308\" width=\"1.7e308\" height=\"1\"/></objectgroup></map>"),
      "m.tmx: line 2, column 2: the object (id 3) is too large: its coordinates exceed the largest number, about "
      "1.8e308");
  for (const char* outline : {R"(<polygon points="0,0 1.7e308,0 0,1"/>)", R"(<polyline points="0,0 1.7e308,0 0,1"/>)",
                              "<ellipse/>", "<capsule/>", "<point/>"}) {
    const std::string text = "<map><objectgroup offsetx=\"1.7e308\"><object x=\"1.7e308\" width=\"2\" height=\"1\">" +
                             std::string(outline) + "</object></objectgroup></map>";
    EXPECT_NE(error_of(text).find("too large"), std::string::npos) << outline;
  }
}

TEST(Tiled, AllocatesNothingByDeclaredSizes) {
  EXPECT_EQ(error_of(R"(<map width="1000000000" height="1000000000"><tileset firstgid="1" tilewidth="1" tileheight="1"
    tilecount="4294967295" columns="1000000000"/><layer width="1000000000" height="1000000000"/></map>)"),
            "no error");
}

// One map in both formats, with references that cross from each format to the other.
constexpr std::string_view twin_xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<map orientation="orthogonal" width="10" height="10" tilewidth="32" tileheight="32">
 <properties><property name="p" value="1"/></properties>
 <tileset firstgid="1" source="sets/tiles.tsj"/>
 <tileset firstgid="10" tilewidth="64" tileheight="48" tilecount="2" objectalignment="top"/>
 <layer name="back" width="2" height="1"><data encoding="csv">1,2</data></layer>
 <objectgroup name="ground" offsetx="0.25">
  <object id="1" name="block" x="0.1" y="64" width="96.7" height="32"/>
  <object id="2" x="10" y="20" width="30" height="8" rotation="12.5"/>
  <object id="3" name="slope"><polygon points="0,0 64,0 64,-32"/></object>
  <object id="4" name="cave" x="200" y="0"><polygon points="0,0 64,0 64,64 32,16 0,64"/></object>
 </objectgroup>
 <group name="more" offsety="8">
  <objectgroup name="things">
   <object id="5" name="coin" template="parts/coin.tj" x="5" y="6"/>
   <object id="6" name="coin" gid="2147483650" x="50" y="60"/>
   <object id="7" gid="11" x="70" y="80" rotation="90"/>
   <object id="8" name="pill" x="1" y="2" width="3" height="9"><capsule/></object>
   <object id="9" name="spawn" x="3.5" y="4"><point/></object>
   <object id="10" name="path"><polyline points="0,0 5,5 10,0"/></object>
   <object id="11" name="egg" width="4" height="6"><ellipse/></object>
   <object id="12"><text>words</text></object>
  </objectgroup>
 </group>
</map>
)";

constexpr std::string_view twin_json = R"({"type": "map", "orientation": "orthogonal", "width": 10, "height": 10,
 "tilewidth": 32, "tileheight": 32, "properties": [{"name": "p", "type": "string", "value": "1"}],
 "tilesets": [{"firstgid": 1, "source": "sets/tiles.tsx"},
  {"firstgid": 10, "tilewidth": 64, "tileheight": 48, "tilecount": 2, "objectalignment": "top"}],
 "layers": [{"type": "tilelayer", "name": "back", "width": 2, "height": 1, "data": [1, 2]},
  {"type": "objectgroup", "name": "ground", "offsetx": 0.25, "objects": [
   {"id": 1, "name": "block", "x": 0.1, "y": 64, "width": 96.7, "height": 32},
   {"id": 2, "name": "", "x": 10, "y": 20, "width": 30, "height": 8, "rotation": 12.5},
   {"id": 3, "name": "slope", "polygon": [{"x": 0, "y": 0}, {"x": 64, "y": 0}, {"x": 64, "y": -32}]},
   {"id": 4, "name": "cave", "x": 200, "y": 0, "polygon": [{"x": 0, "y": 0}, {"x": 64, "y": 0}, {"x": 64, "y": 64},
     {"x": 32, "y": 16}, {"x": 0, "y": 64}]}]},
  {"type": "group", "name": "more", "offsety": 8, "layers": [
   {"type": "objectgroup", "name": "things", "objects": [
    {"id": 5, "name": "coin", "template": "parts/coin.tx", "x": 5, "y": 6},
    {"id": 6, "name": "coin", "gid": 2147483650, "x": 50, "y": 60},
    {"id": 7, "gid": 11, "x": 70, "y": 80, "rotation": 90},
    {"id": 8, "name": "pill", "x": 1, "y": 2, "width": 3, "height": 9, "capsule": true},
    {"id": 9, "name": "spawn", "x": 3.5, "y": 4, "point": true},
    {"id": 10, "name": "path", "polyline": [{"x": 0, "y": 0}, {"x": 5, "y": 5}, {"x": 10, "y": 0}]},
    {"id": 11, "name": "egg", "width": 4, "height": 6, "ellipse": true},
    {"id": 12, "text": {"text": "words"}}]}]}]}
)";

TEST(Tiled, ReadsTheSameSceneFromXmlAndJson) {
  const TiledFolder folder;
  folder.write("sets/tiles.tsx", R"(<tileset tilewidth="32" tileheight="24" tilecount="4"/>)");
  folder.write("sets/tiles.tsj", R"({"type": "tileset", "tilewidth": 32, "tileheight": 24, "tilecount": 4})");
  folder.write("parts/coin.tx",
               R"(<template><tileset firstgid="1" source="../sets/tiles.tsj"/><object gid="3"/></template>)");
  folder.write("parts/coin.tj", R"({"type": "template", "tileset": {"firstgid": 1, "source": "../sets/tiles.tsx"},
    "object": {"gid": 3}})");
  const SceneFile xml = parse_tiled_map(twin_xml, "twin", folder.path());
  const SceneFile json = parse_tiled_map(twin_json, "twin", folder.path());
  std::ostringstream xml_scene;
  std::ostringstream json_scene;
  write_json_scene(xml_scene, xml);
  write_json_scene(json_scene, json);
  EXPECT_EQ(xml_scene.str(), json_scene.str());
  EXPECT_EQ(scene_of(xml).size(), 11U);
  EXPECT_EQ(omissions_of(xml), omissions_of(json));
  EXPECT_EQ(omissions_of(xml),
            "1 x custom property; 2 x tile without collision shape; 1 x ellipse drawn as a 64-gon; 1 x text object; ");
  EXPECT_EQ(box_of(xml, "coin#5"), (Box{{5, -10}, {37, 14}}));
  EXPECT_EQ(box_of(xml, "#7"), (Box{{22, 56}, {70, 120}})) << "64 x 48 at (70, 88), hanging from its top, then turned";
}

// The bundled level and real ones.

SceneFile read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return parse_tiled_map(text, path.filename().string(), path.parent_path());
}

struct PairCounts {
  std::size_t touching = 0;
  std::size_t overlapping = 0;

  friend bool operator==(const PairCounts&, const PairCounts&) = default;
};

PairCounts count_pairs(const Scene<2, double>& scene) {
  PairCounts counts;
  for (const ObjectPair pair : scene.pairs()) {
    const Relation found = relation(scene.object(pair.a).shape, scene.object(pair.b).shape);
    (found == Relation::touching ? counts.touching : counts.overlapping) += 1;
  }
  return counts;
}

/// The scene with every box, rotated or not, larger by `margin` on all sides.
Scene<2, double> inflated(const Scene<2, double>& scene, double margin) {
  Scene<2, double> result;
  for (const ObjectId id : scene.ids()) {
    Shape shape = scene.object(id).shape;
    if (auto* box = std::get_if<Box>(&shape)) *box = {box->min - margin, box->max + margin};
    if (auto* box = std::get_if<Obb<2, double>>(&shape)) box->half_extents += margin;
    result.add(std::move(shape));
  }
  return result;
}

TEST(Tiled, ReadsTheBundledPlatformLevel) {
  const SceneFile file = read_file(project_file("data/platform_level.tmx"));
  EXPECT_EQ(scene_of(file).size(), 98U);
  EXPECT_EQ(omissions_of(file),
            "40 x tile without collision shape; 52 x object class; 1 x text object; 2 x ellipse drawn as a 64-gon; "
            "4 x collision shape of a tile object; ");
  EXPECT_EQ(scene_of(file).layer_names(),
            (std::vector<std::string>{"ground", "props", "coins", "hazards", "actors", "machines/platforms",
                                      "machines/paths", "zones", "bounds"}));
  EXPECT_EQ(box_of(file, "lift"), (Box{{336, 408}, {384, 420}})) << "y 432, group -16, layer -8";
  EXPECT_EQ(box_of(file, "hero"), (Box{{144, 464}, {168, 512}})) << "stands on the meadow, y 512";
  EXPECT_EQ(box_of(file, "cave"), (Box{{960, 258}, {1280, 640}}));
}

fs::path sticker_knight(const std::string& name) { return shared_file("sticker-knight/" + name); }

TEST(Tiled, FindsTheKnownPairsOfSandbox2) {
  const fs::path path = sticker_knight("sandbox2.tmx");
  if (!fs::exists(path)) GTEST_SKIP() << "there is no " << path << "; set GRAZE_SHARED_DATA to the shared data folder";
  const SceneFile file = read_file(path);
  EXPECT_EQ(scene_of(file).size(), 103U);
  EXPECT_EQ(count_pairs(scene_of(file)), (PairCounts{74, 104}));
  EXPECT_EQ(omissions_of(file), "85 x custom property; 15 x object class; ");
}

TEST(Tiled, FindsTheKnownPairsOfSandbox) {
  const fs::path path = sticker_knight("sandbox.tmx");
  if (!fs::exists(path)) GTEST_SKIP() << "there is no " << path << "; set GRAZE_SHARED_DATA to the shared data folder";
  const SceneFile file = read_file(path);
  const Scene<2, double>& scene = scene_of(file);
  EXPECT_EQ(scene.size(), 114U);
  // 361 pairs overlap by more than 1e-9, 84 more touch within 1e-9.
  EXPECT_EQ(inflated(scene, 0.5e-9).pairs().size(), 445U);
  EXPECT_EQ(inflated(scene, -0.5e-9).pairs().size(), 361U);
}

}  // namespace
}  // namespace graze::io::tiled_test
