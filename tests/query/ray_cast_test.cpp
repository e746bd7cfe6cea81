// SPDX-License-Identifier: MIT
// Hits calculated by hand, watertight meshes, a user-defined shape, and invalid numbers.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/ray_cast.hpp>

#include "exact/point.hpp"
#include "query/numbers_of.hpp"
#include "query/ray_casts.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::ray_cast_test {

/// A sphere defined by its support function alone.
struct Blob {
  Vec<3, double> center;
  double radius;
};

Vec<3, double> support(const Blob& blob, const Vec<3, double>& direction) {
  return blob.center + direction * (blob.radius / std::sqrt(dot(direction, direction)));
}

namespace {

constexpr RayOptions at_exit{RaySide::exit};
constexpr double infinity = std::numeric_limits<double>::infinity();

using Point = Vec<3, double>;
using Shape = AnyShape<3, double>;

struct Expected {
  double t;
  Point point;
  Point normal;
};

void expect_hit(const std::optional<RayHit<3, double>>& hit, const Expected& expected, const std::string& what) {
  ASSERT_TRUE(hit.has_value()) << what;
  const double off = 1e-15 + 2 * hit->error;  // no ray here hits a surface at less than 30 degrees
  EXPECT_NEAR(hit->t, expected.t, off) << what;
  for (Dim i = 0; i < 3; ++i) {
    EXPECT_NEAR(hit->point[i], expected.point[i], off) << what;
    EXPECT_NEAR(hit->normal[i], expected.normal[i], off) << what;
  }
  EXPECT_EQ(hit->status, Status::converged) << what;
  EXPECT_LT(hit->error, 1e-12) << what;
}

TEST(RayCast, FindsWhereEveryShapeIsEnteredAndLeft) {
  struct Row {
    Shape shape;
    Expected entry;
    std::optional<Expected> exit;
  };
  const Point left(-1, 0, 0);
  const Point right(1, 0, 0);
  const std::vector<Point> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const double third = std::sqrt(1.0 / 3);
  // The ray runs along y = z = 1/4 from x = -5, two units of x per unit of t.
  const auto at = [](double x) { return Point(x, 0.25, 0.25); };
  const std::vector<Row> rows{
      {Point(2, 0.25, 0.25), {3.5, at(2), left}, Expected{3.5, at(2), right}},
      {Segment<3, double>{at(1), at(3)}, {3, at(1), left}, Expected{4, at(3), right}},
      {Segment<3, double>{{1, 0, 0.25}, {1, 1, 0.25}}, {3, at(1), left}, Expected{3, at(1), right}},
      {Ray<3, double>{at(1), {-1, 0, 0}}, {0, at(-5), left}, Expected{3, at(1), right}},
      {Ray<3, double>{at(1), {1, 0, 0}}, {3, at(1), left}, {}},
      {Sphere<3, double>{{1, 0.25, 0.25}, 2}, {2, at(-1), left}, Expected{4, at(3), right}},
      {Aabb<3, double>{{-1, 0, 0}, {2, 1, 1}}, {2, at(-1), left}, Expected{3.5, at(2), right}},
      {Aabb<3, double>{{1, 0, 0}, {1, 1, 1}}, {3, at(1), left}, Expected{3, at(1), right}},
      {Obb<3, double>{{1, 0, 0}, {1, 2, 3}, Mat<3, double>({0, 1, 0}, {0, 0, 1}, {1, 0, 0})},
       {1.5, at(-2), left},
       Expected{4.5, at(4), right}},
      {Plane<3, double>{{-2, 0, 0}, 2}, {2, at(-1), left}, Expected{2, at(-1), right}},
      {HalfSpace<3, double>{{-2, 0, 0}, 2}, {2, at(-1), left}, {}},
      {HalfSpace<3, double>{{2, 0, 0}, 2}, {0, at(-5), left}, Expected{3, at(1), right}},
      {Triangle<3, double>{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {3, at(1), left}, Expected{3, at(1), right}},
      {Triangle<3, double>{{1, 0, 0.25}, {1, 0.5, 0.25}, {3, 0.25, 0.25}}, {3, at(1), left}, Expected{4, at(3), right}},
      {Capsule<3, double>{{0, 0.25, 0.25}, {1, 0.25, 0.25}, 1}, {2, at(-1), left}, Expected{3.5, at(2), right}},
      {Capsule<3, double>{{0, -3, 0.25}, {0, 3, 0.25}, 1}, {2, at(-1), left}, Expected{3, at(1), right}},
      {convex_hull<3, double>(octahedron),
       {2.25, at(-0.5), Point(-third, third, third)},
       Expected{2.75, at(0.5), Point(third, third, third)}},
      {compound_of<3, double>({Sphere<3, double>{at(3), 1}, Sphere<3, double>{at(0), 1}}),
       {2, at(-1), left},
       Expected{4.5, at(4), right}},
  };
  for (const Row& row : rows) {
    const std::string name(type_name(row.shape));
    const Ray<3, double> ray{{-5, 0.25, 0.25}, {2, 0, 0}};
    expect_hit(hit_of<3, double>(row.shape, ray, infinity), row.entry, name);
    const auto exit = hit_of<3, double>(row.shape, ray, infinity, at_exit);
    if (row.exit) {
      expect_hit(exit, *row.exit, name + ", exit");
    } else {
      EXPECT_FALSE(exit.has_value()) << name;
    }
    EXPECT_EQ((hit_of<3, double>(row.shape, ray, row.entry.t * 0.99).has_value()), row.entry.t == 0) << name;
    EXPECT_TRUE((hit_of<3, double>(row.shape, ray, row.entry.t).has_value())) << name;
    const Segment<3, double> segment{ray.origin, row.entry.t > 0 ? row.entry.point : at(0)};
    const auto on_segment = hit_of<3, double>(row.shape, segment);
    ASSERT_TRUE(on_segment.has_value()) << name;
    EXPECT_NEAR(on_segment->t, row.entry.t > 0 ? 1 : 0, 1e-15 + on_segment->error) << name;
  }
}

TEST(RayCast, StartsInsideAtZeroWithTheNormalAgainstTheRay) {
  const Ray<2> ray{{0.5F, 0}, {3, 4}};
  for (const AnyShape<2>& shape : {AnyShape<2>(Sphere<2>{}), AnyShape<2>(Aabb<2>{}), AnyShape<2>(Capsule<2>{})}) {
    const auto hit = hit_of<2, float>(shape, ray, 0.0F);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 0.0F);
    EXPECT_EQ(hit->point, ray.origin);
    EXPECT_EQ(hit->normal, (Vec<2>{-0.6F, -0.8F}));
  }
}

TEST(RayCast, RunsAlongTheSidesOfABox) {
  const Aabb<2> box{{-3, -2}, {3, 2}};
  struct Row {
    Ray<2> ray;
    float t;
  };
  for (const Row& row : {Row{{{-6, 2}, {1, 0}}, 3}, Row{{{-6, -2}, {1, -0.0F}}, 3}, Row{{{-3, 5}, {0, -1}}, 3},
                         Row{{{3, 5}, {-0.0F, -1}}, 3}, Row{{{3, 2}, {1, 1}}, 0}, Row{{{5, 4}, {-1, -1}}, 2}}) {
    const auto hit = ray_cast(box, row.ray);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, row.t);
  }
  EXPECT_FALSE(ray_cast(box, Ray<2>{{-6, std::nextafter(2.0F, 3.0F)}, {1, 0}}).has_value());
  EXPECT_FALSE(ray_cast(box, Ray<2>{{3, 2.5F}, {1, 0}}).has_value());
}

