// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/obb/axes.hpp>

#include "catalogue.hpp"

#ifdef GRAZE_HAS_LANES

namespace graze::detail::obb_axes_test {
namespace {

using V3 = Vec<3, double>;
using Box = Obb<3, double>;

const Box cube{{0, 0, 0}, {1, 1, 1}};

TEST(ObbAxes, AreTheOneAlongWhichBoxesMeetLeast) {
  const ObbAxes on_face = axes_of(cube, Box{{0.1, 0.2, 1.5}, {1, 1, 1}, rotation_matrix(V3(1, 2, 0.5), 20)});
  EXPECT_EQ(on_face.verdict, Relation::overlapping);
  EXPECT_EQ(on_face.candidates & 0x3fU, 1U << 2U);
  const Box below{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 45)};
  const Box above{{0, 0, 2.5}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)};
  const ObbAxes on_edges = axes_of(below, above);
  EXPECT_EQ(on_edges.verdict, Relation::overlapping);
  EXPECT_EQ(on_edges.candidates, 1U << (6U + 3 * 1 + 0));
}

TEST(ObbAxes, SayNothingOfBoxesThatTouchOrAreTooLargeOrTooSmall) {
  EXPECT_EQ(axes_of(cube, Box{{0, 0, 2}, {1, 1, 1}}).verdict, Relation::touching);
  for (const double size : {1e-30, 1e30}) {
    const ObbAxes none = axes_of(Box{{0, 0, 0}, V3(size)}, Box{{0, 0, size}, V3(size)});
    EXPECT_EQ(none.verdict, Relation::touching);
    EXPECT_EQ(none.candidates, all_boxes_axes<3>);
  }
}

// Bit-identical, and never another verdict.
template <class T>
void expect_no_axis_left_out() {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Obb<3, T>, Obb<3, T>>();
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const ObbAxes axes = axes_of(a, b);
    if (axes.verdict != Relation::touching) {
      RC_ASSERT((axes.verdict == Relation::apart) == (decide(a, b) == Relation::apart));
    }
    RC_PRE(axes.verdict != Relation::apart);
    const V3 origin = reference(a);
    const BoxSides<3> sides_a = sides_of(relative_to(origin, a));
    const BoxSides<3> sides_b = sides_of(relative_to(origin, b));
    const double size = size_of_box(sides_a.frame) + size_of_box(sides_b.frame);
    const BoxesAxis<3> all = BoxesSearch<3>(sides_a, sides_b, size).run();
    const BoxesAxis<3> found = BoxesSearch<3>(sides_a, sides_b, size).run(axes.candidates);
    RC_ASSERT(found.axis.normal == all.axis.normal);
    RC_ASSERT(found.axis.gap == all.axis.gap);
    RC_ASSERT(found.edges == all.edges);
    RC_ASSERT(found.edges || (found.is_of_b == all.is_of_b && found.face == all.face));
  });
}

TEST(ObbAxes, LeaveOutNoneThatTheSearchWouldFind) {
  expect_no_axis_left_out<float>();
  expect_no_axis_left_out<double>();
}

}  // namespace
}  // namespace graze::detail::obb_axes_test

#endif
