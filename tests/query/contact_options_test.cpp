// SPDX-License-Identifier: MIT
// Contacts and manifolds of shapes that are near: by hand, as a gap closes, and as laws on random pairs.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contact_options.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/transformed.hpp>

#include "catalogue.hpp"
#include "query/cast_cases.hpp"

namespace graze::test::contact_options_test {
namespace {

using Box = Aabb<3, double>;

constexpr ContactOptions near{0.1};

/// A floor from -4 to 4 whose top is at y = 0.
Box floor_box() { return {{-4, -1, -4}, {4, 0, 4}}; }

template <class Found>
double least_depth(const Found& manifold) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : manifold.contacts()) least = std::min(least, static_cast<double>(point.depth));
  return least;
}

// ---- Boxes over a floor

TEST(ContactOptions, ABoxThatHoversHasTheFourPointsOnWhichItLands) {
  const Box hovering{{0, 0.01, 0}, {2, 3, 1}};
  EXPECT_EQ(manifold(hovering, floor_box()).size, 0U);
  EXPECT_EQ(manifold(hovering, floor_box(), ContactOptions{0.005}).size, 0U);
  const auto found = manifold(hovering, floor_box(), near);
  ASSERT_EQ(found.size, 4U);
  EXPECT_EQ(found.normal, (Vec<3, double>(0, -1, 0)));
  for (const auto& point : found.contacts()) {
    EXPECT_NEAR(point.depth, -0.01, 1e-15);
    EXPECT_NEAR(point.point_a.y, 0.01, 1e-15);
    EXPECT_NEAR(point.point_b.y, 0, 1e-15);
    EXPECT_NEAR(point.point.y, 0.005, 1e-15);
  }
  const auto single = contact(hovering, floor_box(), near);
  ASSERT_TRUE(single.has_value());
  EXPECT_EQ(single->depth, -0.01);
  EXPECT_EQ(single->normal, (Vec<3, double>(0, -1, 0)));
}

/// The ids of the points, in order.
template <class Found>
bool have_same_ids(const Found& one, const Found& other) {
  return std::equal(one.contacts().begin(), one.contacts().end(), other.contacts().begin(), other.contacts().end(),
                    [](const auto& a, const auto& b) { return a.id == b.id; });
}

template <class A, class B>
void expect_no_jump_through_zero(const A& above, const B& below, std::size_t points, const Vec<3, double>& up) {
  std::optional<Manifold<3, double>> last;
  double gap = 0.05;
  for (const double next : {0.05, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0, -1e-15, -1e-12, -1e-9, -1e-6, -1e-3, -0.05}) {
    const Pose<3, double> pose{Mat<3, double>(1.0), up * next};
    const auto found = manifold(transformed(above, pose), below, near);
    EXPECT_EQ(found.size, points) << next;
    EXPECT_LE(length(found.normal + up), 1e-5) << next;
    for (const auto& point : found.contacts()) EXPECT_NEAR(point.depth, -next, 1e-13) << next;
    if (last) {
      EXPECT_TRUE(have_same_ids(*last, found)) << next;
      for (std::size_t i = 0; i < std::min(found.size, last->size); ++i) {
        EXPECT_LE(length(found.points[i].point - last->points[i].point), std::fabs(gap - next) + 1e-12) << next;
      }
    }
    gap = next;
    last = found;
  }
}

TEST(ContactOptions, NothingJumpsAsAFaceLandsOnAnother) {
  const Vec<3, double> up(0, 1, 0);
  const HalfSpace<3, double> ground{{0, 1, 0}, 0};
  const Box box{{0, 0, 0}, {2, 3, 1}};
  expect_no_jump_through_zero(box, floor_box(), 4, up);
  expect_no_jump_through_zero(box, ground, 4, up);
  expect_no_jump_through_zero(Capsule<3, double>{{-1, 0.5, 0}, {1, 0.5, 0}, 0.5}, floor_box(), 2, up);
  expect_no_jump_through_zero(Sphere<3, double>{{0.25, 0.5, 0}, 0.5}, floor_box(), 1, up);
  for (int i = 1; i < 20; ++i) {
    const auto pose = Pose<3, double>::from_axis_angle(Vec<3, double>(0.5, -1, 2) * (0.1 * i),
                                                       Vec<3, double>(1, -2, 0.3 * i), 0.3 * i);
    const Obb<3, double> turned = transformed(box, pose);
    const Obb<3, double> turned_floor = transformed(floor_box(), pose);
    expect_no_jump_through_zero(turned, turned_floor, 4, pose.rotation * up);
  }
}

