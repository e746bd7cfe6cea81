// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/outline.hpp>

namespace someone {

/// A user's shape, defined by its support function alone: an ellipse, larger along x.
struct Ellipse {
  double a = 3;
  double b = 1;
};

graze::Vec<2, double> support(const Ellipse& ellipse, const graze::Vec<2, double>& direction) {
  const double x = ellipse.a * direction.x;
  const double y = ellipse.b * direction.y;
  const double size = std::sqrt(x * x + y * y);
  return {ellipse.a * x / size, ellipse.b * y / size};
}

/// A user's shape that calculates in float: a sphere of radius 2 around (1, 2, 3).
struct Ball {};

graze::Vec<3, float> support(const Ball&, const graze::Vec<3, float>& direction) {
  return graze::Vec<3, float>(1, 2, 3) + 2.0F * normalize(direction);
}

}  // namespace someone

namespace graze::outline_test {
namespace {

using Points = std::vector<Vec<2, double>>;

void expect_points(const Points& actual, const Points& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i].x, expected[i].x, 1e-14) << "corner " << i;
    EXPECT_NEAR(actual[i].y, expected[i].y, 1e-14) << "corner " << i;
  }
}

TEST(Outline, of_flat_shapes_is_the_shape) {
  expect_points(outline(Vec<2, double>(3, 4)).core, {{3, 4}});
  expect_points(outline(Segment<2, double>{{5, 1}, {2, 3}}).core, {{2, 3}, {5, 1}});
  expect_points(outline(Segment<2, double>{{5, 1}, {5, 1}}).core, {{5, 1}});
  expect_points(outline(Aabb<2, double>{{0, 1}, {4, 3}}).core, {{0, 1}, {4, 1}, {4, 3}, {0, 3}});
  const Obb<2, double> turned{{10, 0}, {2, 1}, rotation_matrix(90)};
  expect_points(outline(turned).core, {{9, -2}, {11, -2}, {11, 2}, {9, 2}});
  const Triangle<2, double> clockwise{{0, 0}, {1, 3}, {4, 0}};
  expect_points(outline(clockwise).core, {{0, 0}, {4, 0}, {1, 3}});
  const Points kite = {{0, 0}, {2, -1}, {5, 0}, {2, 1}, {2, 0}};
  expect_points(outline(convex_hull<2, double>(kite)).core, {{0, 0}, {2, -1}, {5, 0}, {2, 1}});
}

TEST(Outline, of_round_shapes_is_a_core_and_a_radius) {
  const Outline circle = outline(Sphere<2, float>{{1, 2}, 3});
  expect_points(circle.core, {{1, 2}});
  EXPECT_EQ(circle.radius, 3);
  const Outline capsule = outline(Capsule<2, double>{{4, 0}, {0, 0}, 0.5});
  expect_points(capsule.core, {{0, 0}, {4, 0}});
  EXPECT_EQ(capsule.radius, 0.5);
  const Outline upright = outline(Capsule<3, double>{{1, 2, 0}, {1, 2, 9}, 0.5});  // seen along its axis
  expect_points(upright.core, {{1, 2}});
  EXPECT_EQ(upright.radius, 0.5);
}

TEST(Outline, of_space_is_by_default_the_view_from_above) {
  expect_points(outline(Aabb<3, double>{{0, 1, 5}, {4, 3, 9}}).core, {{0, 1}, {4, 1}, {4, 3}, {0, 3}});
}

TEST(Outline, of_a_cube_seen_isometrically_is_a_hexagon) {
  const double x = 1 / std::sqrt(2.0);
  const double y = 1 / std::sqrt(6.0);
  expect_points(outline(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, isometric_view()).core,
                {{0, 0}, {x, -y}, {2 * x, 0}, {2 * x, 2 * y}, {x, 3 * y}, {0, 2 * y}});
}

TEST(Outline, isometric_view_looks_from_the_front_right_above) {
  const double part = 1 / std::sqrt(3.0);
  const Vec<3, double> viewer = to_viewer(isometric_view());
  EXPECT_NEAR(viewer.x, part, 1e-15);
  EXPECT_NEAR(viewer.y, -part, 1e-15);
  EXPECT_NEAR(viewer.z, part, 1e-15);
}

TEST(Outline, of_the_plane_follows_the_view_when_y_points_down) {
  const View<2> down{{1, 0}, {0, -1}};
  expect_points(outline(Aabb<2, double>{{0, 1}, {4, 3}}, down).core, {{0, -3}, {4, -3}, {4, -1}, {0, -1}});
}

