// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/object.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_object_test {
namespace {

/// A circle "<one>" that touches a box "two", and a circle without a name.
struct SvgObject : ::testing::Test {
  SvgObject() {
    const ObjectId one = scene.add(Sphere<2, double>{{0, 0}, 1}, {.name = "<one>"});
    const ObjectId two = scene.add(Aabb<2, double>{{1, -1}, {3, 1}}, {.name = "two"});
    scene.add(Sphere<2, double>{{6, 0}, 1});
    const std::vector<ObjectPair> pairs = {{one, two}};
    subject = subject_of<2>(scene, pairs);
    stage = stage_for(subject, YAxis::up);
  }

  std::string element(std::size_t position, const Detail& detail, int discs = 1) const {
    Pen pen(stage.frame, 4);
    for (int i = 0; i < discs; ++i) pen.outline({{{0, 0}}, 1});
    return object_element(subject, position, detail, pen);
  }

  Scene<2, double> scene;
  Subject<2> subject;
  Stage<2> stage;
  Detail rich;
  Detail plain = detail_for(100'000);
};

TEST_F(SvgObject, is_a_group_with_a_title) {
  const SvgPicture picture = parsed_fragment(element(0, rich));
  const pugi::xml_node group = picture.root().child("g");
  EXPECT_STREQ(group.attribute("class").value(), "touching");
  EXPECT_STREQ(group.child("title").child_value(), "<one> (sphere), touches two");
  EXPECT_TRUE(group.child("circle"));
}

TEST_F(SvgObject, has_no_class_when_it_touches_nothing) {
  const SvgPicture picture = parsed_fragment(element(2, rich));
  EXPECT_FALSE(picture.root().child("g").attribute("class"));
  EXPECT_STREQ(picture.root().child("g").child("title").child_value(), "#2 (sphere)");
}

TEST_F(SvgObject, is_bare_where_neither_title_nor_class_is_called_for) {
  EXPECT_TRUE(parsed_fragment(element(2, plain)).root().child("circle"));
  EXPECT_STREQ(parsed_fragment(element(0, plain)).root().child("g").attribute("class").value(), "touching");
  EXPECT_FALSE(parsed_fragment(element(0, plain)).root().child("g").child("title"));
}

TEST_F(SvgObject, is_always_one_element) {
  for (const int discs : {0, 1, 2}) {
    for (const Detail& detail : {rich, plain}) {
      const SvgPicture picture = parsed_fragment(element(2, detail, discs));
      EXPECT_TRUE(picture.root().first_child());
      EXPECT_FALSE(picture.root().first_child().next_sibling());
    }
  }
}

TEST_F(SvgObject, has_its_name_in_the_picture_when_it_has_one) {
  const SvgPicture picture = parsed_fragment(name_labels<2>(subject, stage, rich));
  std::vector<std::string> names;
  for (const pugi::xml_node& text : picture.root().children()) names.push_back(text.child_value());
  EXPECT_EQ(names, (std::vector<std::string>{"<one>", "two"}));
  EXPECT_EQ(name_labels<2>(subject, stage, plain), "");
}

TEST_F(SvgObject, has_a_mark_where_it_meets_another) {
  const SvgPicture picture = parsed_fragment(pair_marks<2>(subject, stage));
  const Vec<2, double> meeting = to_picture(stage.frame, {1, 0});
  EXPECT_EQ(picture.root().child("circle").attribute("class").value(), std::string("touch"));
  EXPECT_NEAR(picture.root().child("circle").attribute("cx").as_double(), meeting.x, 1e-3);
  EXPECT_NEAR(picture.root().child("circle").attribute("cy").as_double(), meeting.y, 1e-3);
  EXPECT_FALSE(picture.root().child("circle").next_sibling());
}

TEST_F(SvgObject, has_another_mark_where_it_overlaps) {
  Scene<3, double> space;
  const ObjectId a = space.add(Sphere<3, double>{{0, 0, 0}, 1});
  const ObjectId b = space.add(Sphere<3, double>{{1.5, 0, 0}, 1});
  const ObjectId far = space.add(Sphere<3, double>{{9, 0, 0}, 1});
  const std::vector<ObjectPair> pairs = {{a, b}, {a, far}};
  const Subject<3> solid = subject_of<3>(space, pairs);
  const SvgPicture picture = parsed_fragment(pair_marks<3>(solid, stage_for(solid, YAxis::up)));
  EXPECT_STREQ(picture.root().first_child().attribute("class").value(), "overlap");
  EXPECT_FALSE(picture.root().first_child().next_sibling());
}

}  // namespace
}  // namespace graze::io::svg::svg_object_test
