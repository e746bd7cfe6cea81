// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/convex_parts.hpp>

namespace graze::convex_parts_test {
namespace {

using Point = Vec<2, double>;
using Polygon = std::vector<Point>;
using Parts = std::vector<Polygon>;

// All coordinates below are small integers (or quarters), so areas and cross products in double are exact.
double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross_2d(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

double turn(const Point& a, const Point& b, const Point& c) { return cross_2d(b - a, c - b); }

bool strictly_convex(const Polygon& polygon) {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (turn(polygon[i], polygon[(i + 1) % count], polygon[(i + 2) % count]) <= 0) return false;
  }
  return count > 2;
}

/// True if an edge of `a` has all of `b` on its outer side: for disjoint convex polygons, one of the two has such an
/// edge.
bool edge_separates(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point start = a[i];
    const Point end = a[(i + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](const Point& point) { return turn(start, end, point) <= 0; })) return true;
  }
  return false;
}

std::size_t hollow_corners(const Polygon& polygon) {
  const double direction = twice_area(polygon) > 0 ? 1 : -1;
  std::size_t hollows = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& after = polygon[(i + 2) % polygon.size()];
    if (direction * turn(polygon[i], polygon[(i + 1) % polygon.size()], after) < 0) ++hollows;
  }
  return hollows;
}

std::string pasteable(const Polygon& polygon) {
  std::ostringstream out;
  out << "Polygon{";
  for (const Point& point : polygon) out << "{" << point.x << ", " << point.y << "}, ";
  out << "}";
  return out.str();
}

/// The fault of a partition, or an empty string. Equal area and no overlap among parts whose corners are corners of the
/// polygon exclude gaps.
std::string fault(const Polygon& polygon, const Parts& parts) {
  double area = 0;
  for (const Polygon& part : parts) {
    if (!strictly_convex(part)) return "not convex: " + pasteable(part);
    for (const Point& corner : part) {
      if (std::find(polygon.begin(), polygon.end(), corner) == polygon.end()) return "invented: " + pasteable(part);
    }
    area += twice_area(part);
  }
  if (area != std::fabs(twice_area(polygon))) return "the areas differ";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!edge_separates(parts[i], parts[j]) && !edge_separates(parts[j], parts[i])) return "parts overlap";
    }
  }
  if (parts.size() > 2 * hollow_corners(polygon) + 1) return "more parts than Hertel and Mehlhorn allow";
  return "";
}

struct Example {
  const char* name;
  Polygon polygon;
  std::size_t parts;
};

