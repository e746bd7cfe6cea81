// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/io/svg/frame.hpp>

namespace graze::io::svg::svg_frame_test {
namespace {

TEST(SvgFrame, shows_wide_content_from_side_to_side) {
  const Frame frame = frame_around({{0, 0}, {1080, 540}});  // the card is 1160 wide, 40 of it free on each side
  EXPECT_EQ(frame.scale, 1);
  EXPECT_EQ(frame.card.min, (Vec<2, double>(20, 68)));
  EXPECT_EQ(frame.card.max, (Vec<2, double>(1180, 68 + 620)));
  EXPECT_EQ(frame.height, 68 + 620 + 64);
  EXPECT_EQ(to_picture(frame, {0, 0}), (Vec<2, double>(60, 648)));
  EXPECT_EQ(to_picture(frame, {1080, 540}), (Vec<2, double>(1140, 108)));
}

TEST(SvgFrame, limits_the_height_of_tall_content) {
  const Frame frame = frame_around({{0, 0}, {100, 8200}});
  EXPECT_EQ(frame.card.max.y - frame.card.min.y, 900);
  EXPECT_DOUBLE_EQ(frame.scale, 0.1);
  EXPECT_NEAR(to_picture(frame, {0, 0}).y, 928, 1e-9);
}

TEST(SvgFrame, shows_four_units_around_a_point) {
  const Frame frame = frame_around({{7, 5}, {7, 5}});
  EXPECT_EQ(frame.scale, 270);
  EXPECT_EQ(to_picture(frame, {7, 5}), frame.card.center());
}

TEST(SvgFrame, has_a_finite_scale_for_every_extent) {
  for (const double size : {1e-320, 1e-100, 1e-9, 1.0, 1e12, 1e100}) {
    for (const double offset : {0.0, 1.0, -1e12, 1e100}) {
      const Frame frame = frame_around({Vec<2, double>(offset), Vec<2, double>(offset + size)});
      EXPECT_TRUE(std::isfinite(frame.scale) && frame.scale > 0) << size << " at " << offset;
    }
  }
}

TEST(SvgFrame, clamps_to_the_card) {
  const Frame frame = frame_around({{0, 0}, {1, 1}});
  EXPECT_EQ(to_picture(frame, {-1e9, 1e9}), frame.card.min);
  EXPECT_EQ(to_picture(frame, {1e9, -1e9}), frame.card.max);
}

TEST(SvgFrame, visible_part_of_the_view_fills_the_card) {
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  EXPECT_EQ(visible(frame).min, (Vec<2, double>(-40, -40)));
  EXPECT_EQ(visible(frame).max, (Vec<2, double>(1120, 580)));
}

TEST(SvgFrame, boxes_include_the_radius) {
  const Outline capsule{{{100, 100}, {200, 100}}, 50};
  EXPECT_EQ(box_around(capsule).min, (Vec<2, double>(50, 50)));
  EXPECT_EQ(box_around(capsule).max, (Vec<2, double>(250, 150)));
  EXPECT_EQ(box_around(Outline{}), (Aabb<2, double>::nothing()));
  const Frame frame = frame_around({{0, 0}, {1080, 540}});
  EXPECT_EQ(picture_box(frame, capsule).min, (Vec<2, double>(110, 498)));
  EXPECT_EQ(picture_box(frame, capsule).max, (Vec<2, double>(310, 598)));
}

TEST(SvgFrame, round_lengths_are_one_two_or_five_times_a_power_of_ten) {
  EXPECT_EQ(round_length(1), 1);
  EXPECT_EQ(round_length(1.99), 1);
  EXPECT_EQ(round_length(2), 2);
  EXPECT_EQ(round_length(4.9), 2);
  EXPECT_EQ(round_length(7), 5);
  EXPECT_EQ(round_length(99), 50);
  EXPECT_EQ(round_length(1000), 1000);
  EXPECT_DOUBLE_EQ(round_length(0.03), 0.02);
  EXPECT_DOUBLE_EQ(round_length(3e12), 2e12);
  for (int power = -99; power < 99; ++power) {
    const double limit = std::pow(10.0, power);
    EXPECT_LE(round_length(limit), limit);
    EXPECT_LE(round_length(std::nextafter(limit, 0.0)), limit);
    EXPECT_GE(round_length(limit), 0.4 * limit);
  }
}

}  // namespace
}  // namespace graze::io::svg::svg_frame_test