TEST(Outline, is_a_convex_shape_itself) {
  const Outline capsule = outline(Capsule<2, double>{{0, 0}, {4, 0}, 0.5});
  const Aabb<2, double> box = bounds(capsule);
  EXPECT_NEAR(box.min.x, -0.5, 1e-13);
  EXPECT_NEAR(box.max.x, 4.5, 1e-13);
  EXPECT_NEAR(box.max.y, 0.5, 1e-13);
}

TEST(Outline, of_points_is_empty_without_points) { EXPECT_TRUE(outline_of_hull<2>({}, View<2>{}).core.empty()); }

const Aabb<2, double> sheet{{0, 0}, {4, 2}};

TEST(Cut, of_a_ray_is_its_piece_inside_the_box) {
  const std::optional<Segment<2, double>> from_inside = cut(Ray<2, double>{{1, 1}, {10, 0}}, sheet);
  ASSERT_TRUE(from_inside);
  expect_points({from_inside->start, from_inside->end}, {{1, 1}, {4, 1}});
  const std::optional<Segment<2, double>> through = cut(Ray<2, double>{{-1, -1}, {1, 1}}, sheet);
  ASSERT_TRUE(through);
  expect_points({through->start, through->end}, {{0, 0}, {2, 2}});
  const std::optional<Segment<2, double>> along_edge = cut(Ray<2, double>{{3, 2}, {-1, 0}}, sheet);
  ASSERT_TRUE(along_edge);
  expect_points({along_edge->start, along_edge->end}, {{3, 2}, {0, 2}});
}

TEST(Cut, of_a_ray_that_misses_is_nothing) {
  EXPECT_FALSE(cut(Ray<2, double>{{1, 3}, {1, 0}}, sheet));   // parallel, beside
  EXPECT_FALSE(cut(Ray<2, double>{{5, 1}, {1, 0}}, sheet));   // leads away
  EXPECT_FALSE(cut(Ray<2, double>{{-2, 1}, {1, 1}}, sheet));  // passes the corner
  EXPECT_TRUE(outline(Ray<2, double>{{5, 1}, {1, 0}}, View<2>{}, sheet).core.empty());
}

TEST(Cut, of_a_line_is_its_two_ends) {
  expect_points(outline(Plane<2, double>{{0, 2}, 2}, View<2>{}, sheet).core, {{0, 1}, {4, 1}});
  expect_points(outline(Plane<2, double>{{1, 1}, 1}, View<2>{}, sheet).core, {{0, 1}, {1, 0}});
  expect_points(outline(Plane<2, double>{{1, 0}, 4}, View<2>{}, sheet).core, {{4, 0}, {4, 2}});  // an edge
  expect_points(outline(Plane<2, double>{{1, 1}, 6}, View<2>{}, sheet).core, {{4, 2}});          // a corner
  EXPECT_TRUE(cut(Plane<2, double>{{1, 1}, 7}, sheet).empty());
}

