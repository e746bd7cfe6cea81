// SPDX-License-Identifier: MIT
// convex_hull of any points, against the properties of a hull: its corners are points, without duplicates, every point
// is inside up to rounding, and the hull of its corners has the same corners.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/polytope.hpp>

#include "catalogue.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using Point = Vec<N, T>;
  test::fuzz::Input input(data, size);
  std::vector<Point> points = test::fuzz::points<N, T>(input, 64);
  const Point way = input.vec<N, T>();
  for (std::size_t count = input.below(64); count > 0; --count) {
    points.push_back(points[count % points.size()] + way * static_cast<T>(input.below(5)));
  }
  const bool is_sound = std::all_of(points.begin(), points.end(), [](const Point& point) { return is_finite(point); });
  Polytope<N, T> hull;
  try {
    hull = convex_hull<N, T>(points);
    test::fuzz::require(is_sound, [](std::ostream& out) { out << "points that are not finite were accepted"; });
  } catch (const std::invalid_argument&) {
    test::fuzz::require(!is_sound, [](std::ostream& out) { out << "finite points were rejected"; });
    return 0;
  }
  const auto say = [&](std::ostream& out) {
    out << test::to_source(hull) << " of";
    for (const Point& point : points) out << " " << test::initializer(point);
  };
  const auto corners = hull.vertices();
  double largest = 0;
  for (const Point& point : points) largest = std::max(largest, static_cast<double>(max_abs(point)));
  for (const Point& corner : corners) {
    test::fuzz::require(std::find(points.begin(), points.end(), corner) != points.end(), say);
    test::fuzz::require(std::count(corners.begin(), corners.end(), corner) == 1, say);
  }
  if (largest < static_cast<double>(std::numeric_limits<T>::max()) / 8) {
    const double slack = 1e-14 * largest;
    for (const Point& point : points) {
      test::fuzz::require(static_cast<double>(signed_distance(hull, point)) <= slack, [&](std::ostream& out) {
        out << test::initializer(point) << " is " << signed_distance(hull, point) << " out of ";
        say(out);
      });
    }
  }
  const Polytope<N, T> again = convex_hull<N, T>(std::vector<Point>(corners.begin(), corners.end()));
  test::fuzz::require(again.vertices().size() == corners.size(), say);
  return 0;
}
