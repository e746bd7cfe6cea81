// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/shape/hull/flat_parts.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail::flat_parts_test {
namespace {

template <class T>
std::size_t count_parts(const std::vector<Vec<3, T>>& points) {
  const HullFrame<T> frame{std::span<const Vec<3, T>>(points)};
  const Quickhull<T> hull(frame, all_points(frame));
  FlatParts<T> parts(hull);
  std::set<std::uint32_t> found;
  for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
    if (hull.faces()[face].is_alive) found.insert(parts.of(face));
  }
  return found.size();
}

TEST(FlatParts, AreTheSidesOfACubeHoweverManyCornersRoundingMakes) {
  std::vector<Vec<3, double>> points;
  const auto turn = rotation_matrix(Vec<3, double>(1, 2, 3), 40.0);
  for (int i = 0; i < 3000; ++i) {
    Vec<3, double> point(i % 7 / 3.0 - 1, i % 11 / 5.0 - 1, i % 13 / 6.0 - 1);
    point[i % 3] = i % 2 == 0 ? 1 : -1;
    points.push_back(turn * point);
  }
  EXPECT_EQ(count_parts(points), 6U);
}

TEST(FlatParts, AreSingleFacesWhereAllAreBent) {
  std::vector<Vec<3, float>> octahedron;
  for (Dim i = 0; i < 3; ++i) {
    for (const float side : {-1.0F, 1.0F}) {
      octahedron.emplace_back(0.0F);
      octahedron.back()[i] = side;
    }
  }
  EXPECT_EQ(count_parts(octahedron), 8U);
}

}  // namespace
}  // namespace graze::detail::flat_parts_test