TEST(Cut, of_a_plane_through_a_cube_is_a_triangle_or_a_hexagon) {
  const Aabb<3, double> cube{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(cut(Plane<3, double>{{1, 1, 1}, 0.5}, cube).size(), 3U);
  const std::vector<Vec<3, double>> hexagon = cut(Plane<3, double>{{1, 1, 1}, 1.5}, cube);
  ASSERT_EQ(hexagon.size(), 6U);
  for (const Vec<3, double>& corner : hexagon) {
    EXPECT_NEAR(corner.x + corner.y + corner.z, 1.5, 1e-14);
    EXPECT_NEAR(length_squared(corner - Vec<3, double>(0.5)), 0.5, 1e-14);  // a corner is the middle of an edge
  }
}

TEST(Cut, of_a_half_space_is_what_lies_behind_its_plane) {
  expect_points(outline(HalfSpace<2, double>{{0, 1}, 1}, View<2>{}, sheet).core, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
  expect_points(outline(HalfSpace<2, double>{{1, 1}, 1}, View<2>{}, sheet).core, {{0, 0}, {1, 0}, {0, 1}});
  expect_points(outline(HalfSpace<2, double>{{1, 0}, 9}, View<2>{}, sheet).core, {{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  EXPECT_TRUE(cut(HalfSpace<2, double>{{0, 1}, -1}, sheet).empty());
}

TEST(Cut, knows_planes_farther_away_than_doubles_reach) {
  EXPECT_TRUE(cut(Plane<2, double>{{0, 1e-300}, 1e300}, sheet).empty());
  EXPECT_EQ(cut(HalfSpace<2, double>{{0, 1e-300}, 1e300}, sheet).size(), 4U);
  EXPECT_TRUE(cut(HalfSpace<2, double>{{0, 1e-300}, -1e300}, sheet).empty());
}

TEST(Outline, of_a_users_shape_goes_through_its_support_points) {
  const someone::Ellipse ellipse;
  const Outline polygon = outline(ellipse);
  EXPECT_EQ(polygon.core.size(), static_cast<std::size_t>(outline_samples));
  EXPECT_EQ(polygon.radius, 0);
  for (std::size_t i = 0; i < polygon.core.size(); ++i) {
    const Vec<2, double>& corner = polygon.core[i];
    EXPECT_NEAR(corner.x * corner.x / 9 + corner.y * corner.y, 1, 1e-14);
    const Vec<2, double>& next = polygon.core[(i + 1) % polygon.core.size()];
    const double step = std::sqrt(length_squared(next - corner));
    const Vec<2, double> outward(next.y - corner.y, corner.x - next.x);
    const double missing = dot(support(ellipse, outward) - corner, outward) / step;
    EXPECT_LE(missing, std::tan(std::numbers::pi / outline_samples) * step / 2);
    EXPECT_GT(missing, 0);
  }
}

TEST(Outline, of_a_users_shape_in_float_is_sampled_in_the_plane_of_the_view) {
  const Vec<2, double> center = seen(Vec<3, double>(1, 2, 3), isometric_view());
  for (const Vec<2, double>& corner : outline(someone::Ball{}, isometric_view()).core) {
    EXPECT_NEAR(std::sqrt(length_squared(corner - center)), 2, 1e-6);
  }
}

double any_number(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) / 1'000'000.0;
}

template <Dim N>
Vec<N, double> any_vector() {
  Vec<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = any_number(-10, 10);
  return result;
}

Mat<2, double> any_rotation(std::integral_constant<Dim, 2>) { return rotation_matrix(any_number(0, 360)); }

Mat<3, double> any_rotation(std::integral_constant<Dim, 3>) {
  return rotation_matrix(any_vector<3>() + Vec<3, double>(0, 0, 11), any_number(0, 360));
}

/// The outline extends exactly as far as the shape in every direction of the picture.
template <Dim N, class S>
void check_reach(const S& shape, const View<N>& view, const std::string& name) {
  const Outline image = outline(shape, view);
  for (int i = 0; i < 16; ++i) {
    const double angle = any_number(0, 7);
    const Vec<2, double> flat(std::cos(angle), std::sin(angle));
    const Vec<N, double> direction = view.right * flat.x + view.up * flat.y;
    const double expected = dot(support(shape, direction), direction);
    const double actual = dot(support(image, flat), flat);
    std::ostringstream text;
    text.precision(17);
    text << name << ", angle " << angle << ": the outline reaches " << actual << ", the shape " << expected;
    if (std::fabs(actual - expected) > 1e-13 * 40) RC_FAIL(text.str());
  }
}

template <Dim N>
void check_all_shapes() {
  const Mat<N, double> frame = any_rotation(std::integral_constant<Dim, N>{});
  const View<N> view{frame[0], frame[1]};
  const Vec<N, double> a = any_vector<N>();
  const Vec<N, double> b = any_vector<N>();
  const Vec<N, double> c = any_vector<N>();
  const double radius = any_number(0, 5);
  check_reach(a, view, "point");
  check_reach(Segment<N, double>{a, b}, view, "segment");
  check_reach(Sphere<N, double>{a, radius}, view, "sphere");
  check_reach(Aabb<N, double>::from_corners(a, b), view, "aabb");
  check_reach(Obb<N, double>{a, abs(b), any_rotation(std::integral_constant<Dim, N>{})}, view, "obb");
  check_reach(Triangle<N, double>{a, b, c}, view, "triangle");
  check_reach(Capsule<N, double>{a, b, radius}, view, "capsule");
  std::vector<Vec<N, double>> points;
  for (int i = 0; i < 9; ++i) points.push_back(any_vector<N>());
  check_reach(convex_hull<N, double>(points), view, "polytope");
}

RC_GTEST_PROP(Outline, reaches_as_far_as_the_shape_in_every_direction_of_the_plane, ()) { check_all_shapes<2>(); }

RC_GTEST_PROP(Outline, reaches_as_far_as_the_shape_in_every_direction_of_a_view_of_space, ()) { check_all_shapes<3>(); }

}  // namespace
}  // namespace graze::outline_test
