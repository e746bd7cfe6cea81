// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/svg_legend.hpp>

#include "svg_picture.hpp"

namespace graze::io::svg::svg_legend_test {
namespace {

Summary any_summary() {
  Summary summary;
  summary.source = "levels/cave.tmx";
  summary.free = 12;
  summary.touching = 3;
  summary.pairs = 1;
  return summary;
}

TEST(SvgLegend, names_the_file_and_counts) {
  const SvgPicture picture = parsed_fragment(header(any_summary()));
  EXPECT_STREQ(picture.root().child("text").child_value(), "cave.tmx");
  EXPECT_STREQ(picture.by_id("note").child_value(), "15 objects in 2D");
  EXPECT_EQ(picture.legend("count-free"), "12 free");
  EXPECT_EQ(picture.legend("count-touching"), "3 touching");
  EXPECT_EQ(picture.legend("count-pairs"), "1 pair");
}

TEST(SvgLegend, says_what_is_not_drawn) {
  Summary summary = any_summary();
  summary.dimension = 3;
  summary.too_far = 2;
  const SvgPicture picture = parsed_fragment(header(summary));
  EXPECT_STREQ(picture.by_id("note").child_value(), "15 objects in 3D, 2 too far away to be drawn");
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
  summary.free = summary.touching = summary.pairs = 1'000'000'000'000;
  const SvgPicture picture = parsed_fragment(header(summary));
  for (const pugi::xml_node& item : picture.by_id("legend").children()) {
    EXPECT_GT(numbers_in(item.attribute("transform").value())[0], side_margin);
  }
}

TEST(SvgLegend, bar_is_a_round_length) {
  // One pixel per unit: of 200 pixels at most, 200 units.
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
