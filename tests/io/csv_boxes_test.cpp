// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/csv_boxes.hpp>

#include "scene_text.hpp"

namespace graze::io::csv_boxes_test {
namespace {

using Scene2 = Scene<2, double>;
using Scene3 = Scene<3, double>;

const std::string header = "id,min_x,min_y,max_x,max_y\n";

Scene2 read_2d(const std::string& text) { return std::get<Scene2>(parse_csv_boxes(text, "a.csv").scene); }

std::string refusal(const std::string& text) {
  return error_of([&text] { parse_csv_boxes(text, "a.csv"); });
}

Aabb<2, double> box_named(const Scene2& scene, const std::string& name) {
  return std::get<Aabb<2, double>>(scene.object(scene.find(name).value()).shape);
}

TEST(CsvBoxes, BoxesIn2dAreReadInOrder) {
  const SceneFile file = parse_csv_boxes(header + "b,0,1,2,3\na,-1.5,1e3,.5,1E+4\n", "a.csv");
  EXPECT_EQ(file.format, "csv");
  EXPECT_EQ(file.source, "a.csv");
  EXPECT_EQ(file.y_axis, YAxis::up);
  EXPECT_TRUE(file.omissions.empty());
  const auto& scene = std::get<Scene2>(file.scene);
  EXPECT_EQ(scene.object(scene.ids()[0]).name, "b");
  EXPECT_EQ(box_named(scene, "b"), (Aabb<2, double>{{0, 1}, {2, 3}}));
  EXPECT_EQ(box_named(scene, "a"), (Aabb<2, double>{{-1.5, 1000}, {0.5, 10000}}));
  EXPECT_TRUE(scene.layer_names().empty());
}

TEST(CsvBoxes, ColumnsOfZMakeIt3dAndStandInAnyOrder) {
  const SceneFile file = parse_csv_boxes("max_z,id,min_x,min_y,min_z,max_x,max_y\n6,a,1,2,3,4,5\n", "a.csv");
  const auto& scene = std::get<Scene3>(file.scene);
  EXPECT_EQ((std::get<Aabb<3, double>>(scene.object(scene.find("a").value()).shape)),
            (Aabb<3, double>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(CsvBoxes, CrlfByteOrderMarkQuotesAndBlanksAreUnderstood) {
  const Scene2 scene = read_2d(
      "\xEF\xBB\xBF"
      "id, min_x,min_y ,max_x,max_y\r\n\"a \"\"1\"\", b\", 1,2 ,\t3,\"4\"\r\n\r\n");
  EXPECT_EQ(box_named(scene, "a \"1\", b"), (Aabb<2, double>{{1, 2}, {3, 4}}));
}

TEST(CsvBoxes, AHeaderAloneIsAnEmptyScene) { EXPECT_EQ(read_2d(header).size(), 0U); }

TEST(CsvBoxes, LayersAreNumberedAsTheyAppear) {
  const Scene2 scene = read_2d("layer,id,min_x,min_y,max_x,max_y\nmetal,a,0,0,1,1\n,b,0,0,1,1\nmetal,c,0,0,1,1\n");
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"metal", "default"}));
  EXPECT_EQ(scene.object(scene.find("a").value()).layer, 0);
  EXPECT_EQ(scene.object(scene.find("b").value()).layer, 1);
  EXPECT_EQ(scene.object(scene.find("c").value()).layer, 0);
}

TEST(CsvBoxes, FurtherColumnsAreCountedAsOmissions) {
  const SceneFile file =
      parse_csv_boxes("id,colour,min_x,min_y,max_x,max_y,net\na,red,0,0,1,1,n\nb,red,0,0,1,1,n\n", "a.csv");
  ASSERT_EQ(file.omissions.size(), 2U);
  EXPECT_EQ(file.omissions[0].what, "column \"colour\"");
  EXPECT_EQ(file.omissions[0].count, 1U);
  EXPECT_EQ(file.omissions[1].what, "column \"net\"");
}

TEST(CsvBoxes, WrongHeadersAreNamed) {
  EXPECT_EQ(refusal("name,min_x,min_y,max_x,max_y\n"),
            "a.csv: line 1, column 1: there is no column \"id\"; boxes need id, min_x, min_y, max_x, max_y, "
            "in 3D also min_z, max_z");
  EXPECT_EQ(refusal("id,min_x,Min-Y,max_x,max_y\n"),
            "a.csv: line 1, column 1: there is no column \"min_y\"; is it the one called \"Min-Y\"?");
  EXPECT_EQ(refusal("id,min_x,min_y,max_x,max_y,min_z\n").find("a.csv: line 1, column 1: there is no column \"max_z\""),
            0U);
  EXPECT_EQ(refusal("id,min_x,min_y,min_x,max_x,max_y\n"),
            "a.csv: line 1, column 16: column \"min_x\" appears twice, as number 2 and 4");
  EXPECT_EQ(refusal(""), "a.csv: empty; CSV begins with a line like id,min_x,min_y,max_x,max_y");
}

TEST(CsvBoxes, AHugeHeaderIsRefusedQuickly) {
  std::string text = "id";
  for (int i = 0; i < 300000; ++i) text += ",c" + std::to_string(i);
  EXPECT_EQ(refusal(text + "\n").find("a.csv: line 1, column 1: there is no column \"min_x\""), 0U);
}

TEST(CsvBoxes, WrongLinesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"a,1,2,3\n", "1: this line has 4 fields, the header has 5"},
      {"a\n", "1: this line has 1 field, the header has 5"},
      {"a,1,2,3,4,5\n", "1: this line has 6 fields, the header has 5"},
      {",1,2,3,4\n", "1: the id is empty; each box needs its own"},
      {"a,x,2,3,4\n", "3: min_x is \"x\", which is not a number"},
      {"a,,2,3,4\n", "3: min_x is \"\", which is not a number"},
      {"a,1,2,3,4mm\n", "9: max_y is \"4mm\", which is not a number"},
      {"a,1,2,3,0x10\n", "9: max_y is \"0x10\", which is not a number"},
      {"a,1,2,3,\"1,5\"\n", "9: max_y is \"1,5\", which is not a number"},
      {"a,1,2,nan,4\n", "7: max_x is \"nan\"; it must be a finite number"},
      {"a,-inf,2,3,4\n", "3: min_x is \"-inf\"; it must be a finite number"},
      {"a,1,infinity,3,4\n", "5: min_y is \"infinity\"; it must be a finite number"},
      {"a,1,2,1e999,4\n", "7: max_x is \"1e999\", beyond the largest number there is, about 1.8e308"},
      {"a,1,2,0.5,4\n", "3: min_x is above max_x: 1 > 0.5"},
  };
  for (const auto& [line, expected] : table) EXPECT_EQ(refusal(header + line), "a.csv: line 2, column " + expected);
}