TEST(RayCast, TakesDirectionsOfAnySize) {
  const Aabb<3, double> box{{1, -1, -1}, {2, 1, 1}};
  const Sphere<3, double> sphere{{2, 0, 0}, 1};
  for (const double size : {1e30, 1e-30, 1e300, 1e-300, 1.0}) {
    const Ray<3, double> ray{{-3, 0, 0}, {size, 0, 0}};
    for (const Shape& shape : {Shape(box), Shape(sphere)}) {
      const auto hit = hit_of<3, double>(shape, ray, infinity);
      ASSERT_TRUE(hit.has_value()) << size;
      EXPECT_DOUBLE_EQ(hit->t, 4 / size);
      EXPECT_EQ(hit->point, Point(1, 0, 0));
      EXPECT_EQ(hit->normal, Point(-1, 0, 0));
    }
  }
  // The smallest double above zero: t overflows, and the point is right.
  const auto far = ray_cast(box, Ray<3, double>{{-3, 0, 0}, {std::numeric_limits<double>::denorm_min(), 0, 0}});
  ASSERT_TRUE(far.has_value());
  EXPECT_EQ(far->t, infinity);
  EXPECT_EQ(far->point, Point(1, 0, 0));
}

/// Users may give the largest number for an infinite ray: its rounding must not report shapes behind the ray.
TEST(RayCast, GoesPastWhatLiesBehindItHoweverLateItEnds) {
  const Ray<3, double> ray{{-10, -10, -10}, {-9.875, -10, 5.875}};
  const Ray<3, float> narrow{{-10, -10, -10}, {-9.875F, -10, 5.875F}};
  for (const double t_max : {10.0, 1e14, 1e16, 1e38, 1e120}) {
    EXPECT_FALSE(ray_cast(Plane<3, double>{{-10, -8.625, 7.75}, -9.25}, ray, t_max)) << t_max;
    EXPECT_FALSE(ray_cast(HalfSpace<3, double>{{-10, -8.625, 7.75}, -9.25}, ray, t_max)) << t_max;
    EXPECT_TRUE(ray_cast(Plane<3, double>{{-10, -8.625, 7.75}, 500}, ray, t_max)) << t_max;
  }
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_FALSE(ray_cast(Plane<3, float>{{-10, -8.625F, 7.75F}, -9.25F}, narrow, most));
  EXPECT_TRUE(ray_cast(Plane<3, float>{{-10, -8.625F, 7.75F}, 500}, narrow, most));
  EXPECT_FALSE(
      ray_cast(Ray<2, float>{{-10, 8.5F}, {8.5F, 8.5F}}, Ray<2, float>{{-13.5F, 8.5F}, {-most, 6.375F}}, 6.375F));
}

