// SPDX-License-Identifier: MIT
// Any closed polygon as convex parts, also one that crosses itself, and the outline of shapes that overlap.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <vector>

#include <graze/graze.hpp>
#include <graze/query/filled_parts.hpp>
#include <graze/query/union_outline.hpp>

using Point = graze::Vec<2, double>;
using Polygon = std::vector<Point>;

double area_of(const Polygon& polygon) {
  double twice_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice_area += graze::cross_2d(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice_area / 2;
}

int main() {
  // A five-pointed star, drawn without lifting the pen.
  Polygon star;
  for (int i = 0; i < 5; ++i) {
    const Point turn = graze::cosine_sine_of_degrees(90 + 144 * i);
    star.push_back(turn * 10.0);
  }
  const std::optional<std::vector<Polygon>> parts = graze::filled_parts(star);
  if (!parts) return 1;  // a coordinate is not finite, or edges cross far too often
  double area = 0;
  std::vector<graze::AnyShape<2, double>> shapes;
  for (const Polygon& part : *parts) {
    area += area_of(part);
    shapes.emplace_back(graze::convex_hull(part));
  }
  std::printf("the star has an area of %.3f in %zu convex parts\n", area, parts->size());

  // A shape for any query: its middle is filled, the notch between two points is not.
  const auto solid = graze::compound_of<2, double>(shapes);
  const bool has_middle = graze::contains(solid, Point(0, 0));
  const bool has_notch = graze::contains(solid, Point(0, -5));

  // For pictures: one line around all parts, without the edges that they share.
  const std::vector<Polygon> outline = graze::union_outline(*parts);
  std::printf("its outline has %zu corners\n", outline.front().size());

  const double sine = std::sin(std::numbers::pi / 5);
  const double inner = 10 * std::cos(2 * std::numbers::pi / 5) / std::cos(std::numbers::pi / 5);
  const double expected = 5 * 10 * inner * sine;
  return std::fabs(area - expected) < 1e-9 && std::fabs(area_of(outline.front()) - expected) < 1e-6 && has_middle &&
                 !has_notch && outline.size() == 1
             ? 0
             : 1;
}
