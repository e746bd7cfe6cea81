// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/csv/scene.hpp>

#include "io/scene_text.hpp"

namespace graze::io::csv_scene_test {
namespace {

using Scene2 = Scene<2, double>;
using Scene3 = Scene<3, double>;

const std::string header = "id,min_x,min_y,max_x,max_y\n";

Scene2 read_2d(const std::string& text) { return std::get<Scene2>(parse_csv_scene(text, "a.csv").scene); }

std::string refusal(const std::string& text) {
  return error_of([&text] { parse_csv_scene(text, "a.csv"); });
}

Aabb<2, double> box_named(const Scene2& scene, const std::string& name) {
  return std::get<Aabb<2, double>>(scene.object(scene.find(name).value()).shape);
}

TEST(CsvScene, BoxesIn2dAreReadInOrder) {
  const SceneFile file = parse_csv_scene(header + "b,0,1,2,3\na,-1.5,1e3,.5,1E+4\n", "a.csv");
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

TEST(CsvScene, ColumnsOfZMakeIt3dAndStandInAnyOrder) {
  const SceneFile file = parse_csv_scene("max_z,id,min_x,min_y,min_z,max_x,max_y\n6,a,1,2,3,4,5\n", "a.csv");
  const auto& scene = std::get<Scene3>(file.scene);
  EXPECT_EQ((std::get<Aabb<3, double>>(scene.object(scene.find("a").value()).shape)),
            (Aabb<3, double>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(CsvScene, CrlfByteOrderMarkQuotesAndBlanksAreUnderstood) {
  const Scene2 scene = read_2d(
      "\xEF\xBB\xBF"
      "id, min_x,min_y ,max_x,max_y\r\n\"a \"\"1\"\", b\", 1,2 ,\t3,\"4\"\r\n\r\n");
  EXPECT_EQ(box_named(scene, "a \"1\", b"), (Aabb<2, double>{{1, 2}, {3, 4}}));
}

TEST(CsvScene, AHeaderAloneIsAnEmptyScene) { EXPECT_EQ(read_2d(header).size(), 0U); }

TEST(CsvScene, LayersAreNumberedAsTheyAppear) {
  const Scene2 scene = read_2d("layer,id,min_x,min_y,max_x,max_y\nmetal,a,0,0,1,1\n,b,0,0,1,1\nmetal,c,0,0,1,1\n");
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"metal", "default"}));
  EXPECT_EQ(scene.object(scene.find("a").value()).layer, 0);
  EXPECT_EQ(scene.object(scene.find("b").value()).layer, 1);
  EXPECT_EQ(scene.object(scene.find("c").value()).layer, 0);
}

TEST(CsvScene, FurtherColumnsAreCountedAsOmissions) {
  const SceneFile file =
      parse_csv_scene("id,colour,min_x,min_y,max_x,max_y,net\na,red,0,0,1,1,n\nb,red,0,0,1,1,n\n", "a.csv");
  ASSERT_EQ(file.omissions.size(), 2U);
  EXPECT_EQ(file.omissions[0].what, "column \"colour\"");
  EXPECT_EQ(file.omissions[0].count, 1U);
  EXPECT_EQ(file.omissions[1].what, "column \"net\"");
}

TEST(CsvScene, WrongHeadersAreNamed) {
  for (const std::string id : {"name", "ID", "Name"}) {
    EXPECT_EQ(refusal(id + ",min_x,min_y,max_x,max_y\n"),
              "a.csv: line 1, column 1: there is no column \"id\"; is it the one called \"" + id + "\"?");
  }
  EXPECT_EQ(refusal("id,min_x,Min-Y,max_x,max_y\n"),
            "a.csv: line 1, column 1: there is no column \"min_y\"; is it the one called \"Min-Y\"?");
  EXPECT_EQ(refusal("id,min_x,min_y,max_x,max_y,min_z\n").find("a.csv: line 1, column 1: there is no column \"max_z\""),
            0U);
  EXPECT_EQ(refusal("id,min_x,min_y,min_x,max_x,max_y\n"),
            "a.csv: line 1, column 16: column \"min_x\" appears twice, as number 2 and 4");
  EXPECT_EQ(refusal("wall,0,0,2.5,1\n")
                .find("a.csv: line 1, column 6: the first line holds numbers such as 0; it must be "
                      "a header that names the columns: boxes need min_x"),
            0U);
  EXPECT_EQ(refusal("0,0,1e3\n").find("a.csv: line 1, column 1: the first line holds numbers"), 0U);
  EXPECT_EQ(refusal(""), "a.csv: empty; CSV begins with a line like id,min_x,min_y,max_x,max_y");
}

TEST(CsvScene, AHugeHeaderIsRefusedQuickly) {
  std::string text = "id";
  for (int i = 0; i < 300000; ++i) text += ",c" + std::to_string(i);
  EXPECT_EQ(refusal(text + "\n").find("a.csv: line 1, column 1: there is no column \"min_x\""), 0U);
}

TEST(CsvScene, WrongLinesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"a,1,2,3\n", "1: this line has 4 fields, the header has 5"},
      {"a\n", "1: this line has 1 field, the header has 5"},
      {"a,1,2,3,4,5\n", "1: this line has 6 fields, the header has 5"},
      {",1,2,3,4\n", "1: the id is empty; each box needs its own"},
      {"a,x,2,3,4\n", "3: min_x is \"x\", which is not a number"},
      {"a,,2,3,4\n", "3: min_x is \"\", which is not a number"},
      {"a,1,2,3,4mm\n", "9: max_y is \"4mm\", which is not a number"},
      {"a,1,2,3,0x10\n", "9: max_y is \"0x10\", which is not a number"},
      {"a,1,2,3,\"1,5\"\n", "9: max_y is \"1,5\", which is not a number; write decimals with a point"},
      {"a,1,2,3,++4\n", "9: max_y is \"++4\", which is not a number"},
      {"a,1,2,3,+-4\n", "9: max_y is \"+-4\", which is not a number"},
      {"a,1,2,3,+\n", "9: max_y is \"+\", which is not a number"},
      {"a,1,2,nan,4\n", "7: max_x is \"nan\"; it must be a finite number"},
      {"a,-inf,2,3,4\n", "3: min_x is \"-inf\"; it must be a finite number"},
      {"a,1,infinity,3,4\n", "5: min_y is \"infinity\"; it must be a finite number"},
      {"a,1,2,1e999,4\n", "7: max_x is \"1e999\"; the largest number is about 1.8e308"},
      {"a,1,2,0.5,4\n", "3: min_x is above max_x: 1 > 0.5"},
  };
  for (const auto& [line, expected] : table) EXPECT_EQ(refusal(header + line), "a.csv: line 2, column " + expected);
}

/// The first object of a table of which everything is read.
template <class Shape, Dim N>
Shape first_shape(const std::string& text) {
  const SceneFile file = parse_csv_scene(text, "a.csv");
  EXPECT_TRUE(file.omissions.empty());
  const auto& scene = std::get<Scene<N, double>>(file.scene);
  return std::get<Shape>(scene.object(scene.ids().at(0)).shape);
}

TEST(CsvScene, CirclesSpheresAndCapsulesAreToldByTheirColumns) {
  const auto circle = first_shape<Sphere<2, double>, 2>("x,y,radius\n1,2,3\n");
  EXPECT_EQ(circle.center, (Vec<2, double>(1, 2)));
  EXPECT_EQ(circle.radius, 3);
  const auto sphere = first_shape<Sphere<3, double>, 3>("id,radius,z,y,x\na,4,3,2,1\n");
  EXPECT_EQ(sphere.center, (Vec<3, double>(1, 2, 3)));
  EXPECT_EQ(sphere.radius, 4);
  const auto capsule = first_shape<Capsule<2, double>, 2>("ax,ay,bx,by,radius\n1,2,3,4,0\n");
  EXPECT_EQ(capsule.a, (Vec<2, double>(1, 2)));
  EXPECT_EQ(capsule.b, (Vec<2, double>(3, 4)));
  EXPECT_EQ(capsule.radius, 0);
  const auto pipe = first_shape<Capsule<3, double>, 3>("ax,ay,az,bx,by,bz,radius,layer\n1,2,3,4,5,6,7,pipes\n");
  EXPECT_EQ(pipe.a, (Vec<3, double>(1, 2, 3)));
  EXPECT_EQ(pipe.b, (Vec<3, double>(4, 5, 6)));
  EXPECT_EQ(pipe.radius, 7);
}

TEST(CsvScene, WrongRoundShapesAreNamed) {
  EXPECT_EQ(refusal("x,y,radius\n1,2,-3\n"), "a.csv: line 2, column 5: the radius is -3; it must be 0 or more");
  EXPECT_EQ(refusal("x,y\n1,2\n").find("a.csv: line 1, column 1: there is no column \"radius\"; boxes need "), 0U);
  EXPECT_EQ(refusal("radius\n1\n").find("a.csv: line 1, column 1: there is no column \"x\""), 0U);
  EXPECT_EQ(refusal("X,Y,Radius\n1,2,3\n"),
            "a.csv: line 1, column 1: there is no column \"x\"; is it the one called \"X\"?");
  EXPECT_EQ(refusal("ax,ay,bx,radius\n1,2,3,4\n").find("a.csv: line 1, column 1: there is no column \"by\""), 0U);
  EXPECT_EQ(refusal("id,x,y,radius\na,0,0,1\na,0,0,1\n"),
            "a.csv: line 3, column 1: the id \"a\" is taken by the circle in line 2; ids must be unique");
}

TEST(CsvScene, ObjectsWithoutIdsAreNamedByTheirNumber) {
  const Scene2 scene = read_2d("x,y,radius\n0,0,1\n5,5,1\n");
  EXPECT_EQ(scene.object(scene.ids().at(0)).name, "#0");
  EXPECT_EQ(scene.object(scene.ids().at(1)).name, "#1");
}

TEST(CsvScene, ColumnsOfOtherShapesAreNotRead) {
  const SceneFile file = parse_csv_scene("min_x,min_y,max_x,max_y,radius\n0,0,1,1,1\n", "a.csv");
  ASSERT_EQ(file.omissions.size(), 1U);
  EXPECT_EQ(file.omissions[0].what, "column \"radius\"");
}

TEST(CsvScene, SemicolonsTabsPlusSignsAndLinesThatEndWithCrAreUnderstood) {
  const Aabb<2, double> expected{{1, -2}, {3, 4}};
  EXPECT_EQ(box_named(read_2d("id;min_x;min_y;max_x;max_y\na, b;+1;-2;+3e0;4\n"), "a, b"), expected);
  EXPECT_EQ(box_named(read_2d("id\tmin_x\tmin_y\tmax_x\tmax_y\r\na\t1\t-2\t3\t4\r\n"), "a"), expected);
  EXPECT_EQ(box_named(read_2d("id,min_x,min_y,max_x,max_y\ra,1,-2,3,4\rb,0,0,1,1\r"), "a"), expected);
  EXPECT_EQ(read_2d("layer\tx\ty\tradius\n\t1\t2\t3\n").size(), 1U) << "an empty first field";
  EXPECT_EQ(refusal("id,min_x,min_y,max_x,max_y\ra,1,x,3,4\r").find("a.csv: line 2, column 5: min_y"), 0U);
  EXPECT_EQ(refusal("id;min_x;min_y;max_x;max_y\na;0,5;0;1;1\n"),
            "a.csv: line 2, column 3: min_x is \"0,5\", which is not a number; write decimals with a point");
}

TEST(CsvScene, ALastLineWithoutLineBreakIsDoubtful) {
  const auto warnings = [](const std::string& text) { return parse_csv_scene(text, "a.csv").warnings; };
  EXPECT_TRUE(warnings(header + "a,0,0,1,12\n").empty());
  EXPECT_TRUE(warnings("id,min_x,min_y,max_x,max_y\ra,0,0,1,12\r").empty());
  ASSERT_EQ(warnings(header + "a,0,0,1,12").size(), 1U);
  EXPECT_EQ(warnings(header + "a,0,0,1,12").front(),
            "a.csv: line 2, the last one, has no line break; if the file was cut off, its last field is incomplete");
}

TEST(CsvScene, ARepeatedIdIsNamedWithBothLines) {
  EXPECT_EQ(
      refusal(header + "a,1,2,3,4\n\nb,1,2,3,4\n  \"\",1,2,3,4\n").find("a.csv: line 5, column 3: a quote inside"), 0U);
  EXPECT_EQ(refusal(header + "a,1,2,3,4\n\nb,1,2,3,4\na,5,6,7,8\n"),
            "a.csv: line 5, column 1: the id \"a\" is taken by the box in line 2; ids must be unique");
}

TEST(CsvScene, ThereAreAtMost64Layers) {
  std::string text = "id,min_x,min_y,max_x,max_y,layer\n";
  for (int i = 0; i <= 64; ++i) text += std::to_string(i) + ",0,0,1,1,l" + std::to_string(i) + "\n";
  EXPECT_EQ(refusal(text), "a.csv: line 66, column 12: the layer \"l64\" is one too many; a scene has at most 64");
}

TEST(CsvScene, TextThatIsNotUtf8IsRefused) {
  EXPECT_EQ(refusal(header + "\xE9,1,2,3,4\n").find("a.csv: line 2, column 1: byte 0xE9 is not UTF-8 text"), 0U);
}

TEST(CsvScene, TheExampleOfTheDocumentationIsRead) {
  const std::string example = code_block(text_of(project_file("docs/scene_format.md")), "csv");
  const Scene2 scene = read_2d(example);
  EXPECT_EQ(scene.size(), 3U);
  EXPECT_EQ(box_named(scene, "cell \"3\", spare"), (Aabb<2, double>{{30.5, 0}, {40, 12}}));
  EXPECT_EQ(scene.pairs().size(), 1U);
}

TEST(CsvScene, ARealChipIsReadWhole) {
  const std::filesystem::path chip = shared_file("chip_aes.csv");
  if (!std::filesystem::exists(chip)) GTEST_SKIP() << "there is no " << chip;
  const Scene2 scene = read_2d(text_of(chip));
  EXPECT_EQ(scene.size(), 21340U);
  EXPECT_EQ(box_named(scene, "_18498_"), (Aabb<2, double>{{597540, 615019}, {600200, 617819}}));
  EXPECT_EQ(scene.pairs().size(), 26815U);
}

}  // namespace
}  // namespace graze::io::csv_scene_test
