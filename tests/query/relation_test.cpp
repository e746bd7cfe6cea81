// SPDX-License-Identifier: MIT
// relation(a, b) by hand: every pair of types apart, touching, overlapping, contained, identical and degenerate, in
// both orders, in four spaces. The oracle must agree as well.
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::relation_test {
namespace {

template <class SpaceType>
class RelationTable : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;

  static void expect(const Any& a, const Any& b, Relation expected) {
    const std::string names = to_source<N, T>(a) + ", " + to_source<N, T>(b);
    EXPECT_EQ(name_of((relation_of<N, T>(a, b))), name_of(expected)) << names;
    EXPECT_EQ(name_of((relation_of<N, T>(b, a))), name_of(expected)) << "swapped: " << names;
    EXPECT_EQ(name_of((true_verdict<N, T>(a, b, expected).relation)), name_of(expected)) << "oracle: " << names;
  }

  static Any shifted(const Any& shape, double x) { return moved<N, T>(shape, unit_axis<N, T>(0) * static_cast<T>(x)); }

  static Any row(std::size_t place, double side, double size = 1) {
    return row_shape<N, T>(place, static_cast<T>(side), static_cast<T>(size));
  }

  static Any nothing() { return Compound<N, T>{}; }

  /// The point at x = -1, as every type that can degenerate to one.
  static std::vector<Any> points() {
    using V = Vec<N, T>;
    const V p = unit_axis<N, T>(0) * T(-1);
    return {p,
            Segment<N, T>{p, p},
            Sphere<N, T>{p, T(0)},
            Aabb<N, T>{p, p},
            Obb<N, T>{p, V(T(0)), Mat<N, T>(T(1))},
            Triangle<N, T>{p, p, p},
            Capsule<N, T>{p, p, T(0)},
            convex_hull<N, T>(std::vector<V>{p, p}),
            compound_of<N, T>({p, Sphere<N, T>{p, T(0)}})};
  }

  /// The segment from x = -1 to x = 1, as every type that can degenerate to one.
  static std::vector<Any> segments() {
    using V = Vec<N, T>;
    const V x = unit_axis<N, T>(0);
    return {Segment<N, T>{-x, x},
            Aabb<N, T>{-x, x},
            Obb<N, T>{V(T(0)), x, Mat<N, T>(T(1))},
            Triangle<N, T>{-x, x, V(T(0))},
            Triangle<N, T>{-x, -x, x},
            Capsule<N, T>{-x, x, T(0)},
            convex_hull<N, T>(std::vector<V>{x, V(T(0)), -x})};
  }

  static std::size_t type(std::string_view name) {
    std::size_t place = 0;
    while (shape_type_names[place] != name) ++place;
    return place;
  }

  /// Whether a type has an interior.
  static bool is_solid(std::size_t place) {
    const std::string_view name = shape_type_names[place];
    if (name == "triangle" || name == "mesh") return N == 2;
    return name != "point" && name != "segment" && name != "ray" && name != "plane";
  }

  /// The verdict on two shapes of the row that overlap by half a unit along the x axis.
  static Relation when_pushed(std::size_t a, std::size_t b) {
    if (is_solid(a) || is_solid(b)) return Relation::overlapping;
    const std::string_view first = shape_type_names[a];
    const std::string_view second = shape_type_names[b];
    if (first == "plane" || second == "plane") {
      // The plane perpendicular to the axis intersects what lies along it; a point or another plane is now beside it.
      const std::string_view other = first == "plane" ? second : first;
      return other == "plane" || other == "point" ? Relation::apart : Relation::overlapping;
    }
    if (first == "point" && second == "point") return Relation::apart;
    return Relation::touching;  // all of it on one line, or in one plane of 3D
  }
};

TYPED_TEST_SUITE(RelationTable, test::Spaces);

TYPED_TEST(RelationTable, SideBySideShapesAreApartTouchingOrOverlapping) {
  using Fixture = TestFixture;
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      // The left one ends at x = 1, the right one begins at x = -1.
      const auto left = Fixture::row(a, 1);
      const auto right = Fixture::row(b, -1);
      Fixture::expect(left, Fixture::shifted(right, 2.5), Relation::apart);
      Fixture::expect(left, Fixture::shifted(right, 2), Relation::touching);
      Fixture::expect(left, Fixture::shifted(right, 1.5), Fixture::when_pushed(a, b));
      Fixture::expect(left, Fixture::shifted(right, 2 + 0x1p-20), Relation::apart);
    }
  }
}

