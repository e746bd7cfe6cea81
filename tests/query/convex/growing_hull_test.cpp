// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/orientation_3d.hpp>
#include <graze/query/convex/growing_hull.hpp>
#include <graze/shape/polytope.hpp>

#include "catalogue.hpp"

namespace graze::test::growing_hull_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

TEST(Frame, GrowsByWhatIsBesideItsSpan) {
  detail::Frame<3> frame;
  EXPECT_TRUE(frame.add(V3(0, 2, 0), 0));
  EXPECT_FALSE(frame.add(V3(0, -5, 0), 0)) << "along the first";
  EXPECT_FALSE(frame.add(V3(0, 3, 0.125), 0.25)) << "too short compared with the first";
  EXPECT_TRUE(frame.add(V3(0, 3, 0.5), 0.25));
  EXPECT_FALSE(frame.is_full());
  EXPECT_TRUE(frame.add(V3(1, 7, 8), 0));
  EXPECT_TRUE(frame.is_full());
  EXPECT_FALSE(frame.add(V3(9, 9, 9), 0));
}

TEST(Frame, KnowsADirectionAcrossItsSpan) {
  detail::Frame<3> frame;
  EXPECT_EQ(frame.across(), V3(1, 0, 0));
  frame.add(V3(3, 4, 0), 0);
  EXPECT_NEAR(dot(frame.across(), V3(3, 4, 0)), 0, 1e-15);
  EXPECT_NEAR(dot(frame.across(), frame.across()), 1, 1e-15);
  frame.add(V3(0, 0, 2), 0);
  EXPECT_NEAR(dot(frame.across(), V3(3, 4, 0)), 0, 1e-15);
  EXPECT_NEAR(frame.across().z, 0, 1e-15);
  detail::Frame<2> flat;
  flat.add(V2(3, 4), 0);
  EXPECT_NEAR(dot(flat.across(), V2(3, 4)), 0, 1e-15);
}

template <Dim N>
detail::GrowingHull<N> hull_of(const std::vector<Vec<N, double>>& points) {
  return detail::GrowingHull<N>(points);
}

TEST(GrowingHull, OfThePlaneKnowsItsNearestFace) {
  const auto square = hull_of<2>({{-1, -2}, {3, -2}, {3, 2}, {-1, 2}, {0, 0}});
  const auto face = square.nearest_face();
  ASSERT_TRUE(face);
  EXPECT_EQ(face->height, 1);
  EXPECT_EQ(face->normal, V2(-1, 0));
}

TEST(GrowingHull, OfPointsOnALineHasNoFace) {
  EXPECT_FALSE(hull_of<2>({{0, 0}, {1, 1}, {2, 2}}).nearest_face());
  EXPECT_FALSE(hull_of<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).nearest_face());
}

TEST(GrowingHull, GrowsByNewPointsOnly) {
  auto hull = hull_of<2>({{-1, -1}, {1, -1}, {0, 1}});
  const auto face = hull.nearest_face();
  EXPECT_FALSE(hull.insert(V2(1, -1), *face)) << "known";
  EXPECT_FALSE(hull.insert(V2(0, 0), *face)) << "inside";
  EXPECT_FALSE(hull.insert(V2(0, -1), *face)) << "on an edge";
  EXPECT_TRUE(hull.insert(V2(0, -3), *face));
  auto solid = hull_of<3>({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}});
  const auto floor = solid.nearest_face();
  EXPECT_FALSE(solid.insert(V3(3, -1, -1), *floor)) << "known";
  EXPECT_FALSE(solid.insert(V3(0, 0, 0), *floor)) << "inside";
  EXPECT_TRUE(solid.insert(V3(0, 0, -5), *floor));
}

TEST(GrowingHull, OfACubeHasTheCubesHeights) {
  std::vector<V3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1U) != 0 ? 2 : -3, (i & 2U) != 0 ? 2 : -3, (i & 4U) != 0 ? 2 : -1);
  }
  const auto face = hull_of<3>(corners).nearest_face();
  ASSERT_TRUE(face);
  EXPECT_EQ(face->height, 1);
  EXPECT_EQ(face->normal, V3(0, 0, -1));
}

/// The nearest face of the hull of all points, rebuilt; the first of several, starting at the first corner.
detail::HullFace<2> nearest_face_of(const std::vector<V2>& points) {
  const auto polygon = convex_hull<2, double>(points);
  const auto corners = polygon.vertices();
  detail::HullFace<2> nearest{{}, V2(0.0), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const V2 edge = corners[(i + 1) % corners.size()] - corners[i];
    const V2 normal = V2(edge.y, -edge.x) / std::sqrt(dot(edge, edge));
    if (dot(normal, corners[i]) < nearest.height) nearest = {{}, normal, dot(normal, corners[i])};
  }
  return nearest;
}

/// Adds points one by one; integers, so that many coincide or are collinear, or random ones.
void expect_as_made_anew(bool whole_numbers) {
  check_property([whole_numbers] {
    const auto number = drawn<double>([whole_numbers](rc::Random& random) {
      return whole_numbers ? static_cast<double>(whole(random, -4, 4)) : between(random, -4, 4);
    });
    const auto point = vector_of<2, double>(number);
    std::vector<V2> points{{-1, -1}, {1, -1}, {0, 1}};
    auto hull = hull_of<2>(points);
    for (int i = 0; i < 20; ++i) {
      const auto before = convex_hull<2, double>(points);
      points.push_back(*point);
      const auto after = convex_hull<2, double>(points);
      const bool is_corner = std::count(after.vertices().begin(), after.vertices().end(), points.back()) > 0;
      const bool is_new = std::count(before.vertices().begin(), before.vertices().end(), points.back()) == 0;
      RC_ASSERT(hull.insert(points.back(), *hull.nearest_face()) == (is_corner && is_new));
      const auto face = hull.nearest_face();
      const auto expected = nearest_face_of(points);
      RC_ASSERT(face.has_value());
      RC_ASSERT(face->height == expected.height);
      RC_ASSERT(face->normal == expected.normal);
    }
  });
}

