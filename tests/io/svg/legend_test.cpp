// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/labels.hpp>
#include <graze/io/svg/legend.hpp>

#include "io/svg_picture.hpp"

namespace graze::io::svg::svg_legend_test {
namespace {

Summary any_summary() {
  Summary summary;
  summary.source = "levels/cave.tmx";
  summary.free = 12;
  summary.objects = {.near = 0, .touching = 2, .overlapping = 4};
  summary.pairs = {.near = 0, .touching = 1, .overlapping = 3};
  return summary;
}

TEST(SvgLegend, names_the_file_and_counts) {
  const SvgPicture picture = parsed_fragment(header(any_summary()));
  EXPECT_STREQ(picture.root().child("text").child_value(), "cave.tmx");
  EXPECT_STREQ(picture.by_id("note").child_value(), "18 objects in 2D, 4 pairs");
  EXPECT_EQ(picture.legend("count-free"), "12 free");
  EXPECT_EQ(picture.legend("count-touching"), "2 touching");
  EXPECT_EQ(picture.legend("count-overlapping"), "4 overlapping");
  EXPECT_EQ(picture.legend("count-touching-pairs"), "1 touch");
  EXPECT_EQ(picture.legend("count-overlapping-pairs"), "3 overlaps");
  EXPECT_EQ(picture.legend("count-near"), "");
}

TEST(SvgLegend, tells_touching_and_overlapping_by_pattern_and_by_mark) {
  for (const Dim dimension : {2, 3}) {
    Summary summary = any_summary();
    summary.dimension = dimension;
    const std::string text = header(summary);
    EXPECT_NE(text.find("<g class=\"touching\"><rect"), std::string::npos);
    EXPECT_NE(text.find("<g class=\"overlapping\"><rect"), std::string::npos);
    EXPECT_NE(text.find("<circle class=\"touch\""), std::string::npos);
    EXPECT_NE(text.find("<path class=\"overlap\""), std::string::npos);
    EXPECT_EQ(text.find("class=\"pattern\"") != std::string::npos, dimension == 3);
  }
}

TEST(SvgLegend, says_how_many_are_near_but_apart) {
  Summary summary = any_summary();
  summary.objects.near = 5;
  summary.pairs.near = 3;
  const SvgPicture picture = parsed_fragment(header(summary));
  EXPECT_EQ(picture.legend("count-near"), "5 near");
  EXPECT_STREQ(picture.by_id("note").child_value(), "23 objects in 2D, 7 pairs");
}

TEST(SvgLegend, says_what_was_not_read) {
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  EXPECT_EQ(omission_note(frame, {}), "");
  const std::vector<Omission> few = {{"object class", 9},
                                     {"rounded corner", 2, Loss::precision},
                                     {"tile layer", 3, Loss::shape},
                                     {"text <object>", 1}};
  const SvgPicture picture = parsed_fragment(omission_note(frame, few));
  EXPECT_STREQ(picture.by_id("omissions").last_child().value(),
               "not read: 3 x tile layer, 2 x rounded corner, 9 x object class, 1 x text <object>");
  const std::vector<Omission> many(200, {"kind of thing", 2});
  const std::string text = parsed_fragment(omission_note(frame, many)).by_id("omissions").last_child().value();
  EXPECT_LT(text_width(text, 13), 800);
  EXPECT_EQ(text.substr(text.size() - 3), "…");
}

TEST(SvgLegend, says_what_is_not_drawn) {
  Summary summary = any_summary();
  summary.dimension = 3;
  summary.too_far = 2;
  const SvgPicture picture = parsed_fragment(header(summary));
  EXPECT_STREQ(picture.by_id("note").child_value(), "18 objects in 3D, 4 pairs, 2 too far away to be drawn");
}

TEST(SvgLegend, escapes_and_shortens_the_name) {
  Summary summary = any_summary();
  summary.source = "<" + std::string(500, 'x');
  const std::string heading = parsed_fragment(header(summary)).root().child("text").child_value();
  EXPECT_EQ(heading.substr(0, 3), "<xx");
  EXPECT_LT(heading.size(), 100U);
  summary.source = "folder/";
  EXPECT_STREQ(parsed_fragment(header(summary)).root().child("text").child_value(), "folder/");
}

TEST(SvgLegend, stays_in_the_picture_with_large_counts) {
  Summary summary = any_summary();
  summary.free = 1'000'000'000;
  summary.objects = summary.pairs = {.near = 0, .touching = 100'000'000, .overlapping = 1'000'000'000};
  const SvgPicture picture = parsed_fragment(header(summary));
  for (const pugi::xml_node& item : picture.by_id("legend").children()) {
    EXPECT_GT(numbers_in(item.attribute("transform").value())[0], side_margin);
  }
}

TEST(SvgLegend, bar_is_a_round_length) {
  // One pixel per unit; the maximum of 200 pixels is 200 units.
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  const std::array<Axis, 2> axes = {Axis{"x", {1, 0}}, Axis{"y", {0, 1}}};
  const SvgPicture picture = parsed_fragment(footer(frame, axes));
  EXPECT_STREQ(picture.by_id("scale").child("text").child_value(), "200 units");
  EXPECT_EQ(numbers_in(picture.by_id("scale").child("path").attribute("d").value())[0], 980);
}

TEST(SvgLegend, bar_is_measured_along_the_foreshortened_axes) {
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  const std::array<Axis, 1> axes = {Axis{"x", {0.5, 0}}};
  const SvgPicture picture = parsed_fragment(footer(frame, axes));
  EXPECT_STREQ(picture.by_id("scale").child("text").child_value(), "200 units");  // 100 pixels; 500 units would be 250
  EXPECT_EQ(numbers_in(picture.by_id("scale").child("path").attribute("d").value())[0], 1080);
}

TEST(SvgLegend, shows_where_the_axes_point) {
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  const std::array<Axis, 2> axes = {Axis{"x", {1, 0}}, Axis{"y", {0, -1}}};
  const auto text_place = [](const pugi::xml_node& text) {
    return Vec<2, double>(text.attribute("x").as_double(), text.attribute("y").as_double());
  };
  const SvgPicture picture = parsed_fragment(footer(frame, axes));
  const pugi::xml_node x = picture.by_id("axes").find_child(
      [](const pugi::xml_node& node) { return std::string(node.child_value()) == "x"; });
  const pugi::xml_node y = picture.by_id("axes").find_child(
      [](const pugi::xml_node& node) { return std::string(node.child_value()) == "y"; });
  EXPECT_GT(text_place(x).x, text_place(y).x);
  EXPECT_GT(text_place(y).y, text_place(x).y);  // y points down, as the axis does
}

}  // namespace
}  // namespace graze::io::svg::svg_legend_test