TYPED_TEST(RelationTable, AShapeInsideASolidOverlapsIt) {
  using Fixture = TestFixture;
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const bool is_bounded = shape_type_names[b] != "ray" && shape_type_names[b] != "plane" &&
                              shape_type_names[b] != "half_space" && shape_type_names[b] != "compound";
      if (!Fixture::is_solid(a) || !is_bounded) continue;
      Fixture::expect(Fixture::row(a, 1), Fixture::row(b, -1, 0.25), Relation::overlapping);
    }
  }
}

TYPED_TEST(RelationTable, IdenticalShapesOverlapIfTheyHaveAnInside) {
  using Fixture = TestFixture;
  for (std::size_t a = 0; a < row_types; ++a) {
    const auto shape = Fixture::row(a, 1);
    Fixture::expect(shape, shape, Fixture::is_solid(a) ? Relation::overlapping : Relation::touching);
  }
}

TYPED_TEST(RelationTable, ShapesShrunkToAPointAreThatPoint) {
  using Fixture = TestFixture;
  const auto points = Fixture::points();
  for (const auto& point : points) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const auto left = Fixture::row(b, 1);
      Fixture::expect(left, Fixture::shifted(point, 2.25), Relation::apart);
      Fixture::expect(left, Fixture::shifted(point, 2), Relation::touching);
      Fixture::expect(left, Fixture::shifted(point, 1.75), Fixture::when_pushed(b, Fixture::type("point")));
    }
    for (const auto& other : points) {
      Fixture::expect(point, other, Relation::touching);
      Fixture::expect(point, Fixture::shifted(other, 0x1p-20), Relation::apart);
    }
  }
}

TYPED_TEST(RelationTable, ShapesShrunkToASegmentAreThatSegment) {
  using Fixture = TestFixture;
  const auto segments = Fixture::segments();
  for (const auto& segment : segments) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const auto left = Fixture::row(b, 1);
      Fixture::expect(left, Fixture::shifted(segment, 2.25), Relation::apart);
      Fixture::expect(left, Fixture::shifted(segment, 2), Relation::touching);
      Fixture::expect(left, Fixture::shifted(segment, 1.75), Fixture::when_pushed(b, Fixture::type("segment")));
    }
    for (const auto& other : segments) {
      Fixture::expect(segment, Fixture::shifted(other, 0.5), Relation::touching);
      Fixture::expect(segment, Fixture::shifted(other, 2), Relation::touching);
      Fixture::expect(segment, Fixture::shifted(other, 2.25), Relation::apart);
    }
  }
}

TYPED_TEST(RelationTable, ACompoundWithoutPartsIsApartFromEverything) {
  using Fixture = TestFixture;
  for (std::size_t a = 0; a < row_types; ++a) {
    Fixture::expect(Fixture::row(a, 1), Fixture::nothing(), Relation::apart);
  }
}

// ---- 2D, by hand: numbers that float represents exactly.

template <class T>
using Row2 = std::pair<std::pair<AnyShape<2, T>, AnyShape<2, T>>, Relation>;

