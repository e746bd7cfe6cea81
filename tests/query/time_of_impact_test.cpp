// SPDX-License-Identifier: MIT
// Times of impact calculated by hand, and failures known from other libraries.
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>

#include "query/user_shapes.hpp"

namespace graze::test::time_of_impact_test {
namespace {

using Point = Vec<3, double>;
using Ball = Sphere<3, double>;
using Trajectory = Motion<3, double>;
using Found = std::optional<Impact<3, double>>;

constexpr double pi = 3.14159265358979323846;
const Trajectory rest;

/// `speed` is the speed of approach at contact: the error, a length, divided by it is the error of t.
void expect_impact(const Found& found, double t, const Point& normal, double speed, const std::string& what) {
  ASSERT_TRUE(found.has_value()) << what;
  EXPECT_EQ(found->status, Status::converged) << what;
  EXPECT_LT(found->error, 1e-9) << what;
  EXPECT_LE(found->t, t + 1e-15) << what;
  EXPECT_NEAR(found->t, t, 1.1 * found->error / speed) << what;
  for (Dim i = 0; i < 3; ++i) EXPECT_NEAR(found->normal[i], normal[i], 1e-8) << what;
}

TEST(TimeOfImpact, FindsWhenATurningRodStrikes) {
  const Segment<3, double> capsule{{0, 0, 0}, {4, 0, 0}};
  const Trajectory quarter_turn{{}, {0, 0, pi / 2}, {}};
  expect_impact(time_of_impact(capsule, quarter_turn, Plane<3, double>{{0, 2, 0}, 4}, rest), 1.0 / 3, {0, 1, 0},
                4 * std::cos(pi / 6) * pi / 2, "its end a plane");
  // A sphere of radius 1 at (2, 2 sqrt 3): the rod is 30 degrees short of its center's direction when it touches.
  expect_impact(time_of_impact(capsule, quarter_turn, Ball{{1, std::sqrt(3.0), 0}, 1}, rest), 1.0 / 3,
                {-0.5, std::sqrt(0.75), 0}, std::sqrt(3.0) * pi / 2, "a ball");
  EXPECT_FALSE(time_of_impact(capsule, quarter_turn, Ball{{0, 5.1, 0}, 1}, rest).has_value());
  EXPECT_FALSE(time_of_impact(capsule, quarter_turn, Ball{{0, -1.1, 0}, 1}, rest).has_value());
}

/// From a pose at the origin rotated about x to one that is also moved and rotated by a third of a turn about the
/// diagonal: the rod's other end describes a circle in the plane x + y + z = 4, carried along the diagonal.
TEST(TimeOfImpact, OfTwoPosesIsThatOfTheMotionBetweenThem) {
  const Point diagonal(1, 1, 1);
  const Mat<3, double> before = rotation_matrix(Point(1, 0, 0), 40);
  const Pose<3, double> start{before, {0, 0, 0}};
  const Pose<3, double> end{rotation_matrix(diagonal, 120) * before, diagonal * 0.5};
  const Segment<3, double> capsule = transformed(Segment<3, double>{{0, 0, 0}, {4, 0, 0}}, start);
  const Trajectory motion = motion_between(start, end);
  for (const double t : {0.25, 0.5, 0.875}) {
    const Point tip =
        transformed(Point(4, 0, 0), Pose<3, double>{rotation_matrix(diagonal, 120 * t), diagonal * (0.5 * t)});
    const Point velocity = diagonal * 0.5 + cross(diagonal * (2 * pi / 3 / std::sqrt(3.0)), tip - diagonal * (0.5 * t));
    const Point normal = velocity / std::sqrt(dot(velocity, velocity));
    const Plane<3, double> wall{normal, dot(normal, tip)};
    expect_impact(time_of_impact(capsule, motion, wall, rest), t, normal, std::sqrt(dot(velocity, velocity)),
                  "its tip");
  }
}

TEST(TimeOfImpact, FindsWhenATurningPlaneStrikes) {
  const Trajectory turning{{}, {0, 0, 1}, {}};
  const double t = std::atan(0.5);
  const auto found = time_of_impact(Point(4, 2, 0), rest, Plane<3, double>{{0, 1, 0}, 0}, turning);
  expect_impact(found, t, {std::sin(t), -std::cos(t), 0}, std::sqrt(20.0), "a point");
  const auto swapped = time_of_impact(HalfSpace<3, double>{{0, 3, 0}, 0}, turning, Point(4, 2, 0), rest);
  expect_impact(swapped, t, {-std::sin(t), std::cos(t), 0}, std::sqrt(20.0), "a half-space");
}

TEST(TimeOfImpact, FindsWhenACornerOfATurningBoxStrikes) {
  // A cube of half extent 1 rotates by 45 degrees while it approaches; its edge is foremost at the end of the rotation.
  const Obb<3, double> box{{0, 0, 0}, {1, 1, 1}};
  const Trajectory trajectory{{4, 0, 0}, {0, 0, pi / 4}, {}};
  const double gap = 4;
  const auto found = time_of_impact(box, trajectory, HalfSpace<3, double>{{-1, 0, 0}, -1 - gap}, rest);
  ASSERT_TRUE(found.has_value());
  const double foremost = 4 * found->t + std::cos(pi / 4 * found->t) + std::sin(pi / 4 * found->t);
  EXPECT_NEAR(foremost, 1 + gap, 1.1 * found->error);
  EXPECT_LE(foremost, 1 + gap);
  EXPECT_NEAR(found->point.x, 1 + gap, 2 * found->error);
}

TEST(TimeOfImpact, OfBothShapesOnlyTheRelativeMotionCounts) {
  const Ball sphere{};
  const Ball target{{12, 0, 0}, 1};
  expect_impact(time_of_impact(sphere, {{8, 0, 0}, {}, {}}, target, {{-12, 0, 0}, {}, {}}), 0.5, {1, 0, 0}, 20, "both");
  EXPECT_FALSE(time_of_impact(sphere, {{8, 0, 0}, {}, {}}, target, {{8, 0, 0}, {}, {}}).has_value());
  // Two boxes on one turntable never meet.
  const Trajectory table{{5, 0, 0}, {0, 0, 20}, {3, 3, 3}};
  const Obb<3, double> box{};
  const Obb<3, double> other{{2.001, 0, 0}, {1, 1, 1}};
  EXPECT_FALSE(time_of_impact(box, table, other, table).has_value());
}

TEST(TimeOfImpact, WithoutTurnsIsThatOfAShapeCast) {
  const Obb<3, double> box{};
  const Capsule<3, double> bar{{5, 1, -3}, {6, 0, 4}, 0.5};
  const auto cast = shape_cast(box, {8, 1, 0.5}, bar);
  const auto found = time_of_impact(box, {{8, 1, 0.5}, {}, {}}, bar, rest);
  ASSERT_TRUE(cast.has_value() && found.has_value());
  EXPECT_EQ(found->t, cast->t);
  EXPECT_EQ(found->normal, cast->normal);
  EXPECT_EQ(found->point, cast->point);
  const auto both = time_of_impact(box, {{9, 1, 0.5}, {}, {}}, bar, {{1, 0, 0}, {}, {}});
  ASSERT_TRUE(both.has_value());
  EXPECT_EQ(both->t, cast->t);
  EXPECT_EQ(both->point, cast->point + Point(cast->t, 0, 0));
}

TEST(TimeOfImpact, ABoxThatSpinsFastIsNotMissed) {
  // A thin blade that rotates ten times while it passes a sphere: testing a few poses in between finds nothing.
  const Obb<3, double> blade{{0, 0, 0}, {3, 0.01, 0.5}};
  const auto found = time_of_impact(blade, {{0, 0, 0}, {0, 0, 20 * pi}, {}}, Ball{{0, 2, 0}, 0.1}, rest);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->status, Status::converged);
  // The side of the blade, 0.01 off its axis, touches the sphere of radius 0.1 at a distance of 2: sin = 0.11 / 2.
  EXPECT_NEAR(found->t, (pi / 2 - std::asin(0.055)) / (20 * pi), 1e-10);
}

/// Other libraries tunnel if a bullet starts beside a wall, or when the steps run out; here the time is before the
/// contact even then, and the status says so.
TEST(TimeOfImpact, SaysWhatIsProvedWhenTheStepsRunOut) {
  const Obb<3, double> top{{0, 0, 0}, {1, 1, 1}};
  const auto found = time_of_impact(top, {{3, 0, 0}, {0, 0, 1e4}, {}}, Ball{{5, 0, 0}, 1}, rest);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->status, Status::best_bound);
  EXPECT_GE(found->t, (4 - std::sqrt(3.0)) / 3 - 1e-9);  // their bounding spheres touch
  // the edges hit as early as possible, because they pass so often
  EXPECT_LE(found->t, (4 - std::sqrt(2.0)) / 3 + 1e-3);
  EXPECT_GT(found->error, 0);
}

