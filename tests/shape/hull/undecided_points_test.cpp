// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/hull/edges.hpp>
#include <graze/shape/hull/faces.hpp>
#include <graze/shape/hull/flat_points.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>
#include <graze/shape/hull/vertices.hpp>

#include "catalogue.hpp"
#include "shape/hull_surface.hpp"
#include "shape/thin_clouds.hpp"

namespace graze::detail::hull_doubts_test {
namespace {

using test::ThinCloud;

template <class T>
std::vector<Vec<3, T>> sorted(const std::vector<Vec<3, T>>& points, const std::vector<std::uint32_t>& places) {
  std::vector<Vec<3, T>> result;
  for (const std::uint32_t place : places) result.push_back(points[place]);
  std::sort(result.begin(), result.end(), lexicographically_less<3, T>);
  return result;
}

template <class T>
std::vector<std::uint32_t> corners_of_hull(const Quickhull<T>& hull) {
  const std::vector<bool> is_vertex = are_vertices(hull, bent_edges(hull));
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < is_vertex.size(); ++i) {
    if (is_vertex[i]) vertices.push_back(hull.corners()[i].index);
  }
  return vertices;
}

/// The corners of the hull, in order, by a quickhull that decides each point exactly at once.
template <class T>
std::vector<Vec<3, T>> careful_vertices(const std::vector<Vec<3, T>>& points) {
  const HullFrame<T> frame{std::span<const Vec<3, T>>(points)};
  const Quickhull<T> any(frame, all_points(frame));
  std::vector<HullPoint> base;
  for (const std::uint32_t point : any.base()) base.push_back(frame.at(point));
  Quickhull<T> hull(frame, base);
  if (base.size() < 4) return sorted(points, flat_vertices(hull));
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  hull.add(all);
  return sorted(points, corners_of_hull(hull));
}

template <class T>
std::vector<Vec<3, T>> vertices_of(const std::vector<Vec<3, T>>& points) {
  return sorted(points, hull_vertices(std::span<const Vec<3, T>>(points)));
}

/// The same by a hull that sifts undecided points however few there are.
template <class T>
std::vector<Vec<3, T>> sifted_vertices(const std::vector<Vec<3, T>>& points) {
  const HullFrame<T> frame{std::span<const Vec<3, T>>(points)};
  const Quickhull<T> hull = sifted_hull(frame);
  if (hull.base().size() < 4) return sorted(points, flat_vertices(hull));
  return sorted(points, corners_of_hull(hull));
}

TEST(HullDoubts, AreSiftedToAFewOfManyPointsOnALine) {
  const auto points = test::thin_crowd<double>(ThinCloud::lines, 4000, 3);
  const HullFrame<double> frame(points);
  std::vector<HullPoint> candidates = all_points(frame);
  Quickhull<double> hull;
  hull.start(frame, candidates);
  EXPECT_TRUE(candidates.empty());
  EXPECT_GT(hull.aside().size(), 2000U);
  UndecidedPoints undecided = settle_clear(hull);
  EXPECT_GT(undecided.undecided.size(), 2000U);
  EXPECT_LT(corners_of_faces(hull).size(), 30U);
  GroupMemory<double> memory;
  keep_outer(hull, undecided, memory);
  EXPECT_LT(undecided.undecided.size(), 500U);
  EXPECT_GT(undecided.undecided.size(), 20U);
}

TEST(HullDoubts, AreNoneOnAGrid) {
  std::vector<Vec<3, float>> grid;
  for (int i = 0; i < 1000; ++i) grid.emplace_back(i % 10, i / 10 % 10, i / 100);
  const HullFrame<float> frame(grid);
  EXPECT_TRUE(Quickhull<float>(frame, all_points(frame)).aside().empty());
}

// Without this, one and a half million points would be undecided about each of as many edges.
TEST(HullDoubts, AreNoneAtACornerOfManyFaces) {
  constexpr int count = 3000;
  std::vector<Vec<3, double>> cone(count, Vec<3, double>(0.1, 0.2, 3.3));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159 * i / count;
    cone.emplace_back(std::cos(angle), std::sin(angle), 0.01 * std::cos(7 * angle));
  }
  const HullFrame<double> frame(cone);
  Quickhull<double> hull(frame, all_points(frame));
  for (const auto& doubt : settle_clear(hull).undecided) EXPECT_GE(doubt.point, static_cast<std::uint32_t>(count));
}