TEST(ContactOptions, ATiltedBoxHasTheCornersUpToTheMargin) {
  const HalfSpace<2, double> ground{{0, 1}, 0};
  const double angle = 0.05;
  const Obb<2, double> tilted{{0, 1}, {1, 1}, rotation_from_angle(angle)};
  EXPECT_EQ(manifold(tilted, ground).size, 2U) << "clipped at the surface";
  const auto found = manifold(tilted, ground, near);
  ASSERT_EQ(found.size, 2U);
  EXPECT_NEAR(least_depth(found), -(1 - std::cos(angle) + std::sin(angle)) + 2 * (1 - std::cos(angle)), 1e-2);
  EXPECT_LT(least_depth(found), 0);
  EXPECT_EQ(manifold(tilted, ground, ContactOptions{0.01}).size, 2U) << "clipped at the margin";
  EXPECT_NEAR(least_depth(manifold(tilted, ground, ContactOptions{0.01})), -0.01, 1e-12);
}

TEST(ContactOptions, CornersAndEdgesThatAreNearHaveOnePoint) {
  const auto found = manifold(Box{{0, 0, 0}, {1, 1, 1}}, Box{{1.03, 1.04, -1}, {2, 2, 2}}, near);
  ASSERT_EQ(found.size, 1U);
  EXPECT_NEAR(found.points[0].depth, -0.05, 1e-15);
  EXPECT_NEAR(found.normal.x, 0.6, 1e-12);
  EXPECT_NEAR(found.normal.y, 0.8, 1e-12);
}

TEST(ContactOptions, ACompoundCountsAsItsNearestPart) {
  const AnyShape<3, double> steps =
      compound_of<3, double>({Box{{-4, -1, -4}, {0, 0, 4}}, Box{{0, -1, -4}, {4, 0.02, 4}}});
  const AnyShape<3, double> hovering = Box{{-1, 0.05, 0}, {1, 3, 1}};
  const auto found = manifold(hovering, steps, near);
  ASSERT_EQ(found.size, 4U);
  for (const auto& point : found.contacts()) {
    EXPECT_NEAR(point.depth, -0.03, 1e-15);
    EXPECT_EQ(point.id.part_b, 1U);
  }
  EXPECT_EQ(manifold(hovering, AnyShape<3, double>(Compound<3, double>{}), near).size, 0U);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(contact(hovering, AnyShape<3, double>(Compound<3, double>{}), ContactOptions{infinity}).has_value());
  EXPECT_TRUE(contact(hovering, steps, ContactOptions{infinity}).has_value());
}

TEST(ContactOptions, SizesDoNotMatter) {
  for (const double size : {1e-200, 1e-30, 1e30, 1e200}) {
    const Box hovering{Vec<3, double>(0, 0.01, 0) * size, Vec<3, double>(2, 3, 1) * size};
    const Box ground{Vec<3, double>(-4, -1, -4) * size, Vec<3, double>(4, 0, 4) * size};
    const auto found = manifold(hovering, ground, ContactOptions{0.1 * size});
    ASSERT_EQ(found.size, 4U) << size;
    EXPECT_NEAR(found.points[0].depth / size, -0.01, 1e-14) << size;
    EXPECT_EQ(manifold(hovering, ground, ContactOptions{0.001 * size}).size, 0U) << size;
  }
}

// ---- Laws

template <class SpaceType>
class MarginLaw : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;

  static std::pair<Any, Any> draw() {
    auto [a, b] = *any_pair<Any, Any>();
    RC_LOG() << "(" << to_source<dimension, Number>(a) << ", " << to_source<dimension, Number>(b) << ")\n";
    return {std::move(a), std::move(b)};
  }

  /// Often just above the distance.
  static double draw_margin(const Any& a, const Any& b) {
    const double distance = detail::proximity(a, b).distance;
    const double factor = 0.5 * static_cast<double>(*rc::gen::inRange(1, 5));
    const double margin = std::isfinite(distance) && distance > 0 ? distance * factor : factor;
    RC_PRE(margin > 0 && std::isfinite(margin));
    RC_LOG() << "margin " << literal(margin) << "\n";
    return margin;
  }
};