TEST(TimeOfImpact, CountsTouchesAtTheStartAndAtTheEnd) {
  const Ball sphere{};
  const auto start = time_of_impact(sphere, {{-1, 0, 0}, {1, 2, 3}, {}}, Ball{{2, 0, 0}, 1}, rest);
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->t, 0);
  EXPECT_EQ(start->normal, Point(1, 0, 0));
  expect_impact(time_of_impact(sphere, {{3, 0, 0}, {}, {}}, Ball{{5, 0, 0}, 1}, rest), 1, {1, 0, 0}, 3, "the end");
  EXPECT_FALSE(time_of_impact(sphere, {{2.999, 0, 0}, {}, {}}, Ball{{5, 0, 0}, 1}, rest).has_value());
  EXPECT_FALSE(time_of_impact(sphere, rest, Ball{{2.001, 0, 0}, 1}, rest).has_value());
}

/// When their bounding spheres touch, they are closer than GJK can resolve at coordinates of a million; and from the
/// start.
TEST(TimeOfImpact, OfSmallThingsFarFromTheOriginHasANormal) {
  const Triangle<3, double> speck{{1e6, 1e6, 1e6}, {1e6, 1e6, 1e6}, {1e6, 1e6, 1e6}};
  const Trajectory flight{{80, 0, 0}, {0, 3, 0}, {1e6, 1e6, 1e6}};
  for (const double way : {60.0, 2e-9}) {
    const Polytope<3, double> other = convex_hull<3, double>(std::vector<Point>{{1e6 + way, 1e6, 1e6}});
    const Found found = time_of_impact(speck, flight, other, rest);
    ASSERT_TRUE(found.has_value()) << way;
    EXPECT_NEAR(found->normal.x, 1, 1e-8) << way;
    EXPECT_NEAR(found->t, way / 80, 1e-8) << way;
    EXPECT_LE(found->t, way / 80) << way;
  }
}