/// A cone with this many faces, and repeated points at 27 positions slightly apart around its tip.
std::vector<Vec<3, double>> cone_with_blunt_tip(int faces, int repeats) {
  const Vec<3, double> tip(0.1, 0.2, 3.3);
  std::vector<Vec<3, double>> cone;
  for (int i = 0; i < faces; ++i) {
    const double angle = 2 * 3.14159 * i / faces;
    cone.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  for (int i = 0; i < 27 * repeats; ++i) {
    const std::array<int, 3> steps = {i % 3 - 1, i / 3 % 3 - 1, i / 9 % 3 - 1};
    Vec<3, double> near = tip;
    for (Dim k = 0; k < 3; ++k) near[k] += 0x1p-52 * steps[static_cast<std::size_t>(k)] * near[k];
    cone.push_back(near);
  }
  return cone;
}

TEST(HullDoubts, AreSettledWhereTheirFacesAreTooManyToBeListed) {
  std::vector<Vec<3, double>> cone = cone_with_blunt_tip(300, 1);
  EXPECT_EQ(sifted_vertices(cone), careful_vertices(cone));
  std::reverse(cone.begin(), cone.end());
  EXPECT_EQ(sifted_vertices(cone), careful_vertices(cone));
}

TEST(HullDoubts, AreFewAtFewPlaces) {
  const std::vector<Vec<3, double>> cone = cone_with_blunt_tip(300, 100);
  const HullFrame<double> frame(cone);
  Quickhull<double> hull(frame, all_points(frame));
  UndecidedPoints undecided = settle_clear(hull);
  EXPECT_GT(undecided.undecided.size(), 1000U);
  GroupMemory<double> memory;
  keep_outer(hull, undecided, memory);
  EXPECT_LE(undecided.undecided.size(), 54U);
  EXPECT_EQ(sifted_vertices(cone), sifted_vertices(cone_with_blunt_tip(300, 1)));
}

TEST(HullDoubts, PayToBeSiftedWhereMostPointsAreOnLines) {
  const auto pays = [](const std::vector<Vec<3, double>>& points) {
    const HullFrame<double> frame(points);
    HullMemory<double> memory;
    return pays_to_sift(frame, core_of(frame), memory);
  };
  EXPECT_TRUE(pays(test::thin_crowd<double>(ThinCloud::lines, 20000, 3)));
  std::vector<Vec<3, double>> sphere = test::thin_crowd<double>(ThinCloud::cube_faces, 20000, 3);
  for (Vec<3, double>& point : sphere) point /= std::sqrt(dot(point, point));
  EXPECT_FALSE(pays(sphere));
}

// Data of the previous hull must not affect the next one.
TEST(HullDoubts, AreTheSameInMemoryThatHasBeenUsed) {
  HullMemory<double> used;
  for (std::size_t cluster = 0; cluster < test::thin_clouds; ++cluster) {
    for (const std::size_t count : {3U, 900U, 40U}) {
      const auto points = test::thin_crowd<double>(static_cast<ThinCloud>(cluster), count, cluster);
      const HullFrame<double> frame(points);
      const auto of = [&frame](HullMemory<double>& memory) {
        std::vector<HullPoint> candidates = all_points(frame);
        std::vector<HullPoint> result;
        add_sifted(frame, candidates, memory, result);
        std::vector<std::uint32_t> places;
        for (const HullPoint& point : result) places.push_back(point.index);
        return places;
      };
      HullMemory<double> fresh;
      EXPECT_EQ(of(used), of(fresh)) << cluster << ", " << count;
    }
  }
}

template <class T>
class HullDoubtsIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullDoubtsIn, Scalars);

TYPED_TEST(HullDoubtsIn, LeaveAClosedSurfaceAroundAllPoints) {
  using T = TypeParam;
  test::check_property([] {
    const auto cluster = static_cast<ThinCloud>(*test::choice(test::thin_clouds));
    const std::vector<Vec<3, T>> points =
        test::thin_crowd<T>(cluster, 4 + *test::choice(250), *test::choice(1U << 30U));
    const HullFrame<T> frame{std::span<const Vec<3, T>>(points)};
    const Quickhull<T> hull = sifted_hull(frame);
    std::vector<HullTriangle> faces;
    for (const auto& face : hull.faces()) {
      if (face.is_alive) faces.push_back(hull.indices_of(face));
    }
    if (!faces.empty()) RC_ASSERT(test::is_hull_of(faces, points));
  });
}

TYPED_TEST(HullDoubtsIn, AreSettledAsTheCarefulWaySettlesThem) {
  using T = TypeParam;
  test::check_property([] {
    const auto cluster = static_cast<ThinCloud>(*test::choice(test::thin_clouds));
    std::vector<Vec<3, T>> points = test::thin_crowd<T>(cluster, 4 + *test::choice(800), *test::choice(1U << 30U));
    const std::vector<Vec<3, T>> expected = careful_vertices(points);
    RC_ASSERT(vertices_of(points) == expected);
    RC_ASSERT(sifted_vertices(points) == expected);
    std::reverse(points.begin(), points.end());
    RC_ASSERT(vertices_of(points) == expected);
    RC_ASSERT(sifted_vertices(points) == expected);
  });
}

// So many that they are sifted before all others are decided.
TYPED_TEST(HullDoubtsIn, AreSettledTheSameForMany) {
  using T = TypeParam;
  for (std::size_t cluster = 0; cluster < test::thin_clouds; ++cluster) {
    const auto points = test::thin_crowd<T>(static_cast<ThinCloud>(cluster), 12000, cluster);
    EXPECT_EQ(vertices_of(points), careful_vertices(points)) << cluster;
  }
}

// So many that they are sifted in pieces, if that pays.
TYPED_TEST(HullDoubtsIn, AreSettledTheSameByPieces) {
  using T = TypeParam;
  for (const ThinCloud cluster : {ThinCloud::lines, ThinCloud::cube_edges}) {
    const auto points = test::thin_crowd<T>(cluster, 70000, 5);
    const HullFrame<T> frame{std::span<const Vec<3, T>>(points)};
    HullMemory<T> memory;
    EXPECT_LT(sifted_candidates(frame, memory).size(), points.size() / 5);
    std::vector<Vec<3, T>> expected;
    for (std::size_t first = 0; first < points.size(); first += 10000) {
      const auto start = points.begin() + static_cast<std::ptrdiff_t>(first);
      std::vector<Vec<3, T>> part(start, start + 10000);
      part.insert(part.end(), expected.begin(), expected.end());
      expected = vertices_of(part);
    }
    EXPECT_EQ(vertices_of(points), expected);
  }
}

}  // namespace
}  // namespace graze::detail::hull_doubts_test
