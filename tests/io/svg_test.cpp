// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/svg.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>

#include "svg_picture.hpp"

namespace graze::io::svg_test {
namespace {

/// The points that a drawn element passes through or, for discs and boxes, its extreme points.
std::vector<Vec<2, double>> points_of(const pugi::xml_node& element) {
  const auto value = [&element](const char* name) { return element.attribute(name).as_double(); };
  const std::string name = element.name();
  if (name == "circle") {
    return {{value("cx") - value("r"), value("cy") - value("r")}, {value("cx") + value("r"), value("cy") + value("r")}};
  }
  if (name == "rect") {
    return {{value("x"), value("y")}, {value("x") + value("width"), value("y") + value("height")}};
  }
  if (name == "text") return {{value("x"), value("y")}};
  std::vector<Vec<2, double>> points;
  std::istringstream data(element.attribute("d").value());
  for (char command = 0; data >> command;) {
    double x = 0;
    double y = 0;
    if (command == 'A') {
      for (int i = 0; i < 5; ++i) data >> x;
    }
    if (command == 'M' || command == 'L' || command == 'A') {
      data >> x >> y;
      points.emplace_back(x, y);
    } else if (command == 'h' || command == 'v') {
      data >> x;
    }
    EXPECT_TRUE(data) << element.attribute("d").value();
  }
  return points;
}

void expect_inside(const pugi::xml_node& node, double width, double height) {
  for (const pugi::xml_node& child : node.children()) {
    for (const Vec<2, double>& point : points_of(child)) {
      EXPECT_TRUE(point.x >= 0 && point.x <= width && point.y >= 0 && point.y <= height)
          << child.name() << " reaches " << point.x << ", " << point.y;
    }
    expect_inside(child, width, height);
  }
}

/// The laws of every picture: it is well-formed, everything is inside it, every number is finite, every object is
/// present.
SvgPicture checked(const std::string& text, std::size_t objects) {
  SvgPicture picture = parsed_picture(text);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  const std::vector<double> box = numbers_in(picture.root().attribute("viewBox").value());
  EXPECT_EQ(box.size(), 4U);
  expect_inside(picture.by_id("objects"), box[2], box[3]);
  expect_inside(picture.by_id("labels"), box[2], box[3]);
  std::size_t drawn = 0;
  for ([[maybe_unused]] const pugi::xml_node& object : picture.by_id("objects").children()) ++drawn;
  EXPECT_EQ(drawn, objects);
  return picture;
}

/// The titles of the objects that are marked as part of a pair.
std::vector<std::string> marked_titles(const SvgPicture& picture) {
  std::vector<std::string> titles;
  for (const pugi::xml_node& object : picture.by_id("objects").children()) {
    const std::string style = object.attribute("class").value();
    const bool marked = style == "near" || style == "touching" || style == "overlapping";
    if (marked) titles.emplace_back(object.child("title").child_value());
  }
  return titles;
}

TEST(Svg, shows_every_shape_of_the_plane) {
  Scene<2, double> scene;
  scene.add(Vec<2, double>(1, 2));
  scene.add(Segment<2, double>{{0, 0}, {3, 1}});
  scene.add(Ray<2, double>{{2, 2}, {1, 1}});
  scene.add(Sphere<2, double>{{4, 4}, 1});
  scene.add(Aabb<2, double>{{0, 3}, {1, 5}});
  scene.add(Obb<2, double>{{6, 1}, {2, 1}, rotation_matrix(30)});
  scene.add(Plane<2, double>{{1, 2}, 20});
  scene.add(HalfSpace<2, double>{{0, 1}, -1});
  scene.add(Triangle<2, double>{{7, 4}, {8, 4}, {7, 6}});
  scene.add(Capsule<2, double>{{9, 1}, {9, 4}, 0.5});
  const std::vector<Vec<2, double>> corners = {{11, 1}, {13, 1}, {12, 3}, {13, 2}};
  scene.add(convex_hull<2, double>(corners));
  scene.add(compound_of<2, double>({Sphere<2, double>{{12, 6}, 1}, Vec<2, double>(14, 6)}));
  checked(svg_text<2>(scene, {}), 12);
  checked(svg_text<2>(scene, {}, YAxis::down), 12);
}

TEST(Svg, shows_every_shape_of_space) {
  Scene<3, double> scene;
  scene.add(Vec<3, double>(1, 2, 3));
  scene.add(Segment<3, double>{{0, 0, 0}, {3, 1, 1}});
  scene.add(Ray<3, double>{{2, 2, 2}, {1, 1, 0}});
  scene.add(Sphere<3, double>{{4, 4, 1}, 1});
  scene.add(Aabb<3, double>{{0, 3, 0}, {1, 5, 4}});
  scene.add(Obb<3, double>{{6, 1, 2}, {2, 1, 1}, rotation_matrix(Vec<3, double>(1, 1, 1), 30)});
  scene.add(Plane<3, double>{{1, 2, 3}, 20});
  scene.add(HalfSpace<3, double>{{0, 0, 1}, -1});
  scene.add(Triangle<3, double>{{7, 4, 0}, {8, 4, 0}, {7, 6, 3}});
  scene.add(Capsule<3, double>{{9, 1, 0}, {9, 4, 3}, 0.5});
  const std::vector<Vec<3, double>> corners = {{11, 1, 0}, {13, 1, 0}, {12, 3, 0}, {12, 2, 2}};
  scene.add(convex_hull<3, double>(corners));
  scene.add(compound_of<3, double>({Sphere<3, double>{{12, 6, 1}, 1}, Vec<3, double>(14, 6, 0)}));
  checked(svg_text<3>(scene, {}), 12);
}

TEST(Svg, marks_exactly_what_is_in_a_pair_and_how_it_meets) {
  Scene<2, double> scene;
  std::vector<ObjectId> ids;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    ids.push_back(scene.add(Sphere<2, double>{{static_cast<double>(ids.size()), 0}, 0.5}, {.name = name}));
  }
  const std::vector<ObjectPair> pairs = {{ids[0], ids[1]}, {ids[1], ids[2]}, {ids[0], ids[2]}};
  const SvgPicture picture = checked(svg_text<2>(scene, pairs), 5);
  EXPECT_EQ(marked_titles(picture),
            (std::vector<std::string>{"a (sphere), touches b and c", "b (sphere), touches a and c",
                                      "c (sphere), touches b and a"}));
  EXPECT_EQ(picture.legend("count-free"), "2 free");
  EXPECT_EQ(picture.legend("count-touching"), "3 touching");
  EXPECT_EQ(picture.legend("count-overlapping"), "0 overlapping");
  EXPECT_EQ(picture.legend("count-touching-pairs"), "2 touches");  // a and c are apart
  EXPECT_STREQ(picture.by_id("note").child_value(), "5 objects in 2D, 3 pairs");
}

TEST(Svg, says_what_was_not_read_also_where_nothing_is_drawn) {
  const SceneFile file{Scene<2, double>(), "tiles.tmx", "tiled", YAxis::down, {{"tile layer", 2}}};
  std::ostringstream out;
  write_svg(out, file, {});
  const SvgPicture picture = checked(out.str(), 0);
  EXPECT_STREQ(picture.by_id("omissions").last_child().value(), "not read: 2 x tile layer");
  EXPECT_NE(out.str().find(">nothing to draw: the content of the file was not read<"), std::string::npos);
}

TEST(Svg, names_what_it_can_of_many_objects) {
  Scene<2, double> scene;
  for (int i = 0; i < 900; ++i) {
    const double size = i % 100 == 0 ? 0.9 : 0.1;
    const Vec<2, double> corner(i % 30, std::floor(i / 30.0));
    scene.add(Aabb<2, double>{corner, corner + size}, {.name = "n" + std::to_string(i)});
  }
  const SvgPicture picture = checked(svg_text<2>(scene, {}), 900);
  std::vector<std::string> names;
  for (const pugi::xml_node& label : picture.by_id("labels").children()) names.emplace_back(label.child_value());
  EXPECT_GT(names.size(), 100U);
  EXPECT_EQ(names.front(), "n0");
  EXPECT_EQ(names[8], "n800");
}

TEST(Svg, stays_well_formed_whatever_the_names) {
  Scene<2, double> scene;
  const std::vector<std::string> names = {
      "<script>alert(1)</script>",  "a & b",    "\"quoted\" 'twice'", "]]>", "-->",
      std::string("zero\0byte", 9), "\x1b[31m", "\xff\xfe",           "球",  "\uFFFE"};
  for (const std::string& name : names) {
    scene.add(Sphere<2, double>{{3.0 * static_cast<double>(scene.size()), 0}, 1}, {.name = name});
  }
  const SvgPicture picture = checked(svg_text<2>(scene, {}), names.size());
  EXPECT_STREQ(picture.by_id("objects").first_child().child("title").child_value(),
               "<script>alert(1)</script> (sphere)");
  EXPECT_FALSE(
      picture.document.find_node([](const pugi::xml_node& node) { return std::string(node.name()) == "script"; }));
}

TEST(Svg, shows_an_empty_scene_as_such) {
  const SvgPicture flat = checked(svg_text<2>({}, {}), 0);
  EXPECT_EQ(flat.legend("count-free"), "0 free");
  EXPECT_NE(svg_text<2>({}, {}).find(">nothing to draw<"), std::string::npos);
  checked(svg_text<3>({}, {}), 0);
}

TEST(Svg, shows_a_single_point_in_the_middle) {
  Scene<2, double> scene;
  scene.add(Vec<2, double>(1e6, -3));
  const std::string text = svg_text<2>(scene, {});
  checked(text, 1);
  EXPECT_NE(text.find("d=\"M595.5 243h9M600 238.5v9\""), std::string::npos);  // card: 1160 x 350 from (20, 68)
  Scene<3, double> space;
  space.add(Vec<3, double>(1, 2, 3));
  EXPECT_NE(svg_text<3>(space, {}).find("d=\"M595.5 243h9M600 238.5v9\""), std::string::npos);
}

TEST(Svg, shows_scenes_of_unbounded_shapes_only) {
  Scene<2, double> flat;
  flat.add(Plane<2, double>{{1, 1}, 5});
  flat.add(HalfSpace<2, double>{{0, 1}, 2});
  flat.add(Ray<2, double>{{7, 7}, {1, 0.3}});
  checked(svg_text<2>(flat, {}), 3);
  for (const AnyShape<3, double>& shape :
       {AnyShape<3, double>(Plane<3, double>{{1, 1, 1}, 5}), AnyShape<3, double>(HalfSpace<3, double>{{0, 0, -1}, 2}),
        AnyShape<3, double>(Ray<3, double>{{7, 7, 7}, {0, 0, 1}})}) {
    Scene<3, double> space;
    space.add(shape);
    const SvgPicture picture = checked(svg_text<3>(space, {}), 1);
    EXPECT_TRUE(picture.by_id("objects").first_child().child("path")) << type_name(shape);
  }
}

template <Dim N>
void expect_framed(double size, double offset) {
  Scene<N, double> scene;
  scene.add(Sphere<N, double>{Vec<N, double>(offset), size});
  scene.add(Aabb<N, double>{Vec<N, double>(offset), Vec<N, double>(offset + size)});
  scene.add(Ray<N, double>{Vec<N, double>(offset), Vec<N, double>(size)});
  scene.add(Plane<N, double>{unit_axis<N>(0), offset});
  SCOPED_TRACE(::testing::Message() << size << " at " << offset << " in " << N << "D");
  const SvgPicture picture = checked(svg_text<N>(scene, {}), 4);
  const double radius = picture.document
                            .find_node([](const pugi::xml_node& node) {
                              return std::string(node.name()) == "circle" &&
                                     std::string(node.parent().parent().attribute("id").value()) == "objects";
                            })
                            .attribute("r")
                            .as_double();
  EXPECT_GT(radius, 100);
  EXPECT_LT(radius, 600);
}

TEST(Svg, frames_scenes_of_any_size_well) {
  for (const double size : {1e-90, 1e-9, 1.0, 1e12, 1e90}) {
    expect_framed<2>(size, 0);
    expect_framed<3>(size, 0);
  }
  expect_framed<2>(1, 1e12);
  expect_framed<3>(1, -1e12);
}

TEST(Svg, survives_the_largest_and_smallest_numbers) {
  const double largest = std::numeric_limits<double>::max();
  for (const double size : {std::numeric_limits<double>::denorm_min(), 1e-310, 1e101, 1e200, largest}) {
    Scene<2, double> scene;
    scene.add(Sphere<2, double>{{size, -size}, size});
    scene.add(Obb<2, double>{{size, size}, {size, size}});
    scene.add(Segment<2, double>{{-size, 0}, {size, 0}});
    scene.add(HalfSpace<2, double>{{size, size}, -size});
    scene.add(Ray<2, double>{{size, 0}, {0, size}});
    const std::string text = svg_text<2>(scene, {});
    SCOPED_TRACE(size);
    // Beyond 1e101 only the half-space is drawn: it passes the origin at a distance of 1 / sqrt(2).
    checked(text, size < 1 ? 5 : 1);
    EXPECT_EQ(text.find("4 too far away to be drawn") != std::string::npos, size > 1);
  }
}

TEST(Svg, keeps_pictures_of_many_objects_small) {
  constexpr int count = 20'000;
  Scene<2, double> flat;
  Scene<3, double> space;
  std::vector<ObjectPair> flat_pairs;
  std::vector<ObjectPair> space_pairs;
  ObjectId before_a;
  ObjectId before_b;
  for (int i = 0; i < count; ++i) {
    const int row = i / 400;
    const double x = i % 400;
    const double y = row;
    const std::string name = "a rather long name of an object " + std::to_string(i);
    const ObjectId a = flat.add(Aabb<2, double>{{x, y}, {x + 0.7, y + 0.7}}, {.name = name});
    const ObjectId b = space.add(Aabb<3, double>{{x, y, 0}, {x + 0.7, y + 0.7, 0.7}}, {.name = name});
    if (i % 20 == 1) flat_pairs.push_back({before_a, a});
    if (i % 20 == 1) space_pairs.push_back({before_b, b});
    before_a = a;
    before_b = b;
  }
  const std::string flat_text = svg_text<2>(std::move(flat), flat_pairs);
  const std::string space_text = svg_text<3>(std::move(space), space_pairs);
  EXPECT_LT(flat_text.size(), 100U * count);
  EXPECT_LT(space_text.size(), 150U * count);
  EXPECT_NE(flat_text.find("<!-- 20000 objects: names, titles and patterns are left out above 5000"),
            std::string::npos);
  const SvgPicture picture = parsed_picture(flat_text);
  EXPECT_EQ(marked_titles(picture).size(), 2'000U);
  EXPECT_EQ(picture.legend("count-near"), "2000 near");  // a third of a unit apart
  EXPECT_EQ(picture.legend("count-free"), "18000 free");
}

TEST(Svg, is_the_same_every_time) {
  Scene<3, double> scene;
  for (int i = 0; i < 50; ++i) scene.add(Sphere<3, double>{Vec<3, double>(i % 4, i % 7, i % 3), 1});
  EXPECT_EQ(svg_text<3>(scene, {}), svg_text<3>(scene, {}));
}

TEST(Svg, refuses_pairs_of_objects_that_are_not_there_before_it_writes) {
  const SceneFile file{Scene<2, double>(), "empty.json", "graze.scene/1", YAxis::up, {}};
  const std::vector<ObjectPair> pairs = {{{0, 0}, {1, 0}}};
  std::ostringstream out;
  EXPECT_THROW(write_svg(out, file, pairs), std::invalid_argument);
  EXPECT_EQ(out.str(), "");
}

RC_GTEST_PROP(Svg, marks_exactly_the_objects_of_random_pairs,
              (const std::vector<std::pair<std::uint8_t, std::uint8_t>>& raw)) {
  Scene<2, double> scene;
  std::vector<ObjectId> ids;
  for (int i = 0; i < 12; ++i) ids.push_back(scene.add(Vec<2, double>(i, i % 5)));
  std::vector<ObjectPair> pairs;
  std::vector<bool> touching(ids.size(), false);
  for (const auto& [first, second] : raw) {
    const std::size_t a = first % ids.size();
    const std::size_t b = second % ids.size();
    if (a == b) continue;
    pairs.push_back({ids[a], ids[b]});
    touching[a] = touching[b] = true;
  }
  const SvgPicture picture = parsed_picture(svg_text<2>(scene, pairs));
  std::size_t marked = 0;
  for (const std::string& title : marked_titles(picture)) {
    ++marked;
    RC_ASSERT(touching[static_cast<std::size_t>(std::stoi(title.substr(1)))]);
  }
  RC_ASSERT(marked == static_cast<std::size_t>(std::count(touching.begin(), touching.end(), true)));
}

}  // namespace
}  // namespace graze::io::svg_test