TEST(TimeOfImpact, OfACompoundIsThatOfItsFirstPartToTouch) {
  const Ball far{{5, 0, 0}, 1};
  const Ball near{{0, 4, 0}, 1};
  const Compound<3, double> pair = compound_of<3, double>({near, far});
  const Trajectory quarter_turn{{}, {0, 0, pi / 2}, {}};
  const Ball target{{0, 5, 0}, 0.25};
  EXPECT_EQ(time_of_impact(pair, quarter_turn, target, rest)->t, 0);  // the near one touches before anything moves
  const Ball in_the_way{{3, 3, 0}, 0.5};
  const auto alone = time_of_impact(far, quarter_turn, in_the_way, rest);
  ASSERT_TRUE(alone.has_value());
  EXPECT_EQ(time_of_impact(pair, quarter_turn, in_the_way, rest), alone);
  const auto swapped = time_of_impact(AnyShape<3, double>(in_the_way), rest, AnyShape<3, double>(pair), quarter_turn);
  ASSERT_TRUE(swapped.has_value());
  EXPECT_EQ(swapped->t, alone->t);
  EXPECT_EQ(swapped->normal, -alone->normal);
  EXPECT_FALSE(time_of_impact(Compound<3, double>(), quarter_turn, in_the_way, rest).has_value());
}

