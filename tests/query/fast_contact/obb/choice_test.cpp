// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/fast_contact/obb/choice.hpp>
#include <graze/query/patch/manifold_points.hpp>

#include "catalogue.hpp"

#ifdef GRAZE_HAS_LANES

namespace graze::detail::obb_choice_test {
namespace {

using V3 = Vec<3, double>;
using Box = Obb<3, double>;

/// A corner of the lower side of a box above the upper side of another, in the form of SpanningChoice.
struct Place {
  V3 point_a;
  double depth;
};

unsigned spanning(const FaceOverFace& over, bool on_incident) {
  std::vector<Place> places;
  std::vector<int> lines;
  for (unsigned rest = over.left(); rest != 0; rest &= rest - 1) {
    lines.push_back(std::countr_zero(rest));
    const PairedPoints pair = over.pair(static_cast<std::size_t>(lines.back()));
    places.push_back({plain(on_incident ? pair.point_b : pair.point_a), pair.depth});
  }
  unsigned chosen = 0;
  for (const std::size_t place : SpanningChoice(places, V3(0, 0, 1)).run()) chosen |= 1U << lines[place];
  return chosen;
}

TEST(LaneChoice, IsTheSpanningChoice) {
  int several = 0;
  test::check_property([&] {
    const auto share = [] { return static_cast<double>(*test::choice(1001)) / 1000; };
    const Box below{{0, 0, -1}, {0.2 + share(), 0.2 + share(), 1}};
    const double tilt = *test::choice(2) == 0 ? 0 : 30 * share();
    const Mat<3, double> turn = rotation_matrix(V3(1, share(), 0), tilt) * rotation_matrix(V3(0, 0, 1), 360 * share());
    const Box above{{share() - 0.5, share() - 0.5, 0.9}, {0.2 + share(), 0.2 + share(), 1}, turn};
    const PairedVec up(V3(0, 0, 1));
    FaceOverFace over(face_of_box(paired_box(above, above.center), {2, false}),
                      face_of_box(paired_box(below, below.center), {2, true}), up, up, 1e-14, 0);
    RC_PRE(over.run() && over.size() > 4);
    ++several;
    for (const bool on_incident : {false, true}) {
      const unsigned chosen = LaneChoice(over, up, on_incident).run();
      RC_ASSERT(chosen == spanning(over, on_incident));
      RC_ASSERT(std::popcount(chosen) >= 2);
    }
  });
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace graze::detail::obb_choice_test

#endif
