// SPDX-License-Identifier: MIT
// Pairs of convex hulls that move past each other, frame by frame, as input for every library.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/posed.hpp>

namespace graze::hull_bench {

using Point = Vec<3, double>;
using Turn = Mat<3, double>;
using Place = Pose<3, double>;
using Hull = Polytope<3, double>;

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Point direction() {
    Point way;
    do {
      way = {number(-1, 1), number(-1, 1), number(-1, 1)};
    } while (dot(way, way) > 1 || dot(way, way) < 0.01);
    return way / std::sqrt(dot(way, way));
  }

  Turn rotation() { return rotation_matrix(direction(), number(0, 360)); }

 private:
  std::mt19937 engine_{20261126};
};

/// The hull of points on an ellipsoid around the origin; all are corners.
inline Hull draw_hull(Random& random, std::size_t corners) {
  const Point half{random.number(0.4, 1), random.number(0.4, 1), random.number(0.4, 1)};
  std::vector<Point> points(corners);
  for (Point& point : points) point = random.direction() * half;
  return convex_hull(points);
}

/// Two hulls with a pose for every frame. They are apart in all frames.
struct MovingPair {
  std::array<Hull, 2> hulls;
  std::vector<std::array<Place, 2>> frames;
};

inline bool are_apart(const MovingPair& pair, const std::array<Place, 2>& places) {
  return !intersects(Posed<Hull>{pair.hulls[0], places[0]}, Posed<Hull>{pair.hulls[1], places[1]});
}

/// The gap is from a twentieth of their size to about half of the distance of the centers; in each frame, both rotate
/// by one degree and move a hundredth of their size closer or farther.
inline MovingPair draw_pair(Random& random, std::size_t corners, std::size_t frames) {
  MovingPair pair;
  do {
    pair = {{draw_hull(random, corners), draw_hull(random, corners)}, {}};
    const Point way = random.direction();
    const double distance = random.number(1.2, 3);
    std::array<Place, 2> places{Place{random.rotation(), way * (-0.5 * distance)},
                                Place{random.rotation(), way * (0.5 * distance)}};
    const std::array<Turn, 2> turns{rotation_matrix(random.direction(), 1.0), rotation_matrix(random.direction(), 1.0)};
    const std::array<Point, 2> steps{random.direction() * 0.01, random.direction() * 0.01};
    for (std::size_t frame = 0; frame < frames && are_apart(pair, places); ++frame) {
      pair.frames.push_back(places);
      for (std::size_t k = 0; k < 2; ++k) {
        places[k] = {turns[k] * places[k].rotation, places[k].position + steps[k]};
      }
    }
  } while (pair.frames.size() < frames);
  return pair;
}

}  // namespace graze::hull_bench
