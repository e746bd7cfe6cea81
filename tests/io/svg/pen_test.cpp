// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/pen.hpp>

namespace graze::io::svg::svg_pen_test {
namespace {

/// One pixel per unit; (0, 0) is drawn at (60, 648), y up.
Pen any_pen() { return {frame_around({{0, 0}, {1080, 540}}), 4}; }

std::string drawn(const Outline& outline, std::string_view style = {}) {
  Pen pen = any_pen();
  pen.outline(outline, style);
  return pen.take();
}

TEST(SvgPen, draws_an_outline_as_what_it_is) {
  EXPECT_EQ(drawn({{{10, 20}}, 5}), R"(<circle cx="70" cy="628" r="5"/>)");
  EXPECT_EQ(drawn({{{0, 0}, {10, 0}, {0, 10}}, 0}), R"(<path d="M60 648L70 648L60 638Z"/>)");
  EXPECT_EQ(drawn({{{0, 0}, {10, 0}}, 0}), R"(<path class="line" d="M60 648L70 648"/>)");
  EXPECT_EQ(drawn({{{10, 20}}, 0}), R"(<path class="mark" d="M66 628h8M70 624v8"/>)");
}

TEST(SvgPen, draws_a_capsule_with_its_half_circles_outside) {
  // Below the axis to the right, around its end, above it to the left; "0 0 0": the short arc, counter-clockwise as
  // seen.
  EXPECT_EQ(drawn({{{0, 0}, {10, 0}}, 2}), R"(<path d="M60 650L70 650A2 2 0 0 0 70 646L60 646A2 2 0 0 0 60 650Z"/>)");
}

TEST(SvgPen, draws_nothing_for_an_empty_outline) {
  Pen pen = any_pen();
  pen.outline({});
  pen.lines({}, "grid");
  EXPECT_EQ(pen.elements(), 0U);
  EXPECT_EQ(pen.take(), "");
}

TEST(SvgPen, draws_what_is_too_small_to_see_as_a_dot) {
  EXPECT_EQ(drawn({{{0, 0}, {1e-9, 0}, {0, 1e-9}}, 0}), R"(<circle cx="60" cy="648" r="0.05"/>)");
  EXPECT_EQ(drawn({{{0, 0}}, 1e-9}), R"(<circle cx="60" cy="648" r="0.05"/>)");
  EXPECT_EQ(drawn({{{0, 0}, {1e-9, 0}}, 3}), R"(<circle cx="60" cy="648" r="3"/>)");
  Pen pen = any_pen();
  pen.rectangle({{0, 0}, {1e-9, 5}});
  EXPECT_EQ(pen.take(), R"(<rect x="60" y="643" width="0.1" height="5"/>)");
}

TEST(SvgPen, gives_elements_their_class) {
  EXPECT_EQ(drawn({{{10, 20}}, 5}, "ball"), R"(<circle class="ball" cx="70" cy="628" r="5"/>)");
}

TEST(SvgPen, draws_an_arrow_with_its_head_at_the_end) {
  Pen pen = any_pen();
  pen.arrow({0, 0}, {100, 0});
  EXPECT_EQ(pen.take(), R"(<path class="line" d="M60 648L160 648M149 652.5L160 648L149 643.5"/>)");
  pen.arrow({5, 5}, {5, 5});
  EXPECT_EQ(pen.take(), R"(<path class="mark" d="M61 643h8M65 639v8"/>)");
}

TEST(SvgPen, draws_many_lines_as_one_element) {
  Pen pen = any_pen();
  const std::vector<Vec<2, double>> ends = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  pen.lines(ends, "grid");
  EXPECT_EQ(pen.elements(), 1U);
  EXPECT_EQ(pen.take(), R"(<path class="grid" d="M60 648L61 648M60 647L61 647"/>)");
}

TEST(SvgPen, starts_anew_when_its_work_is_taken) {
  Pen pen = any_pen();
  pen.line({0, 0}, {1, 1});
  pen.mark({0, 0});
  EXPECT_EQ(pen.elements(), 2U);
  EXPECT_NE(pen.take(), "");
  EXPECT_EQ(pen.elements(), 0U);
  EXPECT_EQ(pen.take(), "");
}

}  // namespace
}  // namespace graze::io::svg::svg_pen_test
