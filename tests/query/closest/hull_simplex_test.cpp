// SPDX-License-Identifier: MIT
// The nearest face is the one that a search among all of them finds, and its weights give the nearest point.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/closest/hull_simplex.hpp>
#include <graze/query/convex/simplex.hpp>

namespace graze::detail::hull_simplex_test {
namespace {

using Point = Vec<3, double>;

Point nearest_on(const NearFace& face) {
  return face.size == 4 ? Point(0.0) : face.toward * (face.height / dot(face.toward, face.toward));
}

/// Ten thousand walks to the origin, as in GJK: each step adds one of some random points that leads nearer.
template <class Visit>
void walk_to_origin(double size, double distance, const Visit& visit) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int walk = 0; walk < 10'000; ++walk) {
    const Point middle = Point(number(engine), number(engine), number(engine)) * distance;
    HullSimplex simplex;
    NearFace face;
    for (int step = 0; step < 12 && face.size < 4; ++step) {
      const Point point = middle + Point(number(engine), number(engine), number(engine)) * size;
      if (face.size > 0 && !(dot(nearest_on(face), point) < 0.999 * face.squared)) continue;
      const auto is_taken = [&face](std::uint32_t place) {
        for (std::size_t i = 0; i < face.size; ++i) {
          if (face.places[i] == place) return true;
        }
        return false;
      };
      std::uint32_t place = 0;
      while (is_taken(place)) ++place;
      simplex[place] = point;
      const NearFace found = near_face(simplex, {place, point}, face);
      visit(simplex, face, place, found);
      face = found;
    }
  }
}

void expect_nearest(const HullSimplex& simplex, const NearFace& before, std::uint32_t newest, const NearFace& found,
                    double slack) {
  Simplex<3> all;
  for (std::size_t i = 0; i < before.size; ++i) all.push(simplex[before.places[i]]);
  all.push(simplex[newest]);
  const NearestOnSimplex<3> right = nearest_to_origin(all);
  EXPECT_NEAR(std::sqrt(found.squared), std::sqrt(right.distance_squared), slack);
  ASSERT_EQ(found.size, right.face.size);
  const std::array<double, 4> shares = shares_of(simplex, found);
  Point made(0.0);
  double sum = 0;
  for (std::size_t i = 0; i < found.size; ++i) {
    EXPECT_GE(shares[i], 0);
    sum += shares[i];
    made += simplex[found.places[i]] * shares[i];
  }
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_NEAR(length(made - nearest_on(found)), 0, slack);
  EXPECT_NEAR(length(nearest_on(found)), std::sqrt(found.squared), 1e-13 * std::sqrt(found.squared));
}

TEST(HullSimplex, FindsTheNearestFace) {
  std::size_t sizes[5] = {};
  walk_to_origin(1, 1, [&](const auto& simplex, const auto& before, std::uint32_t newest, const auto& found) {
    expect_nearest(simplex, before, newest, found, 1e-9);
    ++sizes[found.size];
  });
  for (const std::size_t size : {1U, 2U, 3U, 4U}) EXPECT_GT(sizes[size], 500U) << size;
}

TEST(HullSimplex, FindsTheNearestFaceFromAfar) {
  walk_to_origin(1, 1e4, [](const auto& simplex, const auto& before, std::uint32_t newest, const auto& found) {
    expect_nearest(simplex, before, newest, found, 1e-6);
  });
}

TEST(HullSimplex, FindsNothingWorseInFlatOnes) {
  const HullSimplex simplex{Point(1, -1, 0), Point(1, 1, 0), Point(2, 0, 0), Point(1.5, 0, 0)};
  NearFace face;
  face.size = 3;
  face.places = HullPlaces(0, 1, 2);
  const NearFace found = near_face(simplex, {3, simplex[3]}, face);
  EXPECT_TRUE(!(found.squared < 1));  // so that a walk goes no further
  const HullSimplex twice{Point(1, 2, 3), Point(1, 2, 3)};
  face.size = 1;
  face.places = HullPlaces(0);
  EXPECT_EQ(near_face(twice, {1, twice[1]}, face).squared, 14);
}

}  // namespace
}  // namespace graze::detail::hull_simplex_test