TEST(GrowingHull, OfThePlaneIsAsMadeAnewFromAllPoints) {
  expect_as_made_anew(true);
  expect_as_made_anew(false);
}

/// Points on a large sphere, all of them corners, distributed by the golden angle.
template <Dim N>
Vec<N, double> far_corner(std::size_t i, std::size_t count) {
  const double angle = 2.399963229728653 * static_cast<double>(i);
  if constexpr (N == 2) {
    return V2(std::cos(angle), std::sin(angle)) * 100.0;
  } else {
    const double z = (2 * static_cast<double>(i) + 1) / static_cast<double>(count) - 1;
    const double across = std::sqrt(1 - z * z);
    return V3(across * std::cos(angle), across * std::sin(angle), z) * 100.0;
  }
}

template <Dim N>
void expect_room() {
  constexpr std::size_t most = detail::most_hull_starts<N> + detail::most_hull_inserts;
  std::vector<Vec<N, double>> start;
  for (std::size_t i = 0; i < detail::most_hull_starts<N>; ++i) start.push_back(far_corner<N>(i * 11, most + 1));
  auto hull = hull_of<N>(start);
  std::size_t inserted = 0;
  bool goes_on = true;
  for (std::size_t i = 0; i <= most && goes_on; ++i) {
    if (i % 11 == 0 && i / 11 < start.size()) continue;
    goes_on = hull.insert(far_corner<N>(i, most + 1), *hull.nearest_face());
    if (goes_on) ++inserted;
  }
  EXPECT_EQ(inserted, detail::most_hull_inserts);
  EXPECT_FALSE(goes_on) << "it is full";
  const auto face = hull.nearest_face();
  ASSERT_TRUE(face);
  EXPECT_GT(face->height, N == 2 ? 99.8 : 90.0) << "still nearly a sphere";
}

TEST(GrowingHull, HasRoomForAsManyPointsAsItSays) {
  expect_room<2>();
  expect_room<3>();
  static_assert(sizeof(detail::GrowingHull<2>) < 2500);
  static_assert(sizeof(detail::GrowingHull<3>) < 18600);
}

/// Every point that was added is inside, up to rounding: no face has it above.
template <Dim N>
void expect_inside() {
  check_property([] {
    using V = Vec<N, double>;
    const auto ways = vector_of<N, double>(drawn<double>([](rc::Random& random) { return between(random, -1, 1); }));
    std::vector<V> points;
    for (int i = 0; i < 12; ++i) points.push_back(*ways + V(0.125));
    auto hull = hull_of<N>({points.begin(), points.begin() + N + 1});
    const auto first = hull.nearest_face();
    RC_PRE(first.has_value());
    for (const V& point : points) hull.insert(point, *first);
    const auto face = hull.nearest_face();
    RC_ASSERT(face.has_value());
    for (const V& point : points) RC_ASSERT(dot(face->normal, point) <= face->height + 1e-14);
    RC_ASSERT(std::fabs(dot(face->normal, face->normal) - 1) <= 1e-14);
  });
}

/// Points that rounding alone keeps from being in one plane, beside some that are not.
TEST(GrowingHull, HasNoFaceTurnedInsideOutHoweverFlat) {
  check_property([] {
    const auto number = drawn<double>([](rc::Random& random) { return between(random, -1, 1); });
    const V3 normal = *vector_of<3, double>(number);
    RC_PRE(max_abs(normal) > 0.1);
    const V3 unit = normal / std::sqrt(dot(normal, normal));
    std::vector<V3> points{unit * -1.0};
    for (int i = 0; i < 12; ++i) {
      const V3 point = *vector_of<3, double>(number);
      points.push_back(point + unit * (1e-3 - dot(unit, point)));
    }
    auto hull = hull_of<3>({points.begin(), points.begin() + 6});
    const auto first = hull.nearest_face();
    RC_PRE(first.has_value());
    for (const V3& point : points) hull.insert(point, *first);
    while (const auto face = hull.nearest_face()) {
      const auto [a, b, c] = hull.corners_of(*face);
      for (const V3& point : points) RC_ASSERT(orientation(a, b, c, point) <= 0);
      hull.settle(*face);
    }
  });
}

template <Dim N>
void expect_settling(detail::GrowingHull<N> hull, std::size_t faces) {
  double height = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    const auto face = hull.nearest_face();
    ASSERT_TRUE(face) << i;
    EXPECT_GE(face->height, height);
    height = face->height;
    EXPECT_TRUE(hull.settle(*face));
  }
  EXPECT_FALSE(hull.nearest_face());
}

TEST(GrowingHull, ASettledFaceIsNotTheNearest) {
  expect_settling(hull_of<2>({{-1, -2}, {3, -2}, {3, 2}, {-1, 2}}), 4);
  expect_settling(hull_of<3>({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}), 4);
}

TEST(GrowingHull, HoldsEveryPointPutIn) {
  expect_inside<2>();
  expect_inside<3>();
}

}  // namespace
}  // namespace graze::test::growing_hull_test