const std::vector<Example>& examples() {
  static const std::vector<Example> table = {
      {"triangle", {{0, 0}, {4, 0}, {0, 4}}, 1},
      {"square", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1},
      {"square with midpoints of edges", {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}, 1},
      {"L", {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 2},
      {"arrow head", {{0, 0}, {4, 2}, {0, 4}, {1, 2}}, 2},
      {"U", {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 3},
      {"plus", {{2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 4}, {4, 4}, {4, 6}, {2, 6}, {2, 4}, {0, 4}, {0, 2}, {2, 2}}, 3},
  };
  return table;
}

TEST(ConvexParts, FindsTheFewestPartsOfSimpleFigures) {
  for (const Example& example : examples()) {
    const std::optional<Parts> parts = convex_parts<double>(example.polygon);
    ASSERT_TRUE(parts) << example.name;
    EXPECT_EQ(fault(example.polygon, *parts), "") << example.name;
    EXPECT_EQ(parts->size(), example.parts) << example.name;
  }
}

TEST(ConvexParts, AcceptsEitherWindingAndAnyFirstCorner) {
  for (const Example& example : examples()) {
    Polygon polygon = example.polygon;
    for (int winding = 0; winding < 2; ++winding) {
      for (std::size_t first = 0; first < polygon.size(); ++first) {
        const std::optional<Parts> parts = convex_parts<double>(polygon);
        ASSERT_TRUE(parts) << pasteable(polygon);
        EXPECT_EQ(fault(polygon, *parts), "") << pasteable(polygon);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      }
      std::reverse(polygon.begin(), polygon.end());
    }
  }
}

TEST(ConvexParts, GivesAConvexPolygonBackCounterClockwiseWithoutStraightCorners) {
  const std::optional<Parts> parts = convex_parts<double>(Polygon{{0, 4}, {4, 4}, {4, 2}, {4, 0}, {0, 0}});
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 1u);
  Polygon part = parts->front();
  std::rotate(part.begin(), std::find(part.begin(), part.end(), Point(0, 0)), part.end());
  EXPECT_EQ(part, (Polygon{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

TEST(ConvexParts, TakesAnyRowOfCorners) {
  const std::array<Vec<2, float>, 4> arrow{{{0, 0}, {2, 1}, {0, 2}, {1, 1}}};
  const auto parts = convex_parts(arrow);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->size(), 2U);
  EXPECT_EQ(convex_parts(std::vector<Vec<2, float>>(arrow.begin(), arrow.end())), parts);
}

TEST(ConvexParts, IgnoresCornersThatRepeat) {
  const Polygon l{{0, 0}, {0, 0}, {4, 0}, {4, 2}, {4, 2}, {4, 2}, {2, 2}, {2, 4}, {0, 4}, {0, 0}};
  const std::optional<Parts> parts = convex_parts<double>(l);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->size(), 2u);
  EXPECT_EQ(fault(l, *parts), "");
}

TEST(ConvexParts, ReducesAFlatPolygonToItsEnds) {
  EXPECT_EQ(convex_parts<double>(Polygon{{1, 1}, {3, 3}, {2, 2}, {0, 0}}), (Parts{{{0, 0}, {3, 3}}}));
  EXPECT_EQ(convex_parts<double>(Polygon{{1, 2}, {5, 2}}), (Parts{{{1, 2}, {5, 2}}}));
  EXPECT_EQ(convex_parts<double>(Polygon{{7, 8}, {7, 8}, {7, 8}}), (Parts{{{7, 8}}}));
  EXPECT_EQ(convex_parts<double>(Polygon{{7, 8}}), (Parts{{{7, 8}}}));
  EXPECT_EQ(convex_parts<double>(Polygon{}), Parts{});
}

TEST(ConvexParts, RefusesAnOutlineThatCrossesOrTouchesItself) {
  const std::vector<std::pair<const char*, Polygon>> refused = {
      {"bow tie", {{0, 0}, {4, 4}, {4, 0}, {0, 4}}},
      {"pentagram", {{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}},
      {"two squares joined at a corner", {{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}},
      {"a corner on an edge", {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}},
      {"a spike outward", {{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}}},
      {"a spike inward", {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 1}, {2, 4}, {0, 4}}},
      {"traversed twice", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}},
      {"a hole joined by a bridge", {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}}},
  };
  for (const auto& [name, polygon] : refused) EXPECT_FALSE(convex_parts<double>(polygon)) << name;
}

TEST(ConvexParts, RefusesCoordinatesThatAreNotFiniteOrOverflow) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(convex_parts<double>(Polygon{{0, 0}, {infinity, 0}, {0, 1}}));
  EXPECT_FALSE(convex_parts<double>(Polygon{{0, 0}, {1, 0}, {0, nan}}));
  const double huge = std::numeric_limits<double>::max();
  const std::optional<Parts> parts =
      convex_parts<double>(Polygon{{-huge, -huge}, {huge, -huge}, {0, 0}, {huge, huge}, {-huge, huge}});
  EXPECT_TRUE(!parts || !parts->empty());  // products overflow: any answer is accepted
}

TEST(ConvexParts, DecidesByTheLastBit) {
  // The midpoint of the upper edge is one ulp inside, exactly on, and one ulp outside the line between its neighbours.
  const double inside = std::nextafter(1.0, 0.0);
  const double outside = std::nextafter(1.0, 2.0);
  EXPECT_EQ(convex_parts<double>(Polygon{{0, 0}, {3, 0}, {3, 1}, {1, inside}, {0, 1}})->size(), 2u);
  EXPECT_EQ(convex_parts<double>(Polygon{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {0, 1}})->size(), 1u);
  const std::optional<Parts> bulging = convex_parts<double>(Polygon{{0, 0}, {3, 0}, {3, 1}, {1, outside}, {0, 1}});
  ASSERT_EQ(bulging->size(), 1u);
  EXPECT_EQ(bulging->front().size(), 5u);
  // A corner may come within one ulp of another edge, but not reach it.
  EXPECT_TRUE(convex_parts<double>(Polygon{{0, 0}, {2, 0}, {2, 2}, {1, 0x1p-1074}, {0, 2}}));
  EXPECT_FALSE(convex_parts<double>(Polygon{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
}

TEST(ConvexParts, WorksInFloat) {
  const std::vector<Vec<2, float>> arrow{{0.1F, 0}, {4, 2}, {0.1F, 4}, {1, 2}};
  const auto parts = convex_parts<float>(arrow);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->size(), 2u);
}

/// A comb: `teeth` long teeth side by side. Every tooth makes two reflex corners and extends above the bases of all
/// others.
Polygon comb(int teeth) {
  Polygon polygon{{0, 0}, {4.0 * teeth, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = 4.0 * i;
    polygon.insert(polygon.end(), {{x + 3, 1}, {x + 2, 1000}, {x + 1, 1000}, {x, 1}});
  }
  return polygon;
}

TEST(ConvexParts, CutsACombIntoItsTeethAndItsBack) {
  const Polygon polygon = comb(50);
  const std::optional<Parts> parts = convex_parts<double>(polygon);
  ASSERT_TRUE(parts);
  EXPECT_EQ(fault(polygon, *parts), "");
}

TEST(ConvexParts, FinishesOnThousandsOfHollowCorners) {
  // A spiral of 4,000 corners, half of them reflex: one arm, out and back at a distance.
  Polygon polygon;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.05 * i;
    polygon.emplace_back((10 + angle) * std::cos(angle), (10 + angle) * std::sin(angle));
  }
  for (int i = 1999; i >= 0; --i) {
    const double angle = 0.05 * i;
    polygon.emplace_back((12 + angle) * std::cos(angle), (12 + angle) * std::sin(angle));
  }
  const std::optional<Parts> parts = convex_parts<double>(polygon);
  ASSERT_TRUE(parts);
  EXPECT_LE(parts->size(), 2 * hollow_corners(polygon) + 1);
  double area = 0;
  for (const Polygon& part : *parts) area += twice_area(part);
  EXPECT_NEAR(area, std::fabs(twice_area(polygon)), 1e-9 * area);
}

// Brute-force oracle of simplicity: corners are distinct and on no other edge, and edges do not cross.
bool on_edge(const Point& a, const Point& b, const Point& point) {
  return turn(a, b, point) == 0 && dot(point - a, point - b) <= 0;
}

bool properly_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool brute_force_simple(const Polygon& polygon) {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % count];
    for (std::size_t j = 0; j < count; ++j) {
      if (j != i && j != (i + 1) % count && on_edge(a, b, polygon[j])) return false;
      if (properly_cross(a, b, polygon[j], polygon[(j + 1) % count])) return false;
    }
  }
  return true;
}

RC_GTEST_PROP(ConvexParts, RefusesExactlyWhatIsNotSimple, ()) {
  // Distinct grid points in random order: about a third of these lists are simple.
  const auto count = *rc::gen::inRange<std::size_t>(3, 9);
  const auto cell =
      rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 36));  // the whole grid from the first case on
  const auto cells = *rc::gen::unique<std::vector<int>>(count, cell).as("cells of a 6 x 6 grid");
  Polygon polygon;
  for (const int place : cells) polygon.emplace_back(place % 6, place / 6);
  RC_PRE(!detail::ends_of_2d<double>(polygon));
  RC_LOG() << pasteable(polygon);
  const std::optional<Parts> parts = convex_parts<double>(polygon);
  RC_TAG(parts ? "simple" : "not simple");
  RC_ASSERT(parts.has_value() == brute_force_simple(polygon));
  if (parts) RC_ASSERT(fault(polygon, *parts) == "");
}

RC_GTEST_PROP(ConvexParts, CoversStarShapedPolygons, ()) {
  // Around the origin by angle, so always simple; radii jump, so many corners are reflex.
  const auto offsets = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-50, 50), rc::gen::inRange(-50, 50)));
  const auto angle = [](const Point& point) { return std::atan2(point.y, point.x); };
  Polygon polygon{{60, 1}, {-1, 60}, {-60, -1}, {1, -60}};
  for (const auto& [x, y] : offsets) {
    const Point point(x, y);
    const bool taken = std::any_of(polygon.begin(), polygon.end(), [&](const Point& other) {
      return cross_2d(point, other) == 0 && dot(point, other) >= 0;
    });
    if (!taken) polygon.push_back(point);
  }
  std::sort(polygon.begin(), polygon.end(), [&](const Point& a, const Point& b) { return angle(a) < angle(b); });
  RC_LOG() << pasteable(polygon);
  const std::optional<Parts> parts = convex_parts<double>(polygon);
  RC_ASSERT(parts.has_value());
  RC_ASSERT(fault(polygon, *parts) == "");
}

}  // namespace
}  // namespace graze::convex_parts_test
