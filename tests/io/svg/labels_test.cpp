// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/svg/labels.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_labels_test {
namespace {

const Aabb<2, double> card{{0, 0}, {1000, 500}};

/// The positions of the names, as "name x y".
std::vector<std::string> places(const std::vector<Label>& labels) {
  const SvgPicture picture = parsed_fragment(placed_labels(labels, card));
  std::vector<std::string> result;
  for (const pugi::xml_node& text : picture.root().children("text")) {
    result.push_back(std::string(text.child_value()) + " " + text.attribute("x").value() + " " +
                     text.attribute("y").value());
  }
  return result;
}

using Places = std::vector<std::string>;

TEST(SvgLabels, stand_in_the_middle_of_a_box_that_is_large_enough) {
  EXPECT_EQ(places({{"crate", {{100, 100}, {200, 150}}}}), (Places{"crate 150 129"}));
}

TEST(SvgLabels, stand_above_a_small_box) {
  // Height 15, 4 above the box: its center is 11.5 above, the baseline 4 below that.
  EXPECT_EQ(places({{"crate", {{100, 100}, {110, 110}}}}), (Places{"crate 105 92.5"}));
}

TEST(SvgLabels, stand_elsewhere_when_the_best_place_is_taken) {
  const Label small{"a", {{100, 100}, {110, 110}}};
  const Label difference{"", {{104, 80}, {140, 97}}};                // has no name
  EXPECT_EQ(places({small, difference}), (Places{"a 117.72 109"}));  // to the right
}

TEST(SvgLabels, may_lie_on_a_larger_thing) {
  EXPECT_EQ(places({{"crate", {{100, 100}, {110, 110}}}, {"ground", {{0, 0}, {1000, 500}}}}),
            (Places{"ground 500 254", "crate 105 92.5"}));
}

TEST(SvgLabels, do_not_cover_a_smaller_thing_in_the_middle_of_a_larger) {
  const Places found = places({{"ground", {{0, 0}, {1000, 500}}}, {"crate", {{450, 200}, {550, 300}}}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0], "ground 500 254");
  EXPECT_EQ(found[1], "crate 500 254");
}

TEST(SvgLabels, of_things_in_pairs_come_first_and_of_the_others_those_of_the_largest) {
  std::vector<Label> cluster;
  for (int i = 0; i < 40; ++i) {
    const double size = i == 7 ? 4 : i == 23 ? 3 : 1;
    cluster.push_back({"n" + std::to_string(i), {{500, 250}, {500 + size, 250 + size}}, i == 31});
  }
  const Places found = places(cluster);
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[0].substr(0, 4), "n31 ");
  EXPECT_EQ(found[1].substr(0, 3), "n7 ");
}

TEST(SvgLabels, of_things_in_pairs_may_cover_smaller_things_where_there_is_no_other_place) {
  std::vector<Label> table = {{"table", {{100, 100}, {400, 300}}}};
  for (int i = 0; i < 300; ++i) {
    const Vec<2, double> corner(90 + 16.0 * (i % 20), 90 + 16.0 * std::floor(i / 20.0));
    table.push_back({"", {corner, corner + 10.0}});
  }
  EXPECT_EQ(places(table), Places{});
  table[0].in_pair = true;
  EXPECT_EQ(places(table), (Places{"table 250 204"}));
}

RC_GTEST_PROP(SvgLabels, never_overlap_nor_leave_the_card, ()) {
  std::vector<Label> labels;
  const auto count = *rc::gen::inRange(0, 400);
  for (int i = 0; i < count; ++i) {
    const Vec<2, double> corner(*rc::gen::inRange(0, 950), *rc::gen::inRange(0, 450));
    const Vec<2, double> size(*rc::gen::inRange(0, 50), *rc::gen::inRange(0, 50));
    labels.push_back({"name " + std::to_string(i), {corner, corner + size}, i % 3 == 0});
  }
  const SvgPicture picture = parsed_fragment(placed_labels(labels, card));
  std::vector<Aabb<2, double>> taken;
  for (const pugi::xml_node& text : picture.root().children("text")) {
    const Vec<2, double> middle(text.attribute("x").as_double(), text.attribute("y").as_double() - 4);
    const Vec<2, double> half(text_width(text.child_value(), 12) / 2, 7.5);
    const Aabb<2, double> box = Aabb<2, double>::from_center(middle, half - 0.01);
    RC_ASSERT(box.min.x >= 0 && box.min.y >= 0 && box.max.x <= 1000 && box.max.y <= 500);
    for (const Aabb<2, double>& other : taken) RC_ASSERT(!boxes_overlap(box, other));
    taken.push_back(box);
  }
}

TEST(SvgLabels, that_fit_nowhere_are_left_out) {
  EXPECT_EQ(places({{std::string(500, 'x'), {{100, 100}, {110, 110}}}}), Places{});
  const Label same{"ab", {{500, 250}, {501, 251}}};
  EXPECT_EQ(places({same, same, same, same, same, same}).size(), 2U);  // above and below; beside would overlap above
}

TEST(SvgLabels, are_escaped) { EXPECT_EQ(places({{"<a&b>", {{100, 100}, {200, 150}}}}), (Places{"<a&b> 150 129"})); }

TEST(SvgLabels, estimate_wide_characters_as_wide) {
  EXPECT_DOUBLE_EQ(text_width("abcd", 10), 24.8);
  EXPECT_DOUBLE_EQ(text_width("球球", 10), 24.8);
}

}  // namespace
}  // namespace graze::io::svg::svg_labels_test
