// SPDX-License-Identifier: MIT
// The nearest face is the one that a search among all of them finds, and its shares make the nearest point.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/hull_simplex.hpp>
#include <graze/query/simplex.hpp>

namespace graze::detail::hull_simplex_test {
namespace {

using Point = Vec<3, double>;

/// Ten thousand walks to the origin, as GJK makes them: of random points always one that leads nearer is added.
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
      if (face.size > 0 && !(dot(face.nearest, point) < 0.999 * face.squared)) continue;
      std::uint8_t place = 0;
      while (std::find(face.places.begin(), face.places.begin() + face.size, place) !=
             face.places.begin() + face.size) {
        ++place;
      }
      simplex[place] = point;
      const NearFace found = near_face(simplex, place, face);
      visit(simplex, face, place, found);
      face = found;
    }
  }
}

void expect_nearest(const HullSimplex& simplex, const NearFace& before, std::uint8_t newest, const NearFace& found,
                    double slack) {
  Simplex<3> all;
  for (std::size_t i = 0; i < before.size; ++i) all.push(simplex[before.places[i]]);
  all.push(simplex[newest]);
  const NearestOnSimplex<3> right = nearest_to_origin(all);
  EXPECT_NEAR(std::sqrt(found.squared), std::sqrt(right.distance_squared), slack);
  ASSERT_EQ(found.size, right.face.size);
  Point made(0.0);
  double sum = 0;
  for (std::size_t i = 0; i < found.size; ++i) {
    EXPECT_GE(found.shares[i], 0);
    sum += found.shares[i];
    made += simplex[found.places[i]] * found.shares[i];
  }
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_NEAR(length(made - found.nearest), 0, slack);
  EXPECT_EQ(found.squared, dot(found.nearest, found.nearest));
}

TEST(HullSimplex, FindsTheNearestFace) {
  std::size_t sizes[5] = {};
  walk_to_origin(1, 1, [&](const auto& simplex, const auto& before, std::uint8_t newest, const auto& found) {
    expect_nearest(simplex, before, newest, found, 1e-9);
    ++sizes[found.size];
  });
  for (const std::size_t size : {1U, 2U, 3U, 4U}) EXPECT_GT(sizes[size], 500U) << size;
}

TEST(HullSimplex, FindsTheNearestFaceFromAfar) {
  walk_to_origin(1, 1e4, [](const auto& simplex, const auto& before, std::uint8_t newest, const auto& found) {
    expect_nearest(simplex, before, newest, found, 1e-6);
  });
}

TEST(HullSimplex, FindsNothingWorseInFlatOnes) {
  const HullSimplex simplex{Point(1, -1, 0), Point(1, 1, 0), Point(2, 0, 0), Point(1.5, 0, 0)};
  NearFace face;
  face.size = 3;
  face.places = {0, 1, 2, 0};
  const NearFace found = near_face(simplex, 3, face);
  EXPECT_TRUE(!(found.squared < 1));  // so that a walk goes no further
  const HullSimplex twice{Point(1, 2, 3), Point(1, 2, 3)};
  face.size = 1;
  EXPECT_EQ(near_face(twice, 1, face).squared, 14);
}

}  // namespace
}  // namespace graze::detail::hull_simplex_test
