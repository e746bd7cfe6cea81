// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/hull/faces.hpp>

#include "catalogue.hpp"
#include "query/point_sets.hpp"
#include "shape/hull_surface.hpp"

namespace graze::detail::hull_faces_test {
namespace {

using test::corners_of;
using test::is_hull_of;

template <class T>
std::vector<HullTriangle> faces_of(const std::vector<Vec<3, T>>& points) {
  return hull_faces(std::span<const Vec<3, T>>(points));
}

/// By brute force.
template <class T>
bool are_on_one_plane(const std::vector<Vec<3, T>>& points) {
  for (std::size_t b = 1; b < points.size(); ++b) {
    for (std::size_t c = b + 1; c < points.size(); ++c) {
      for (std::size_t d = c + 1; d < points.size(); ++d) {
        if (orientation(points[0], points[b], points[c], points[d]) != 0) return false;
      }
    }
  }
  return true;
}

TEST(HullFaces, OfACubeAreTwelve) {
  std::vector<Vec<3, float>> points;
  for (const float x : {0.0F, 1.0F, 2.0F}) {
    for (const float y : {0.0F, 1.0F, 2.0F}) {
      for (const float z : {0.0F, 1.0F, 2.0F}) points.push_back({x, y, z});
    }
  }
  const auto faces = faces_of(points);
  EXPECT_TRUE(is_hull_of(faces, points));
  const std::vector<Vec<3, float>> corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2},
                                           {2, 2, 0}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
  EXPECT_EQ(faces_of(corners).size(), 12U);
  for (const Vec<3, float>& corner : corners) {
    const auto place = static_cast<std::uint32_t>(std::find(points.begin(), points.end(), corner) - points.begin());
    EXPECT_EQ(corners_of(faces).count(place), 1U);
  }
}

TEST(HullFaces, OfPointsOnOnePlaneAreNone) {
  EXPECT_TRUE(faces_of<float>({}).empty());
  EXPECT_TRUE(faces_of<float>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).empty());
  EXPECT_TRUE(faces_of<float>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {-1, -1, -1}}).empty());
  EXPECT_TRUE(faces_of<float>({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}, {7, -3, 5}}).empty());
}

TEST(HullFaces, KeepACornerThatSticksOutByOneBit) {
  std::vector<Vec<3, double>> points{{0, 0, 0}, {4, 0, 0},  {0, 4, 0},
                                     {4, 4, 0}, {2, 2, -3}, {1, 1, std::nextafter(0.0, 1.0) + 0x1p-60}};
  const auto faces = faces_of(points);
  EXPECT_TRUE(is_hull_of(faces, points));
  EXPECT_EQ(corners_of(faces).count(5), 1U);
}

template <class T>
class HullFacesIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullFacesIn, Scalars);

TYPED_TEST(HullFacesIn, AreAClosedSurfaceAroundAllPoints) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(40);
    const auto faces = faces_of(points);
    if (faces.empty()) {
      RC_ASSERT(are_on_one_plane(points));
    } else {
      RC_ASSERT(is_hull_of(faces, points));
    }
  });
}

TYPED_TEST(HullFacesIn, AreRightForThousandsOnASphereAndInACube) {
  using T = TypeParam;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<Vec<3, T>> sphere;
  std::vector<Vec<3, T>> cube;
  for (int i = 0; i < 1000; ++i) {
    const double x = normal(random);
    const double y = normal(random);
    const double z = normal(random);
    const double length = std::sqrt(x * x + y * y + z * z);
    sphere.push_back(Vec<3, T>(Vec<3, double>(x, y, z) / length));
    cube.push_back(Vec<3, T>(Vec<3, double>(std::fmod(x, 1.0), std::fmod(y, 1.0), std::fmod(z, 1.0))));
  }
  const auto around_sphere = faces_of(sphere);
  EXPECT_TRUE(is_hull_of(around_sphere, sphere));
  EXPECT_GT(corners_of(around_sphere).size(), 950U);
  EXPECT_TRUE(is_hull_of(faces_of(cube), cube));
}

}  // namespace
}  // namespace graze::detail::hull_faces_test