TEST(CsvBoxes, ARepeatedIdIsNamedWithBothLines) {
  EXPECT_EQ(
      refusal(header + "a,1,2,3,4\n\nb,1,2,3,4\n  \"\",1,2,3,4\n").find("a.csv: line 5, column 3: a quote inside"), 0U);
  EXPECT_EQ(refusal(header + "a,1,2,3,4\n\nb,1,2,3,4\na,5,6,7,8\n"),
            "a.csv: line 5, column 1: the id \"a\" is taken by the box in line 2; ids must be unique");
}

TEST(CsvBoxes, ThereAreAtMost64Layers) {
  std::string text = "id,min_x,min_y,max_x,max_y,layer\n";
  for (int i = 0; i <= 64; ++i) text += std::to_string(i) + ",0,0,1,1,l" + std::to_string(i) + "\n";
  EXPECT_EQ(refusal(text), "a.csv: line 66, column 12: the layer \"l64\" is one too many; a scene has at most 64");
}

TEST(CsvBoxes, TextThatIsNotUtf8IsRefused) {
  EXPECT_EQ(refusal(header + "\xE9,1,2,3,4\n").find("a.csv: line 2, column 1: byte 0xE9 is not text in UTF-8"), 0U);
}

TEST(CsvBoxes, TheExampleOfTheDocumentationIsRead) {
  const std::string example = code_block(text_of(project_file("docs/scene_format.md")), "csv");
  const Scene2 scene = read_2d(example);
  EXPECT_EQ(scene.size(), 3U);
  EXPECT_EQ(box_named(scene, "cell \"3\", spare"), (Aabb<2, double>{{30.5, 0}, {40, 12}}));
  EXPECT_EQ(scene.pairs().size(), 1U);
}

TEST(CsvBoxes, ARealChipIsReadWhole) {
  const char* variable = std::getenv("GRAZE_SHARED_DATA");
  const std::filesystem::path folder =
      variable == nullptr ? project_file("../shared/data") : std::filesystem::path(variable);
  if (!std::filesystem::exists(folder / "chip_aes.csv")) GTEST_SKIP() << "there is no " << folder / "chip_aes.csv";
  const Scene2 scene = read_2d(text_of(folder / "chip_aes.csv"));
  EXPECT_EQ(scene.size(), 21340U);
  EXPECT_EQ(box_named(scene, "_18498_"), (Aabb<2, double>{{597540, 615019}, {600200, 617819}}));
  EXPECT_EQ(scene.pairs().size(), 26815U);
}

}  // namespace
}  // namespace graze::io::csv_boxes_test