TEST(RayCast, FindsASmallBallFarAway) {
  // The half chord at 0.6 from the center is 0.8; b^2 - 4 a c in double would be pure rounding.
  const Sphere<3, double> sphere{{1e9, 0, 0}, 1};
  const auto hit = ray_cast(sphere, Ray<3, double>{{0, 0.6, 0}, {1, 0, 0}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->t, 1e9 - 0.8, 1e-6);
  EXPECT_NEAR(hit->normal.y, 0.6, 1e-7);
  EXPECT_FALSE(ray_cast(sphere, Ray<3, double>{{0, 1.00001, 0}, {1, 0, 0}}).has_value());
}

TEST(RayCast, FindsAUsersShapeAndSaysHowWell) {
  const Blob blob{{5, 0, 0}, 2};
  const auto hit = ray_cast(blob, Ray<3, double>{{0, 1.2, 0}, {2, 0, 0}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->status, Status::converged);
  EXPECT_LT(hit->error, 1e-12);
  EXPECT_NEAR(hit->t, 1.7, 1e-12);  // 5 - sqrt(4 - 1.44) = 3.4
  EXPECT_NEAR(hit->normal.x, -0.8, 1e-6);
  EXPECT_NEAR(hit->normal.y, 0.6, 1e-6);
  EXPECT_FALSE(ray_cast(blob, Ray<3, double>{{0, 2.001, 0}, {1, 0, 0}}).has_value());
  const auto exit = ray_cast(blob, Ray<3, double>{{0, 1.2, 0}, {2, 0, 0}}, infinity, at_exit);
  ASSERT_TRUE(exit.has_value());
  EXPECT_NEAR(exit->t, 3.3, 1e-12);
}

/// Rays that miss by less than a verdict can tell, at angles at which Newton's method overshoots: the hit is at the
/// nearest approach, and the error is at least the gap.
TEST(RayCast, HitsWhatItOnlyNearlyTouchesWhereItIsNearest) {
  using Point2 = Vec<2, double>;
  struct Row {
    AnyShape<2, double> shape;
    Ray<2, double> ray;
    Point2 nearest;
  };
  const double gap = 7e-15;
  const std::vector<Row> rows = {
      // From right above one end of a flat capsule to where its side falls away, nearly along the ray.
      {Capsule<2, double>{{3, -2}, {4, 2}, 0}, {{4, 2 + gap}, {-1, -4.440892098500626e-16}}, {4, 2}},
      {Triangle<2, double>{{0, 3}, {-4, 2}, {3, -2}}, {{-8, 11 + gap}, {4, -4}}, {0, 3}},
      {convex_hull<2, double>(std::vector<Point2>{{0, 3}, {-4, 2}, {3, -2}}), {{-8, 3 + gap}, {2, 0}}, {0, 3}},
      {Sphere<2, double>{{0, 0}, 3}, {{-8, 3 + gap}, {2, 0}}, {0, 3}},
      {Segment<2, double>{{0, 3}, {1, -2}}, {{-8, 3 + gap}, {2, 0}}, {0, 3}},
      {Point2(0, 3), {{-8, 3 + gap}, {2, 0}}, {0, 3}},
  };
  for (const Row& row : rows) {
    const auto hit = hit_of<2, double>(row.shape, row.ray, infinity);
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(length(hit->point - row.nearest), 1e-6);
    EXPECT_LT(hit->error, 1e-12);
    EXPECT_LE(length(row.ray.origin + row.ray.direction * hit->t - hit->point), hit->error + 1e-15);
    EXPECT_LE((exact_signed_distance<2, double>(row.shape, hit->point)), hit->error);
  }
}

// ---- Closed meshes: rays from inside never escape through corners and edges

/// The faces of a convex body, each counter-clockwise as seen from outside.
using Faces = std::vector<Triangle<3, float>>;

Faces icosahedron(const Vec<3>& center, float size) {
  const float g = 1.618034F;
  const std::array<Vec<3>, 12> corners{{{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}}};
  constexpr std::array<std::array<std::size_t, 3>, 20> faces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  Faces result;
  for (const auto& [a, b, c] : faces) {
    result.push_back({center + corners[a] * size, center + corners[b] * size, center + corners[c] * size});
  }
  return result;
}

std::size_t count_hits(const Faces& faces, const Ray<3>& ray) {
  std::size_t count = 0;
  for (const Triangle<3>& face : faces) count += ray_cast(face, ray).has_value() ? 1 : 0;
  return count;
}

TEST(RayCast, NoRaySlipsThroughTheCornersAndEdgesOfAClosedMesh) {
  std::mt19937 engine(20261122);
  std::uniform_real_distribution<float> number(-0.5F, 0.5F);
  for (const float far : {0.0F, 1000.0F, 1e6F}) {
    const Vec<3> center(far, -far, far / 3);
    const Faces faces = icosahedron(center, 1.7F);
    for (int i = 0; i < 200; ++i) {
      const Vec<3> origin = center + Vec<3>(number(engine), number(engine), number(engine));
      for (const Triangle<3>& face : faces) {
        const float share = number(engine) + 0.5F;
        EXPECT_GE(count_hits(faces, {origin, face.a - origin}), 1U) << far;
        EXPECT_GE(count_hits(faces, {origin, face.a + (face.b - face.a) * share - origin}), 1U) << far;
        EXPECT_GE(count_hits(faces, {origin, {number(engine), number(engine), 1}}), 1U) << far;
      }
    }
  }
}

TEST(RayCast, ARayExactlyThroughAnEdgeOrACornerHitsAllItsTriangles) {
  const Triangle<3> left{{-1, 0, 2}, {0, -1, 2}, {0, 1, 2}};
  const Triangle<3> right{{1, 0, 2}, {0, 1, 2}, {0, -1, 2}};
  for (const Vec<3>& direction : {Vec<3>(0, 0, 1), Vec<3>(0, 0.25F, 1), Vec<3>(0, 0.5F, 1)}) {
    const Ray<3> ray{{0, 0, 0}, direction};
    ASSERT_TRUE(ray_cast(left, ray).has_value());
    ASSERT_TRUE(ray_cast(right, ray).has_value());
    EXPECT_EQ(ray_cast(left, ray)->t, 2.0F);
    EXPECT_EQ(ray_cast(right, ray)->t, 2.0F);
  }
}

// ---- Invalid input

TEST(RayCast, IsOverBeforeItBegins) {
  EXPECT_FALSE(ray_cast(Sphere<3>{}, Ray<3>{{0, 0, 0}, {1, 0, 0}}, -1.0F).has_value());
  EXPECT_FALSE(
      ray_cast(Sphere<3>{}, Ray<3>{{0, 0, 0}, {1, 0, 0}}, std::numeric_limits<float>::quiet_NaN()).has_value());
  const auto point = ray_cast(Sphere<3>{}, Segment<3>{{1, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(point.has_value());
  EXPECT_EQ(point->t, 0.0F);
  EXPECT_EQ(point->normal, Vec<3>(0, 0, 0));
  EXPECT_FALSE(ray_cast(Sphere<3>{}, Segment<3>{{1, 1, 0}, {1, 1, 0}}).has_value());
}

TEST(RayCast, NanAndExtremesGetAnAnswer) {
  using Limits = std::numeric_limits<double>;
  const std::array values = {Limits::quiet_NaN(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::max(),
                             Limits::denorm_min(),
                             0.0,
                             -1.0,
                             1e30};
  const detail::Path<3> path{{-5, 0, 0}, {1, 0, 0}, infinity};
  const Ray<3, double> ray{path.origin, path.direction};
  for (std::size_t type = 0; type < row_types; ++type) {
    auto shape = row_shape<3, double>(type, 1.0);
    for_each_number<3, double>(shape, [&](double& x) {
      const double before = x;
      for (const double value : values) {
        x = value;
        for (const RaySide side : {RaySide::entry, RaySide::exit}) {
          const auto found = detail::find_hit(shape, path, side, detail::AskAboutRay<3, double>{ray});
          const bool is_hit = found.verdict == detail::RayVerdict::hits;
          EXPECT_FALSE(is_hit && (std::isnan(value) || found.hit.t < 0)) << shape_type_names[type] << " with " << value;
        }
      }
      x = before;
    });
  }
}

/// A path that ends at a plane, or slightly before it, where `relation` says that it touches: how close it is depends
/// on the size of the numbers at its end, not at its origin.
TEST(RayCast, ClaimsAtTheEndOfThePathNoMoreThanItKnowsThere) {
  struct Row {
    HalfSpace<2, double> solid;
    Ray<2, double> ray;
  };
  const std::array<Row, 2> rows = {{
      {{{-4, -3}, -50}, {{-0.7, 0.03}, {3, -4 + 0x1p-10}}},
      {{{1, 2}, 1e-3}, {{0.3, 0.1}, {2, -1 - 0x1p-16}}},
  }};
  std::size_t hits = 0;
  for (const Row& row : rows) {
    for (int i = -2000; i <= 2000; ++i) {
      const double climb = dot(row.solid.normal, row.ray.direction);
      const double end = (row.solid.offset - dot(row.solid.normal, row.ray.origin)) / climb;
      const double t_max = end * (1 + i * 0x1p-50);
      const auto hit = ray_cast(row.solid, row.ray, t_max);
      if (!hit || hit->t == 0) continue;
      ++hits;
      const double off = std::fabs(exact_signed_distance<2, double>(row.solid, hit->point));
      EXPECT_LE(off, hit->error + 0x1p-52 * max_abs(hit->point)) << t_max;
    }
  }
  EXPECT_GT(hits, 2000U);
}

/// The same at its start: slightly off the plane, closer than rounding can tell there, and moving away.
TEST(RayCast, ClaimsAtTheStartOfThePathNoMoreThanItKnowsThere) {
  const Plane<2, double> plane{{0.0004, 0}, 0.0004};
  for (const double side : {-1.0, 1.0}) {
    for (const double t_max : {0.75, 1e9, infinity}) {
      const auto hit = ray_cast(plane, Ray<2, double>{{1 + side * 0x1p-52, 0}, {side, 0}}, t_max);
      ASSERT_TRUE(hit.has_value());
      EXPECT_EQ(hit->t, 0);
      EXPECT_GE(hit->error, 0x1p-52);
    }
    // At zero a tiny gap is exact, and the path's far end does not change that.
    const Plane<2, double> through_zero{{0.0004, 0}, 0};
    for (const double t_max : {0.75, 1e9, infinity}) {
      EXPECT_FALSE(ray_cast(through_zero, Ray<2, double>{{side * 0x1p-53, 0}, {side, 0}}, t_max));
    }
  }
  const auto inside = ray_cast(HalfSpace<2, double>{{1, 0}, 5}, Ray<2, double>{{0, 0}, {-1, 0}}, 0.75);
  ASSERT_TRUE(inside.has_value());
  EXPECT_LT(inside->error, 1e-13);  // the depth at the start is no error
}

}  // namespace
}  // namespace graze::test::ray_cast_test
