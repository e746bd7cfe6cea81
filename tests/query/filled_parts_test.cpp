// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/convex_parts.hpp>
#include <graze/query/filled_parts.hpp>

namespace graze::filled_parts_test {
namespace {

using Point = Vec<2, double>;
using Polygon = std::vector<Point>;
using Parts = std::vector<Polygon>;

// Coordinates of polygons are small integers and those of probes small fractions, so the oracle is exact.
double turn(const Point& a, const Point& b, const Point& c) { return cross_2d(b - a, c - a); }

/// The winding number of the polygon around a point that is not on it: crossings of the ray to the right.
int winding_number(const Polygon& polygon, const Point& point) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if (a.y <= point.y && b.y > point.y && turn(a, b, point) > 0) ++winding;
    if (a.y > point.y && b.y <= point.y && turn(a, b, point) < 0) --winding;
  }
  return winding;
}

/// The distance of a point from a segment.
double distance_from(const Point& point, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length = dot(along, along);
  const double t = length == 0 ? 0 : std::clamp(dot(point - a, along) / length, 0.0, 1.0);
  const Point away = point - a - t * along;
  return std::sqrt(dot(away, away));
}

double distance_from_outline(const Polygon& polygon, const Point& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, distance_from(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross_2d(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

/// How far a point is inside a convex part; negative outside.
double depth_in(const Polygon& part, const Point& point) {
  const double away = distance_from_outline(part, point);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (turn(part[i], part[(i + 1) % part.size()], point) < 0) return -away;
  }
  return part.size() > 2 ? away : -away;
}

bool is_convex(const Polygon& part) {
  for (std::size_t i = 0; i < part.size() && part.size() > 2; ++i) {
    if (orientation(part[i], part[(i + 1) % part.size()], part[(i + 2) % part.size()]) <= 0) return false;
  }
  return !part.empty();
}

std::string pasteable(const Polygon& polygon) {
  std::ostringstream out;
  out.precision(17);
  out << "Polygon{";
  for (const Point& point : polygon) out << "{" << point.x << ", " << point.y << "}, ";
  out << "}";
  return out.str();
}

/// The fault of the parts of a polygon within 0..size, or an empty string. Probes are on a lattice finer than the
/// polygon's.
std::string fault(const Polygon& polygon, const Parts& parts, double size, double step) {
  constexpr double rounding = 1e-13;  // for coordinates up to 16, with a reserve
  for (const Polygon& part : parts) {
    if (!is_convex(part)) return "not convex: " + pasteable(part);
  }
  for (double x = -step; x <= size + step; x += step) {
    for (double y = -step; y <= size + step; y += step) {
      const Point probe(x, y);
      std::size_t deep = 0;
      double depth = -std::numeric_limits<double>::infinity();
      for (const Polygon& part : parts) {
        depth = std::max(depth, depth_in(part, probe));
        deep += depth_in(part, probe) > rounding ? 1 : 0;
      }
      const double away = distance_from_outline(polygon, probe);
      const bool inside = away == 0 || winding_number(polygon, probe) != 0;
      std::ostringstream where;
      where << " at " << x << ", " << y;
      if (deep > 1) return "parts overlap" + where.str();
      if (inside && depth < -rounding) return "a gap" + where.str();
      if (!inside && depth > rounding - std::min(away, 2 * rounding)) return "too much" + where.str();
    }
  }
  return "";
}

struct Example {
  const char* name;
  Polygon polygon;
  double twice_area;
  std::size_t most_parts;
};

const std::vector<Example>& examples() {
  static const std::vector<Example> table = {
      {"bow tie", {{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 16, 2},
      {"two squares that touch in a corner", {{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, 16, 2},
      {"a square traversed twice", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, 32, 1},
      {"a square there and back", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {0, 4}, {4, 4}, {4, 0}}, 0, 4},
      {"a hole on a bridge", {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}}, 96, 4},
      {"what looks like a hole but runs the same way",
       {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {6, 2}, {6, 6}, {2, 6}, {2, 2}},
       128,
       1},
      {"a square with an antenna outside", {{0, 0}, {4, 0}, {4, 2}, {8, 2}, {4, 2}, {4, 4}, {0, 4}}, 32, 2},
      {"a square with an antenna inside", {{0, 0}, {4, 0}, {4, 2}, {1, 2}, {4, 2}, {4, 4}, {0, 4}}, 32, 1},
      {"a corner on another edge", {{0, 0}, {8, 0}, {8, 4}, {4, 0}, {0, 4}}, 32, 2},
      {"edges that overlap", {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 40, 4},
      {"an octagram", {{2, 0}, {6, 8}, {2, 8}, {6, 0}, {8, 2}, {0, 6}, {0, 2}, {8, 6}}, 0, 24},
      {"duplicate points", {{0, 0}, {0, 0}, {4, 4}, {4, 4}, {4, 0}, {0, 4}, {0, 4}, {0, 0}}, 16, 2},
  };
  return table;
}

double sum_of_areas(const Parts& parts) {
  double area = 0;
  for (const Polygon& part : parts) area += twice_area(part);
  return area;
}

TEST(FilledParts, FillsByTheNonzeroRule) {
  for (const Example& example : examples()) {
    const std::optional<Parts> parts = filled_parts<double>(example.polygon);
    ASSERT_TRUE(parts) << example.name;
    EXPECT_EQ(fault(example.polygon, *parts, 8, 0.125), "") << example.name;
    if (example.twice_area > 0) {
      EXPECT_NEAR(sum_of_areas(*parts), example.twice_area, 1e-12) << example.name;
    }
    EXPECT_LE(parts->size(), example.most_parts) << example.name;
  }
}

TEST(FilledParts, AcceptsEitherWindingAndAnyFirstCorner) {
  for (const Example& example : examples()) {
    Polygon polygon = example.polygon;
    for (int direction = 0; direction < 2; ++direction) {
      for (std::size_t first = 0; first < polygon.size(); ++first) {
        const std::optional<Parts> parts = filled_parts<double>(polygon);
        ASSERT_TRUE(parts) << example.name;
        EXPECT_EQ(fault(polygon, *parts, 8, 0.25), "") << example.name << ": " << pasteable(polygon);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      }
      std::reverse(polygon.begin(), polygon.end());
    }
  }
}

TEST(FilledParts, FillsTheMiddleOfAPentagram) {
  Polygon star;
  for (int i = 0; i < 5; ++i) {
    const double angle = std::numbers::pi * (0.5 + 0.8 * i);
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  const std::optional<Parts> parts = filled_parts<double>(star);
  ASSERT_TRUE(parts);
  // Ten triangles from the center, each with one corner of the star and one of the pentagon inside.
  const double inner = 1 / (std::numbers::phi * std::numbers::phi);  // how far out the pentagon's corners are
  EXPECT_NEAR(sum_of_areas(*parts), 2 * 5 * inner * std::sin(std::numbers::pi / 5), 1e-14);
  const auto is_in = [&](const Point& point) {
    return std::any_of(parts->begin(), parts->end(), [&](const Polygon& part) { return depth_in(part, point) >= 0; });
  };
  EXPECT_TRUE(is_in({0, 0}));
  EXPECT_FALSE(is_in({0, -0.5})) << "between two points";
}

TEST(FilledParts, GivesASimplePolygonItsConvexParts) {
  const Polygon u = {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  EXPECT_EQ(filled_parts<double>(u), convex_parts<double>(u));
  EXPECT_EQ(filled_parts(std::vector<Vec<2, float>>{{0, 0}, {2, 0}, {0, 2}})->size(), 1U);
}

TEST(FilledParts, ReducesWhatHasNoAreaToSegmentsAndPoints) {
  EXPECT_EQ(filled_parts<double>(Polygon{}), Parts{});
  EXPECT_EQ(filled_parts<double>(Polygon{{1, 2}, {1, 2}}), (Parts{{{1, 2}}}));
  EXPECT_EQ(filled_parts<double>(Polygon{{0, 0}, {4, 0}, {2, 0}}), (Parts{{{0, 0}, {4, 0}}}));
  const std::optional<Parts> angle = filled_parts<double>(Polygon{{0, 0}, {4, 0}, {4, 4}, {4, 0}});
  ASSERT_TRUE(angle);
  EXPECT_EQ(angle->size(), 2U) << "there and back along two lines";
}

TEST(FilledParts, RefusesWhatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(filled_parts<double>(Polygon{{0, 0}, {4, bad}, {4, 0}, {0, 4}}));
  }
}

TEST(FilledParts, ScalesWithThePowersOfTwo) {
  const Polygon tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  const Parts here = *filled_parts<double>(tie);
  for (const int exponent : {-1040, -700, -260, 255, 256, 700, 1021}) {
    Polygon there = tie;
    for (Point& point : there) point = {std::ldexp(point.x, exponent), std::ldexp(point.y, exponent)};
    Parts expected = here;
    for (Polygon& part : expected) {
      for (Point& point : part) point = {std::ldexp(point.x, exponent), std::ldexp(point.y, exponent)};
    }
    EXPECT_EQ(filled_parts<double>(there), expected) << exponent;
  }
}

TEST(FilledParts, GivesUpWhereEdgesMeetTooOften) {
  Polygon star;
  constexpr int corners = 2001;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (corners / 2) * i / corners;
    star.emplace_back(std::cos(angle), std::sin(angle));
  }
  EXPECT_FALSE(filled_parts<double>(star)) << "two million crossings";
}

Polygon random_polygon(int size, std::size_t most) {
  const auto corner = rc::gen::apply([](int x, int y) { return Point(x, y); }, rc::gen::inRange(0, size + 1),
                                     rc::gen::inRange(0, size + 1));
  const auto count = *rc::gen::inRange<std::size_t>(3, most + 1);
  return *rc::gen::container<Polygon>(count, corner);
}

RC_GTEST_PROP(FilledPartsLaws, AgreeWithTheWindingNumberOnACoarseGrid, ()) {
  const Polygon polygon = random_polygon(4, 12);  // corners on corners, edges on edges
  const std::optional<Parts> parts = filled_parts<double>(polygon);
  RC_LOG() << pasteable(polygon);
  RC_ASSERT(parts.has_value());
  RC_ASSERT(fault(polygon, *parts, 4, 0.125) == "");
}

RC_GTEST_PROP(FilledPartsLaws, AgreeWithTheWindingNumberOnAFineGrid, ()) {
  const Polygon polygon = random_polygon(16, 24);
  const std::optional<Parts> parts = filled_parts<double>(polygon);
  RC_LOG() << pasteable(polygon);
  RC_ASSERT(parts.has_value());
  RC_ASSERT(fault(polygon, *parts, 16, 0.5) == "");
}

RC_GTEST_PROP(FilledPartsLaws, HoldForAnyDoubles, ()) {
  // Off any grid, so that all crossings are rounded; the probes are midpoints of random corners.
  const auto number = rc::gen::map(rc::gen::inRange(0, 1'000'000'007), [](int i) { return i * 1.6e-8; });
  const auto corner = rc::gen::apply([](double x, double y) { return Point(x, y); }, number, number);
  const Polygon polygon = *rc::gen::container<Polygon>(*rc::gen::inRange<std::size_t>(4, 40), corner);
  const std::optional<Parts> parts = filled_parts<double>(polygon);
  RC_LOG() << pasteable(polygon);
  RC_ASSERT(parts.has_value());
  RC_ASSERT(fault(polygon, *parts, 16, 0.79) == "");
}

RC_GTEST_PROP(FilledPartsLaws, HoldInFloat, ()) {
  const Polygon polygon = random_polygon(16, 16);
  std::vector<Vec<2, float>> narrow(polygon.begin(), polygon.end());
  const auto parts = filled_parts<float>(narrow);
  RC_ASSERT(parts.has_value());
  double area = 0;
  for (const auto& part : *parts) area += twice_area(Polygon(part.begin(), part.end()));
  const auto wide_parts = filled_parts<double>(polygon);
  RC_ASSERT(std::fabs(area - sum_of_areas(*wide_parts)) < 1e-3);
}

}  // namespace
}  // namespace graze::filled_parts_test
