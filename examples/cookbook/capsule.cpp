// SPDX-License-Identifier: MIT
// Two capsules touch when their axes are no farther apart than their radii together.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <graze/query/distance_squared.hpp>
#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Capsule = graze::Capsule<3>;
using Point = graze::Vec<3>;

// The closest points of the two lines, each clamped to its segment independently; divides by zero for parallel lines.
float naive_distance(const Capsule& a, const Capsule& b) {
  const Point u = a.b - a.a, v = b.b - b.a, w = a.a - b.a;
  const float uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const float bottom = uu * vv - uv * uv;
  const float s = std::clamp((uv * vw - vv * uw) / bottom, 0.0F, 1.0F);
  const float t = std::clamp((uu * vw - uv * uw) / bottom, 0.0F, 1.0F);
  return length(w + s * u - t * v);
}

void print(const char* what, const Capsule& a, const Capsule& b) {
  const float naive = naive_distance(a, b);
  std::printf("%-17s axes %.4f apart: %s, naively ", what, std::sqrt(graze::distance_squared(axis(a), axis(b))),
              graze::name_of(graze::relation(a, b)).data());
  std::isnan(naive) ? std::printf("not a number\n") : std::printf("%.4f\n", naive);
}

int main(int argc, char** argv) {
  const Capsule log{{-4, 0, 1}, {4, 0, 1}, 1};
  const Capsule across{{0, -3, 2.5F}, {0, 3, 2.5F}, 0.5F};
  const Capsule beside{{-4, 4, 1}, {4, 4, 1}, 1};
  const Capsule pole{{7, -3, 1}, {4.5F, -1.5F, 1}, 0.7F};
  print("log and across:", log, across);
  print("log and beside:", log, beside);
  print("log and pole:", log, pole);
  print("log and itself:", log, log);
  print("two balls:", Capsule{{0, 0, 0}, {0, 0, 0}, 1}, Capsule{{3, 4, 0}, {3, 4, 0}, 3.5F});

  cookbook::Picture<3> picture("capsules");
  picture.add(log, "log");
  picture.add(across, "across");
  picture.add(beside, "beside");
  picture.add(pole, "pole");
  return picture.save(argc, argv);
}