TEST(TimeOfImpact, OfARayCountsAllOfIt) {
  // The sphere has an angular radius of 30 degrees, as seen from the ray's origin.
  const Ray<3, double> beam{{0, 0, 0}, {0.001, 0, 0}};
  const Ball sphere{{0, 1000, 0}, 500};
  const Trajectory quarter_turn{{}, {0, 0, pi / 2}, {}};
  const auto found = time_of_impact(beam, quarter_turn, sphere, rest);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->status, Status::converged);
  EXPECT_NEAR(found->t, 2.0 / 3, 1e-9);
  EXPECT_NEAR(found->point.y, 750, 1e-3);
  EXPECT_FALSE(time_of_impact(beam, quarter_turn, Ball{{-1000, 400, 0}, 300}, rest).has_value());
}

TEST(TimeOfImpact, OfTwoWithoutEndIsThatOfACastIfTheyDoNotTurn) {
  const Ray<3, double> down{{0, 0, 8}, {1, 0, 0}};
  const HalfSpace<3, double> floor{{0, 0, 1}, 0};
  expect_impact(time_of_impact(down, {{0, 0, -4}, {}, {}}, floor, {{0, 0, 12}, {}, {}}), 0.5, {0, 0, -1}, 16, "a ray");
  EXPECT_EQ(time_of_impact(down, {{0, 0, -4}, {}, {}}, floor, {{0, 0, 12}, {}, {}})->point.z, 6);
  EXPECT_FALSE(time_of_impact(down, {{0, 0, -4}, {}, {}}, floor, {{0, 0, 3}, {}, {}}).has_value());
  EXPECT_FALSE(time_of_impact(down, rest, floor, rest).has_value());
}

TEST(TimeOfImpact, OfParallelPlanesThatTurnAlikeIsThatOfTheirDistance) {
  const HalfSpace<3, double> left{{1, 0, 0}, 0};
  const HalfSpace<3, double> right{{-1, 0, 0}, -4};
  const Trajectory turning{{}, {0, 0, 1}, {}};
  const auto found = time_of_impact(left, {{8, 0, 0}, {0, 0, 1}, {}}, right, turning);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->status, Status::converged);
  EXPECT_LE(8 * found->t * std::cos(found->t), 4);
  EXPECT_NEAR(8 * found->t * std::cos(found->t), 4, found->error + 1e-12);
  EXPECT_FALSE(time_of_impact(left, turning, right, turning).has_value());
  // As soon as they rotate differently they meet, far away.
  const auto at_once = time_of_impact(left, turning, right, rest);
  ASSERT_TRUE(at_once.has_value());
  EXPECT_EQ(at_once->t, 0);
  EXPECT_EQ(at_once->status, Status::best_bound);
  EXPECT_NEAR(at_once->error, 4, 1e-12);
}

TEST(TimeOfImpact, TakesShapesOfOnesOwnAndFloats) {
  const user::Cylinder<float> can{{0, 0, 0}, 1, 2};
  const Motion<3> fall{{0, 0, -10}, {3.1415927F, 0, 0}, {0, 0, 0}};
  const auto found = time_of_impact(can, fall, HalfSpace<3>{{0, 0, 1}, -5}, {});
  ASSERT_TRUE(found.has_value());
  const double angle = static_cast<double>(found->t) * 3.1415927;
  const double lowest =
      -10.0 * static_cast<double>(found->t) - 2 * std::fabs(std::cos(angle)) - std::fabs(std::sin(angle));
  EXPECT_NEAR(lowest, -5, found->error + 1e-5);
}

TEST(TimeOfImpact, MotionsThatAreNotFiniteTouchNothing) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(time_of_impact(Ball{}, {{infinity, 0, 0}, {}, {}}, Ball{{5, 0, 0}, 1}, rest).has_value());
  EXPECT_FALSE(time_of_impact(Ball{}, rest, Ball{{5, 0, 0}, 1}, {{}, {0, NAN, 0}, {}}).has_value());
}

}  // namespace
}  // namespace graze::test::time_of_impact_test
