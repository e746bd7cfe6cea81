// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/hull/core.hpp>
#include <graze/shape/hull/faces.hpp>

namespace graze::detail::hull_core_test {
namespace {

using Points = std::vector<Vec<3, double>>;

class HullCoreOf : public testing::Test {
 protected:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec<3, double> vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }

  Points sphere(std::size_t count, const Vec<3, double>& extents, const Vec<3, double>& center) {
    Points points;
    while (points.size() < count) {
      const Vec<3, double> point = vector();
      if (dot(point, point) <= 1) points.push_back(center + extents * point);
    }
    return points;
  }

  /// The share of all points that the core of `count` of them contains. All of these must be strictly inside the hull.
  static double share_held(const Points& points, std::size_t count) {
    const HullFrame<double> frame(points);
    std::vector<HullPoint> sample = all_points(frame);
    sample.resize(count);
    const HullCore core(sample, frame.half_extents());
    const std::vector<HullTriangle> faces = hull_faces(std::span<const Vec<3, double>>(points).first(count));
    std::size_t held = 0;
    for (std::uint32_t i = 0; i < frame.size(); ++i) {
      if (!core.holds(frame.at(i).place)) continue;
      ++held;
      for (const HullTriangle& face : faces) {
        if (frame.orientation_of(face, i) >= 0) ADD_FAILURE() << "point " << i << " is not inside";
      }
    }
    return static_cast<double>(held) / static_cast<double>(points.size());
  }

 private:
  std::mt19937 random_{11};
};

TEST_F(HullCoreOf, ABallHoldsMostOfIt) { EXPECT_GT(share_held(sphere(2000, {1, 1, 1}, {0, 0, 0}), 500), 0.6); }

TEST_F(HullCoreOf, ABallFarFromTheOriginHoldsAsMuch) {
  EXPECT_GT(share_held(sphere(2000, {1, 1, 1}, {1e7, -1e7, 3}), 500), 0.6);
}

TEST_F(HullCoreOf, ANeedleAndADiskAlongTheAxesHoldAsMuch) {
  EXPECT_GT(share_held(sphere(2000, {1e-2, 1, 1e-2}, {0, 0, 0}), 500), 0.5);
  EXPECT_GT(share_held(sphere(2000, {1e3, 1, 1e3}, {0, 7, 0}), 500), 0.5);
}

TEST_F(HullCoreOf, ATetrahedronHoldsOnlyWhatIsInside) {
  Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 60; ++i) points.push_back({0.1, 0.1, 0.1});
  for (int i = 0; i < 2000; ++i) points.push_back(vector() * 0.6 + Vec<3, double>(0.3));
  EXPECT_GT(share_held(points, 64), 0.05);
}

TEST_F(HullCoreOf, AGridHoldsItsInside) {
  Points points;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      for (int z = 0; z < 10; ++z) points.push_back(0.1 * Vec<3, double>(x, y, z));
    }
  }
  const HullFrame<double> frame(points);
  const HullCore core(all_points(frame), frame.half_extents());
  for (std::uint32_t i = 0; i < frame.size(); ++i) {
    const auto is_between = [](std::uint32_t x) { return x % 10 > 0 && x % 10 < 9; };
    EXPECT_EQ(core.holds(frame.at(i).place), is_between(i) && is_between(i / 10) && is_between(i / 100)) << i;
  }
}

TEST_F(HullCoreOf, FlatPointsOrCornersAloneHoldsNothing) {
  Points flat;
  Points sphere;
  for (int i = 0; i < 500; ++i) {
    const Vec<3, double> way = vector();
    flat.push_back({way.x, way.y, 1e-9 * way.z});
    sphere.push_back(way / std::sqrt(dot(way, way)));
  }
  EXPECT_EQ(share_held(flat, 500), 0);
  EXPECT_EQ(share_held(sphere, 500), 0);
  EXPECT_EQ(share_held(Points(500, Vec<3, double>(4)), 500), 0);
}

TEST_F(HullCoreOf, CandidatesAreAllPointsOfAFewAndOfManyTheOuterOnes) {
  const Points few = sphere(3000, {1, 1, 1}, {0, 0, 0});
  std::vector<HullPoint> candidates;
  put_candidates(HullFrame<double>(few), candidates);
  EXPECT_EQ(candidates.size(), few.size());
  const Points many = sphere(20000, {1, 1, 1}, {0, 0, 0});
  const HullFrame<double> frame(many);
  put_candidates(frame, candidates);
  EXPECT_LT(candidates.size(), many.size() / 3);
  for (const HullPoint& candidate : candidates) EXPECT_EQ(candidate.place, frame.at(candidate.index).place);
}

}  // namespace
}  // namespace graze::detail::hull_core_test
