// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/orientation_3d.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/visibility.hpp>

#include "catalogue.hpp"
#include "shape/thin_clouds.hpp"

namespace graze::detail::hull_sight_test {
namespace {

using Points = std::vector<Vec<3, double>>;

/// Whether a point is strictly outside of some face, exactly.
bool is_outside(Quickhull<double>& hull, const HullPoint& point) {
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (hull.faces()[face].is_alive && hull.is_outside(face, point)) return true;
  }
  return false;
}

TEST(HullVisibility, TellsTheFacesThatAPointStandsBefore) {
  Points points;
  for (int i = 0; i < 8; ++i) points.emplace_back((i & 1) / 3.0, (i >> 1 & 1) / 3.0, (i >> 2 & 1) / 3.0);
  points.push_back(points[5]);
  points.push_back((points[6] + points[7]) * 0.5);
  const HullFrame<double> frame(points);
  const Quickhull<double> hull(frame, all_points(frame));
  HullVisibility<double> verdict(hull);
  ASSERT_TRUE(verdict.is_clear());
  const auto count_before = [&](const Vec<3, double>& point) {
    HullPoint seen = frame.seen(point);
    seen.index = 0;
    return verdict.faces_before(seen).size();
  };
  EXPECT_EQ(count_before(Vec<3, double>(0.2, 0.1, 0.6)), 1U);
  EXPECT_EQ(count_before(Vec<3, double>(0.18, 0.19, 0.1)), 1U) << "inside";
  EXPECT_EQ(verdict.faces_before(frame.at(9)).size(), 2U) << "on an edge";
  EXPECT_FALSE(verdict.is_at_corner());
  EXPECT_TRUE(verdict.faces_before(frame.at(8)).empty());
  EXPECT_TRUE(verdict.is_at_corner());
  EXPECT_EQ(count_before(Vec<3, double>(0.2, 0.1, 0.6)), 1U);
  EXPECT_FALSE(verdict.is_at_corner());
}

TEST(HullVisibility, IsNotClearWhereNothingIsInside) {
  Points flat;
  for (int i = 0; i < 5; ++i) flat.emplace_back(0.1 * i, 0.1 * i * i, 1.0);
  flat.emplace_back(0.2, 0.7, 1 + 0x1p-52);
  const HullFrame<double> frame(flat);
  const Quickhull<double> hull(frame, all_points(frame));
  ASSERT_EQ(hull.base().size(), 4U);
  EXPECT_FALSE(HullVisibility<double>(hull).is_clear());
}

// Whether a point is outside of a hull follows from the faces that it faces.
TEST(HullVisibility, KnowsWhatIsOutside) {
  test::check_property([] {
    const auto cluster = static_cast<test::ThinCloud>(*test::choice(test::thin_clouds));
    const Points points = test::thin_crowd<double>(cluster, 5 + *test::choice(200), *test::choice(1U << 30U));
    const HullFrame<double> frame(points);
    std::vector<HullPoint> some;
    for (std::uint32_t i = 0; i < frame.size(); i += 2) some.push_back(frame.at(i));
    for (const std::uint32_t end : frame.ends()) some.push_back(frame.at(end));
    Quickhull<double> hull(frame, some);
    if (hull.base().size() < 4) return;
    HullVisibility<double> verdict(hull);
    if (!verdict.is_clear()) return;
    for (std::uint32_t i = 0; i < frame.size(); ++i) {
      HullPoint point = frame.at(i);
      point.link = static_cast<std::uint32_t>(i % (hull.faces().size() + 3));
      const auto faces = verdict.faces_before(point);
      if (verdict.is_at_corner()) {
        RC_ASSERT(!is_outside(hull, point));
        continue;
      }
      RC_PRE(!faces.empty());
      const bool seen =
          std::any_of(faces.begin(), faces.end(), [&](auto face) { return hull.is_outside(face, point); });
      RC_ASSERT(seen == is_outside(hull, point));
    }
  });
}

}  // namespace
}  // namespace graze::detail::hull_sight_test