template <class T>
std::vector<Row2<T>> rows_of_the_plane() {
  using V = Vec<2, T>;
  const Polytope<2, T> pentagon = convex_hull<2, T>(std::vector<V>{{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}});
  const auto apart = Relation::apart;
  const auto touching = Relation::touching;
  const auto overlapping = Relation::overlapping;
  return {
      // 3-4-5 triangles: the distance is exactly 5.
      {{Sphere<2, T>{{0, 0}, 2}, Sphere<2, T>{{3, 4}, 3}}, touching},
      {{Sphere<2, T>{{0, 0}, 2}, Sphere<2, T>{{3, 4}, T(2.875)}}, apart},
      {{Sphere<2, T>{{0, 0}, 2}, Sphere<2, T>{{3, 4}, T(3.125)}}, overlapping},
      {{Sphere<2, T>{{4, 5}, 5}, Aabb<2, T>{{-2, -1}, {1, 1}}}, touching},
      {{Sphere<2, T>{{4, 5}, T(4.75)}, Aabb<2, T>{{-2, -1}, {1, 1}}}, apart},
      {{Capsule<2, T>{{3, 4}, {9, 9}, 5}, V{0, 0}}, touching},
      {{Capsule<2, T>{{3, 4}, {9, 9}, T(4.5)}, V{0, 0}}, apart},
      // Crossing, T-shaped, collinear.
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{0, 2}, {2, 0}}}, overlapping},
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{1, 1}, {2, 0}}}, touching},
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{T(1.25), 1}, {2, 0}}}, apart},
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{1, 1}, {3, 3}}}, touching},
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{3, 3}, {4, 4}}}, apart},
      {{Segment<2, T>{{0, 0}, {2, 2}}, Segment<2, T>{{0, 1}, {2, 3}}}, apart},
      // Rays: crossing, behind, collinear head-on, away, in the same direction, side by side.
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{4, 0}, {-1, 1}}}, overlapping},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{4, 0}, {1, -1}}}, apart},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{4, 4}, {1, -1}}}, touching},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{3, 3}, {-2, -2}}}, touching},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{-3, -3}, {-2, -2}}}, apart},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{-3, -3}, {2, 2}}}, touching},
      {{Ray<2, T>{{0, 0}, {1, 1}}, Ray<2, T>{{-3, -2}, {2, 2}}}, apart},
      {{Ray<2, T>{{0, 5}, {3, -4}}, Segment<2, T>{{3, 1}, {9, 9}}}, touching},
      {{Ray<2, T>{{0, 5}, {3, -4}}, Segment<2, T>{{2, 1}, {9, 9}}}, overlapping},
      {{Ray<2, T>{{0, 5}, {-3, 4}}, Segment<2, T>{{2, 1}, {9, 9}}}, apart},
      // Sloped lines and half-planes.
      {{Plane<2, T>{{3, 4}, 25}, Sphere<2, T>{{0, 0}, 5}}, touching},
      {{Plane<2, T>{{3, 4}, 25}, Sphere<2, T>{{0, 0}, T(4.75)}}, apart},
      {{HalfSpace<2, T>{{-3, -4}, -25}, Capsule<2, T>{{0, 0}, {-4, 3}, 5}}, touching},
      {{HalfSpace<2, T>{{-3, -4}, -25}, Capsule<2, T>{{0, 0}, {-4, 3}, T(5.5)}}, overlapping},
      {{HalfSpace<2, T>{{1, 2}, 3}, HalfSpace<2, T>{{-2, -4}, -6}}, touching},
      {{HalfSpace<2, T>{{1, 2}, 3}, HalfSpace<2, T>{{-2, -4}, -7}}, apart},
      {{HalfSpace<2, T>{{1, 2}, 3}, HalfSpace<2, T>{{-2, -4}, -5}}, overlapping},
      {{HalfSpace<2, T>{{1, 2}, 3}, Plane<2, T>{{2, 4}, 7}}, apart},
      {{Plane<2, T>{{1, 2}, 3}, Plane<2, T>{{-1, -2}, -3}}, touching},
      {{Plane<2, T>{{1, 2}, 3}, Plane<2, T>{{2, 1}, 3}}, overlapping},
      // Corners on edges.
      {{Triangle<2, T>{{0, 0}, {4, 0}, {0, 4}}, Triangle<2, T>{{2, 2}, {4, 2}, {2, 4}}}, touching},
      {{Triangle<2, T>{{0, 0}, {4, 0}, {0, 4}}, Triangle<2, T>{{2, 2}, {4, 4}, {1, 4}}}, touching},
      {{Triangle<2, T>{{0, 0}, {4, 0}, {0, 4}}, Triangle<2, T>{{T(1.75), 2}, {4, 4}, {1, 4}}}, overlapping},
      {{pentagon, V{T(4.5), T(1.5)}}, touching},
      {{pentagon, V{T(4.5), T(1.75)}}, overlapping},
      {{pentagon, V{T(4.5), T(1.25)}}, apart},
      {{pentagon, Aabb<2, T>{{4, 4}, {9, 9}}}, apart},
      {{pentagon, Obb<2, T>{{7, 3}, {1, 2}, Mat<2, T>(0, 1, -1, 0)}}, touching},
      {{pentagon, Segment<2, T>{{-2, 1}, {0, 3}}}, overlapping},
      {{pentagon, Segment<2, T>{{-2, 2}, {-1, 3}}}, touching},
  };
}