TYPED_TEST_SUITE(MarginLaw, Spaces);

TYPED_TEST(MarginLaw, WithoutAMarginNothingChanges) {
  check_property([] {
    const auto [a, b] = TestFixture::draw();
    RC_ASSERT(contact(a, b, ContactOptions{}) == contact(a, b));
    RC_ASSERT(manifold(a, b, ContactOptions{}) == manifold(a, b));
  });
}

TYPED_TEST(MarginLaw, ContactsAreThoseOfShapesThatMeetAndTheNearestPointsOfOthers) {
  check_property([] {
    using T = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw();
    const double margin = TestFixture::draw_margin(a, b);
    const auto found = contact(a, b, ContactOptions{margin});
    const auto met = contact(a, b);
    if (met) {
      RC_ASSERT(found == met);
      return;
    }
    const auto nearest = closest_points(a, b);
    RC_ASSERT(found.has_value() == (detail::proximity(a, b).distance <= margin && std::isfinite(nearest.distance)));
    if (!found) return;
    RC_ASSERT(found->depth == T(0) - nearest.distance);
    RC_ASSERT(found->depth < T(0));
    RC_ASSERT(found->point_a == nearest.point_a);
    RC_ASSERT(found->point_b == nearest.point_b);
    RC_ASSERT(found->normal == nearest.normal);
    RC_ASSERT(found->error == nearest.error);
  });
}

TYPED_TEST(MarginLaw, ManifoldsExistWhereContactsDoAndTheirDeepestPointIsAsDeep) {
  check_property([] {
    using T = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw();
    const double margin = TestFixture::draw_margin(a, b);
    const auto single = contact(a, b, ContactOptions{margin});
    const auto found = manifold(a, b, ContactOptions{margin});
    RC_ASSERT((found.size > 0) == single.has_value());
    if (!single || !std::isfinite(single->depth)) return;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const auto& point : found.contacts()) {
      deepest = std::max(deepest, static_cast<double>(point.depth));
      RC_ASSERT(static_cast<double>(point.depth) >= -margin * (1 + 1e-6));
    }
    const double size = CastCases<TypeParam>::extent(a) + CastCases<TypeParam>::extent(b);
    const double off = single->error + 4e-5 * (size + margin) + static_cast<double>(std::numeric_limits<T>::epsilon());
    RC_LOG() << "deepest " << deepest << ", contact " << single->depth << ", allowed " << off << "\n";
    RC_ASSERT(deepest <= static_cast<double>(single->depth) + off);
  });
}

TYPED_TEST(MarginLaw, SwappedShapesHaveTheSamePoints) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw();
    RC_PRE((to_source<N, T>(a) != to_source<N, T>(b)));
    const double margin = TestFixture::draw_margin(a, b);
    const auto one = manifold(a, b, ContactOptions{margin});
    const auto other = manifold(b, a, ContactOptions{margin});
    RC_ASSERT(one.size == other.size);
    RC_ASSERT(one.normal == -other.normal);
    for (std::size_t i = 0; i < one.size; ++i) {
      RC_ASSERT(one.points[i].point_a == other.points[i].point_b);
      RC_ASSERT(one.points[i].depth == other.points[i].depth);
      RC_ASSERT(one.points[i].id.a == other.points[i].id.b);
    }
  });
}

TYPED_TEST(MarginLaw, PointsAreOnBothShapesAndApartByTheirDepth) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw();
    const double margin = TestFixture::draw_margin(a, b);
    const auto found = manifold(a, b, ContactOptions{margin});
    for (const auto& point : found.contacts()) {
      if (!std::isfinite(point.depth)) return;
      const Vec<N, double> between = wide<N, T>(point.point_a) - wide<N, T>(point.point_b);
      const Vec<N, double> expected = wide<N, T>(found.normal) * static_cast<double>(point.depth);
      const double size = static_cast<double>(max_abs(point.point_a)) + static_cast<double>(max_abs(point.point_b)) +
                          std::fabs(static_cast<double>(point.depth));
      const double off =
          8 * (static_cast<double>(std::numeric_limits<T>::epsilon()) * size + found.error) + 2e-5 * size;
      RC_LOG() << "off by " << length(between - expected) << ", allowed " << off << "\n";
      RC_ASSERT(length(between - expected) <= off);
    }
  });
}

}  // namespace
}  // namespace graze::test::contact_options_test
