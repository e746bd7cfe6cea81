// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/svg/depth.hpp>

namespace graze::io::svg::svg_depth_test {
namespace {

using Order = std::vector<std::size_t>;

Layered body(const Vec<3, double>& min, const Vec<3, double>& max) { return {{min, max}, std::nullopt}; }

Order order(const std::vector<Layered>& things) { return back_to_front(things, isometric_view()); }

TEST(SvgDepth, paints_what_is_behind_first) {
  const Layered middle = body({0, 0, 0}, {1, 1, 1});
  // Seen from (1, -1, 1): more x, less y and more z are in front.
  EXPECT_EQ(order({middle, body({2, 0, 0}, {3, 1, 1})}), (Order{0, 1}));
  EXPECT_EQ(order({middle, body({0, 2, 0}, {1, 3, 1})}), (Order{1, 0}));
  EXPECT_EQ(order({middle, body({0, 0, 1}, {1, 1, 2})}), (Order{0, 1}));
  EXPECT_EQ(order({}), Order{});
}

TEST(SvgDepth, puts_a_crate_on_the_floor_it_stands_on_also_at_its_far_end) {
  const Layered crate = body({-9, 8, 0}, {-8, 9, 1});  // its center is farther away than the floor's
  const Layered floor = body({-10, -10, -1}, {10, 10, 0});
  EXPECT_EQ(order({crate, floor}), (Order{1, 0}));
}

TEST(SvgDepth, puts_a_crate_that_sinks_into_the_floor_a_little_on_it) {
  const Layered crate = body({-9, 8, -0.1}, {-8, 9, 1});
  const Layered floor = body({-10, -10, -1}, {10, 10, 0});
  EXPECT_EQ(order({crate, floor}), (Order{1, 0}));
}

TEST(SvgDepth, puts_a_sheet_behind_what_is_on_the_viewers_side) {
  const Layered sheet{{{-10, -10, 0}, {10, 10, 0}}, Plane<3, double>{{0, 0, 1}, 0}};
  const Layered turned_sheet{{{-10, -10, 0}, {10, 10, 0}}, Plane<3, double>{{0, 0, -3}, 0}};
  const Layered above = body({-9, 8, 1}, {-8, 9, 2});
  const Layered below = body({7, -8, -2}, {8, -7, -1});
  EXPECT_EQ(order({above, sheet, below}), (Order{2, 1, 0}));
  EXPECT_EQ(order({above, turned_sheet, below}), (Order{2, 1, 0}));
}

TEST(SvgDepth, breaks_circles_and_loses_nothing) {
  // Three beams, each above the next.
  const std::vector<Layered> beams = {body({-3, -1, 0}, {3, 0, 1}), body({-1, -3, 0.5}, {0, 3, 1.5}),
                                      body({-3, -3, -1}, {3, 3, 0.2}), body({-3, -1, 0}, {3, 0, 1})};
  Order found = order(beams);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (Order{0, 1, 2, 3}));
}

TEST(SvgDepth, orders_a_hundred_thousand_things) {
  std::vector<Layered> things;
  for (int i = 0; i < 100'000; ++i) {
    const int row = i / 317;
    const double x = i % 317;
    const double y = row;
    things.push_back(body({x, y, 0}, {x + 3, y + 3, 3}));
  }
  Order found = order(things);
  std::sort(found.begin(), found.end());
  Order all(things.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  EXPECT_EQ(found, all);
}

RC_GTEST_PROP(SvgDepth, paints_every_thing_once_and_grid_boxes_in_a_correct_order, ()) {
  // Boxes on a grid do not overlap, so a correct order exists: whatever covers another comes later.
  const auto cells = *rc::gen::unique<std::vector<std::tuple<int, int, int>>>(
      rc::gen::tuple(rc::gen::inRange(0, 4), rc::gen::inRange(0, 4), rc::gen::inRange(0, 4)));
  std::vector<Layered> things;
  for (const auto& [x, y, z] : cells)
    things.push_back(body(Vec<3, double>(x, y, z), Vec<3, double>(x + 1, y + 1, z + 1)));
  const Order found = order(things);
  RC_ASSERT(found.size() == things.size());
  std::vector<std::size_t> place(things.size(), things.size());
  for (std::size_t i = 0; i < found.size(); ++i) place[found[i]] = i;
  for (std::size_t a = 0; a < things.size(); ++a) {
    RC_ASSERT(place[a] < things.size());
    for (std::size_t b = 0; b < things.size(); ++b) {
      const auto& [ax, ay, az] = cells[a];
      const auto& [bx, by, bz] = cells[b];
      const bool b_covers_a = bx >= ax && by <= ay && bz >= az && a != b;
      const bool same_line_of_sight = bx - ax == ay - by && bx - ax == bz - az;
      if (b_covers_a && same_line_of_sight) RC_ASSERT(place[a] < place[b]);
    }
  }
}

}  // namespace
}  // namespace graze::io::svg::svg_depth_test
