// SPDX-License-Identifier: MIT
// Compounds with and without a tree: every query gives the same answer, bit for bit, and that of the best part.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/ray/parts.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/point_answers.hpp"
#include "query/same_answers.hpp"

namespace graze::test::visit_test {
namespace {

template <class SpaceType>
class TreeOfParts : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Point = Vec<N, T>;

  /// The same parts twice, and something to ask about them.
  struct Case {
    Any loop;  ///< Without a tree.
    Any tree;
    Any other;
    Point motion;
    Point point;

    const Parts<N, T>& parts() const { return std::get<Compound<N, T>>(loop).parts; }
  };

  static Case case_of(const std::vector<Any>& shapes, const Any& other, const Point& motion, const Point& point) {
    std::vector<Part<N, T>> list;
    for (const Any& shape : shapes) list.push_back({shape, bounds(shape)});
    return {Compound<N, T>{list}, Compound<N, T>{detail::with_tree(list)}, other, motion, point};
  }

  /// A few shapes, repeated on a lattice: many parts are equally good, and some coincide.
  static Case draw() {
    constexpr std::array<std::size_t, 6> most_copies = {1, 1, 2, 5, 9, 40};
    const Source<N, T> from = draw_source<N, T>();
    const std::size_t originals = *choice(12);
    const std::size_t copies = most_copies[*choice(most_copies.size())];
    const std::size_t step = *choice(3) * 4;
    std::vector<Any> shapes;
    for (std::size_t i = 0; i < originals; ++i) shapes.push_back(draw_shape<N, T>(from, 2));
    for (std::size_t copy = 1; copy < copies; ++copy) {
      Point offset(T(0));
      offset[0] = static_cast<T>(copy % 3 * step);
      offset[1] = static_cast<T>(copy / 3 % 3 * step);
      offset[N - 1] += static_cast<T>(copy / 9 * step);
      for (std::size_t i = 0; i < originals; ++i) shapes.push_back(translated<N, T>(shapes[i], offset));
    }
    const Any other = draw_shape<N, T>(from, 1);
    const Point motion = *from.point;
    return case_of(shapes, other, motion, *from.point);
  }

  static void check_pairs(const Case& each) {
    const auto& [loop, tree, other, motion, point] = each;
    RC_ASSERT(relation(tree, other) == relation(loop, other));
    RC_ASSERT(relation(other, tree) == relation(other, loop));
    RC_ASSERT(contact(tree, other) == contact(loop, other));
    RC_ASSERT(contact(other, tree) == contact(other, loop));
    RC_ASSERT(manifold(tree, other) == manifold(loop, other));
    RC_ASSERT(manifold(other, tree) == manifold(other, loop));
    RC_ASSERT(same(closest_points(tree, other), closest_points(loop, other)));
    RC_ASSERT(same(closest_points(other, tree), closest_points(other, loop)));
  }

  static void check_motions(const Case& each) {
    const auto& [loop, tree, other, motion, point] = each;
    RC_ASSERT(shape_cast(tree, motion, other) == shape_cast(loop, motion, other));
    RC_ASSERT(shape_cast(other, motion, tree) == shape_cast(other, motion, loop));
    Motion<N, T> turning;
    turning.linear = motion;
    turning.center = point;
    turning.angular = Turn<N, T>(1.5);
    const Motion<N, T> resting;
    RC_ASSERT(time_of_impact(tree, turning, other, resting) == time_of_impact(loop, turning, other, resting));
    RC_ASSERT(time_of_impact(other, turning, tree, resting) == time_of_impact(other, turning, loop, resting));
  }

  static void check_points_and_rays(const Case& each) {
    const auto& [loop, tree, other, motion, point] = each;
    RC_ASSERT(bounds(tree) == bounds(loop));
    RC_ASSERT(touching_bounds(tree) == touching_bounds(loop));
    RC_ASSERT(contains(tree, point) == contains(loop, point));
    RC_ASSERT(signed_distance(tree, point) == signed_distance(loop, point));
    RC_ASSERT((same_point<N, T>(closest_point(tree, point), closest_point(loop, point))));
    RC_ASSERT((same_point<N, T>(closest_boundary_point(tree, point), closest_boundary_point(loop, point))));
    const Segment<N, T> segment{point, point + motion};
    for (const RaySide side : {RaySide::entry, RaySide::exit}) {
      const RayOptions options{side};
      RC_ASSERT(ray_cast(tree, segment, options) == ray_cast(loop, segment, options));
      if (max_abs(motion) == T(0)) continue;
      const Ray<N, T> ray{point, motion};
      RC_ASSERT(ray_cast(tree, ray, T(1), options) == ray_cast(loop, ray, T(1), options));
      RC_ASSERT(ray_cast(tree, ray, std::numeric_limits<T>::infinity(), options) ==
                ray_cast(loop, ray, std::numeric_limits<T>::infinity(), options));
    }
  }