template <class T>
std::vector<std::pair<std::pair<AnyShape<3, T>, AnyShape<3, T>>, Relation>> rows_of_space() {
  using V = Vec<3, T>;
  const Polytope<3, T> pyramid =
      convex_hull<3, T>(std::vector<V>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 2}});
  const Triangle<3, T> floor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto apart = Relation::apart;
  const auto touching = Relation::touching;
  const auto overlapping = Relation::overlapping;
  return {
      // (2, 3, 6) is 7 long, (1, 2, 2) is 3 long.
      {{Sphere<3, T>{{0, 0, 0}, 3}, Sphere<3, T>{{2, 3, 6}, 4}}, touching},
      {{Sphere<3, T>{{0, 0, 0}, 3}, Sphere<3, T>{{2, 3, 6}, T(3.875)}}, apart},
      {{Sphere<3, T>{{2, 3, 3}, 3}, Aabb<3, T>{{-1, -1, -1}, {1, 1, 1}}}, touching},
      {{Sphere<3, T>{{2, 3, 3}, T(2.75)}, Aabb<3, T>{{-1, -1, -1}, {1, 1, 1}}}, apart},
      {{Capsule<3, T>{{2, 3, 3}, {5, 5, 5}, T(3.25)}, Aabb<3, T>{{-1, -1, -1}, {1, 1, 1}}}, overlapping},
      // Skew segments one above the other, and their capsules.
      {{Segment<3, T>{{-1, 0, 0}, {1, 0, 0}}, Segment<3, T>{{0, -1, 1}, {0, 1, 1}}}, apart},
      {{Segment<3, T>{{-1, 0, 0}, {1, 0, 0}}, Segment<3, T>{{0, -1, 0}, {0, 1, 0}}}, touching},
      {{Capsule<3, T>{{-1, 0, 0}, {1, 0, 0}, T(0.5)}, Capsule<3, T>{{0, -1, 1}, {0, 1, 1}, T(0.5)}}, touching},
      {{Capsule<3, T>{{-1, 0, 0}, {1, 0, 0}, T(0.5)}, Capsule<3, T>{{0, -1, 1}, {0, 1, 1}, T(0.25)}}, apart},
      {{Capsule<3, T>{{-1, 0, 0}, {1, 0, 0}, T(0.5)}, Segment<3, T>{{0, -1, T(0.25)}, {0, 1, T(0.25)}}}, overlapping},
      // Through a triangle, at its edge, above it, in its plane.
      {{floor, Segment<3, T>{{1, 1, -1}, {1, 1, 1}}}, overlapping},
      {{floor, Segment<3, T>{{2, 2, -1}, {2, 2, 1}}}, touching},
      {{floor, Segment<3, T>{{3, 2, -1}, {3, 2, 1}}}, apart},
      {{floor, Segment<3, T>{{1, 1, 0}, {5, 5, 0}}}, touching},
      {{floor, Segment<3, T>{{1, 1, T(0.5)}, {2, 1, 1}}}, apart},
      {{floor, Triangle<3, T>{{1, 1, -1}, {1, 1, 1}, {5, 5, 0}}}, overlapping},
      {{floor, Triangle<3, T>{{1, 1, 0}, {1, 2, 0}, {2, 1, 0}}}, touching},
      {{floor, Triangle<3, T>{{0, 0, 0}, {0, 4, 0}, {0, 0, 4}}}, touching},
      {{floor, Sphere<3, T>{{1, 1, 2}, 2}}, touching},
      {{floor, Sphere<3, T>{{1, 1, 2}, T(1.875)}}, apart},
      {{floor, Capsule<3, T>{{1, 1, -1}, {1, 1, 1}, 0}}, overlapping},
      {{floor, Aabb<3, T>{{1, 1, 0}, {2, 2, 2}}}, touching},
      {{floor, Aabb<3, T>{{1, 1, -1}, {2, 2, 2}}}, overlapping},
      // Rays.
      {{Ray<3, T>{{0, 0, 5}, {0, 0, -1}}, floor}, touching},
      {{Ray<3, T>{{1, 1, 5}, {0, 0, -1}}, floor}, overlapping},
      {{Ray<3, T>{{1, 1, 5}, {0, 0, 1}}, floor}, apart},
      {{Ray<3, T>{{0, 0, 0}, {1, 0, 0}}, Ray<3, T>{{3, -2, 0}, {0, 1, 0}}}, touching},
      {{Ray<3, T>{{0, 0, 0}, {1, 0, 0}}, Ray<3, T>{{3, -2, 1}, {0, 1, 0}}}, apart},
      {{Ray<3, T>{{0, 0, 0}, {1, 0, 0}}, Ray<3, T>{{-3, -2, 0}, {0, 1, 0}}}, apart},
      {{Ray<3, T>{{-9, 0, 1}, {3, 0, 0}}, pyramid}, overlapping},
      {{Ray<3, T>{{-9, 0, 2}, {3, 0, 0}}, pyramid}, touching},
      {{Ray<3, T>{{-9, 0, T(2.5)}, {3, 0, 0}}, pyramid}, apart},
      {{Ray<3, T>{{-9, 0, 1}, {-3, 0, 0}}, pyramid}, apart},
      // Sloped planes and half-spaces.
      {{Plane<3, T>{{2, 3, 6}, 49}, Sphere<3, T>{{0, 0, 0}, 7}}, touching},
      {{Plane<3, T>{{1, 2, 2}, 5}, Aabb<3, T>{{-1, -1, -1}, {1, 1, 1}}}, touching},
      {{Plane<3, T>{{1, 2, 2}, 6}, Aabb<3, T>{{-1, -1, -1}, {1, 1, 1}}}, apart},
      {{HalfSpace<3, T>{{-2, 0, -1}, -2}, pyramid}, touching},
      {{HalfSpace<3, T>{{-2, 0, -1}, -3}, pyramid}, apart},
      {{HalfSpace<3, T>{{-2, 0, -1}, -1}, pyramid}, overlapping},
      // Edge on edge, face on face, corner on face.
      {{pyramid, Obb<3, T>{{2, 0, 0}, {1, 1, 1}, Mat<3, T>(T(1))}}, touching},
      {{pyramid, Aabb<3, T>{{-1, -1, -2}, {1, 1, 0}}}, touching},
      {{pyramid, Aabb<3, T>{{-1, -1, 2}, {1, 1, 3}}}, touching},
      {{pyramid, V{T(0.5), 0, 1}}, touching},
      {{pyramid, V{T(0.25), 0, 1}}, overlapping},
  };
}

TYPED_TEST(RelationTable, ShapesComputedByHandAreAsComputed) {
  using Number = typename TypeParam::scalar;
  if constexpr (TypeParam::dimension == 2) {
    for (const auto& [pair, expected] : rows_of_the_plane<Number>()) this->expect(pair.first, pair.second, expected);
  } else {
    for (const auto& [pair, expected] : rows_of_space<Number>()) this->expect(pair.first, pair.second, expected);
  }
}

}  // namespace
}  // namespace graze::test::relation_test