  /// The answers of all parts, each asked alone, without skipping any.
  static void check_against_all_parts(const Case& each) {
    const auto& [loop, tree, other, motion, point] = each;
    Relation closest = Relation::apart;
    std::optional<T> deepest;
    std::optional<T> first_impact;
    std::optional<RayHit<N, T>> first_hit;
    T nearest = std::numeric_limits<T>::infinity();
    bool is_held = false;
    for (const Part<N, T>& part : each.parts()) {
      closest = std::max(closest, relation(part.shape, other));
      nearest = std::min(nearest, closest_points(part.shape, other).distance);
      is_held = is_held || contains(part.shape, point);
      if (const auto found = contact(part.shape, other))
        deepest = std::max(deepest.value_or(found->depth), found->depth);
      if (const auto found = shape_cast(part.shape, motion, other)) {
        first_impact = std::min(first_impact.value_or(found->t), found->t);
      }
      if (max_abs(motion) == T(0)) continue;
      const auto hit = ray_cast(part.shape, Ray<N, T>{point, motion});
      if (hit && (!first_hit || hit->t < first_hit->t)) first_hit = hit;
    }
    RC_ASSERT(relation(tree, other) == closest);
    RC_ASSERT(closest_points(tree, other).distance == nearest);
    RC_ASSERT(contains(tree, point) == is_held);
    const auto found = contact(tree, other);
    RC_ASSERT((found ? std::optional<T>(found->depth) : std::nullopt) == deepest);
    const auto impact = shape_cast(tree, motion, other);
    RC_ASSERT((impact ? std::optional<T>(impact->t) : std::nullopt) == first_impact);
    if (max_abs(motion) > T(0)) RC_ASSERT(ray_cast(tree, Ray<N, T>{point, motion}) == first_hit);
  }

  static void check_thousands() {
    std::vector<Any> shapes;
    for (int i = 0; i < 2000; ++i) {
      Point center(T(0));
      center[0] = static_cast<T>(i * 7 % 11);
      center[1] = static_cast<T>(i * 5 % 13);
      center[N - 1] += static_cast<T>(i * 3 % 17);
      if (i % 2 == 0) shapes.push_back(Sphere<N, T>{center, T(0.25)});
      if (i % 2 == 1) shapes.push_back(Aabb<N, T>::from_center(center, Point(T(0.25))));
    }
    for (int i = 0; i < 20; ++i) {
      Point motion(static_cast<T>(i % 3 - 1));
      motion[0] = static_cast<T>(i % 7 * 3);
      const Point point(static_cast<T>(i) * T(0.5));
      const Any other = Aabb<N, T>::from_center(point - motion, Point(T(1)));
      const Case each = case_of(shapes, other, motion, point);
      check_pairs(each);
      check_motions(each);
      check_points_and_rays(each);
    }
  }
};
TYPED_TEST_SUITE(TreeOfParts, Spaces);

TYPED_TEST(TreeOfParts, AnswersQueriesOfPairsAsTheLoop) {
  check_property([] { TestFixture::check_pairs(TestFixture::draw()); });
}

TYPED_TEST(TreeOfParts, AnswersMotionsAsTheLoop) {
  check_property([] { TestFixture::check_motions(TestFixture::draw()); });
}

TYPED_TEST(TreeOfParts, AnswersPointsAndRaysAsTheLoop) {
  check_property([] { TestFixture::check_points_and_rays(TestFixture::draw()); });
}

TYPED_TEST(TreeOfParts, AnswersAsTheBestOfAllParts) {
  check_property([] { TestFixture::check_against_all_parts(TestFixture::draw()); });
}

/// Two thousand small spheres and boxes on a lattice, and one on every point of it.
TYPED_TEST(TreeOfParts, DecidesTiesAmongThousandsOfParts) { TestFixture::check_thousands(); }

/// Among boxes of whole coordinates, many of which the path touches, it may only accept more by its larger margin.
TEST(RestOfPath, InsideABoxItAcceptsTheSameBoxes) {
  using Box = Aabb<3, double>;
  std::mt19937 random(48);
  const auto number = [&random](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  const auto point = [&](int low, int high) {
    const double x = number(low, high);
    const double y = number(low, high);
    return Vec<3, double>(x, y, number(low, high));
  };
  const Box around{Vec<3, double>(0.0), Vec<3, double>(12.0)};
  int accepted = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vec<3, double> direction = point(-2, 2);
    if (max_abs(direction) == 0) continue;
    detail::RestOfPath<3> rest(detail::Path<3>{point(-2, 14), direction, static_cast<double>(number(0, 20)) / 2});
    const auto inside = rest.inside(around, 0);
    const Vec<3, double> corner = point(0, 6);
    const Box box{corner, corner + point(0, 6)};
    const Box grown{box.min - 1e-9, box.max + 1e-9};
    for (const double end : {1e9, 3.0, 1.0, 0.0}) {
      if (end < 1e9) rest.end_at(end);
      EXPECT_TRUE(!rest(box) || inside(box));
      EXPECT_TRUE(!inside(box) || rest(grown));
      accepted += inside(box) ? 1 : 0;
    }
  }
  EXPECT_GT(accepted, 1000);
}

TEST(FirstPart, PrefersTheLeastValueThenTheFirstPart) {
  detail::FirstPart first;
  EXPECT_TRUE(first.is_none());
  EXPECT_TRUE(first.is_replaced_by(2, 7));
  EXPECT_FALSE(first.is_replaced_by(2, 8));
  EXPECT_FALSE(first.is_replaced_by(3, 0));
  EXPECT_TRUE(first.is_replaced_by(2, 6));
  EXPECT_TRUE(first.is_replaced_by(1, 9));
  EXPECT_EQ(first.index(), 9u);
}

}  // namespace
}  // namespace graze::test::visit_test
