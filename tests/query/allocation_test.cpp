// SPDX-License-Identifier: MIT
// No query on two shapes allocates: for any two types, any number of corners, including user-defined shapes, apart,
// touching or overlapping. This program counts the calls of operator new; other tests compare answers.
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/compound.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>

#include "catalogue.hpp"
#include "heap_watch.hpp"
#include "query/contacts.hpp"
#include "query/every_pair.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/point_answers.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/shape_casts.hpp"
#include "query/times_of_impact.hpp"

namespace graze::test::allocation_test {
namespace {

/// How often each query allocated, by its types.
using Tally = std::map<std::string, std::size_t>;

template <Dim N, class T>
std::string types_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  const auto name = [](const auto& held) { return std::string(Entry<std::decay_t<decltype(held)>>::name); };
  return std::visit(name, a) + ", " + std::visit(name, b);
}

template <Dim N, class T>
class Counting {
 public:
  /// Calls a query on two shapes, and records if it allocates.
  template <class Query>
  void call(const char* query, const AnyShape<N, T>& a, const AnyShape<N, T>& b, const Query& ask) {
    const std::size_t before = heap_watch.requests;
    (void)ask();
    if (heap_watch.requests != before) ++tally_[std::string(query) + " of " + types_of<N, T>(a, b)];
    ++calls_;
  }

  const Tally& tally() const { return tally_; }
  std::size_t calls() const { return calls_; }

 private:
  Tally tally_;
  std::size_t calls_ = 0;
};

template <Dim N, class T>
Vec<N, T> along_x(double size) {
  return Vec<N, T>(unit_axis<N>(0) * size);
}

/// There and back with half a turn.
template <Dim N, class T>
Motion<N, T> half_turn() {
  Motion<N, T> motion;
  motion.linear = Vec<N, T>(T(1));
  if constexpr (N == 2) {
    motion.angular = T(3);
  } else {
    motion.angular = Vec<N, T>(T(1), T(2), T(-2));
  }
  return motion;
}

template <class Space>
class AllocationIn : public testing::Test {
 public:
  static constexpr Dim dimension = Space::dimension;
  using Number = typename Space::scalar;
  using Any = AnyShape<dimension, Number>;

  /// Calls every query on two shapes.
  void ask(const Any& a, const Any& b) {
    const auto call = [&](const char* query, const auto& question) { counting_.call(query, a, b, question); };
    call("relation", [&] { return relation_of<dimension, Number>(a, b); });
    call("distance", [&] { return distance_of<dimension, Number>(a, b); });
    call("closest_points", [&] { return closest_points_of<dimension, Number>(a, b); });
    call("contact", [&] { return contact_of<dimension, Number>(a, b); });
    call("manifold", [&] { return manifold_of<dimension, Number>(a, b); });
    call("shape_cast", [&] { return impact_of<dimension, Number>(a, Vec<dimension, Number>(Number(1)), b); });
    const Moving<dimension, Number> moving{a, half_turn<dimension, Number>(), b, {}};
    call("time_of_impact", [&] { return impact_of<dimension, Number>(moving); });
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      if (const auto* ray = std::get_if<Ray<dimension, Number>>(one)) {
        call("ray_cast", [&, shape = other] { return hit_of<dimension, Number>(*shape, *ray, Number(8)); });
      }
      if (const auto* point = std::get_if<Vec<dimension, Number>>(one)) {
        call("point queries", [&, shape = other] { return answers<dimension, Number>(*shape, *point); });
      }
    }
  }

  void expect_none(std::size_t least_calls) const {
    EXPECT_GT(counting_.calls(), least_calls);
    for (const auto& [what, times] : counting_.tally()) ADD_FAILURE() << what << ", " << times << " times";
  }

 private:
  Counting<dimension, Number> counting_;
};

TYPED_TEST_SUITE(AllocationIn, Spaces);

TYPED_TEST(AllocationIn, IsNotNeededByAnyQueryOfTwoShapes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto always = [] { return true; };
  for (const CaseKind kind : {CaseKind::uniform, CaseKind::grid, CaseKind::shared_points}) {
    for_each_case<N, T>(
        kind, 10, [this](const AnyPair<N, T>& pair) { this->ask(pair.first, pair.second); }, always);
  }
  this->expect_none(15'000);
}

/// A regular polygon; in 3D the prism on it.
template <Dim N, class T>
Polytope<N, T> round_polytope(std::size_t corners) {
  std::vector<Vec<N, T>> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec<2, double> turn = cosine_sine_of_degrees(360.0 * static_cast<double>(i) / static_cast<double>(corners));
    if constexpr (N == 2) {
      points.emplace_back(turn);
    } else {
      for (const double z : {-1.0, 1.0}) points.emplace_back(turn.x, turn.y, z);
    }
  }
  return convex_hull<N, T>(points);
}

TYPED_TEST(AllocationIn, IsNotNeededHoweverManyCornersThereAre) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<AnyShape<N, T>> shapes;
  for (const std::size_t corners : {3U, 32U, 500U}) {
    shapes.push_back(round_polytope<N, T>(corners));
    for (const double way : {0.1, 1.9, 2.5}) {
      const Pose<N, T> pose{Mat<N, T>(T(1)), along_x<N, T>(way)};
      shapes.push_back(transformed(shapes[shapes.size() - 1], pose));
    }
  }
  shapes.push_back(compound_of<N, T>(shapes));
  shapes.push_back(Aabb<N, T>{Vec<N, T>(T(-1)), Vec<N, T>(T(1))});
  shapes.push_back(Sphere<N, T>{along_x<N, T>(2), T(1)});
  shapes.push_back(Ray<N, T>{along_x<N, T>(-4), along_x<N, T>(1)});
  for (const auto& a : shapes) {
    for (const auto& b : shapes) this->ask(a, b);
  }
  this->expect_none(1'500);
}

/// |x / radii| <= 1, as a user may write it.
template <Dim N, class T>
struct Egg {
  Vec<N, T> center;
  Vec<N, T> radii;
};

template <Dim N, class T>
Vec<N, T> support(const Egg<N, T>& egg, const std::type_identity_t<Vec<N, T>>& direction) {
  const Vec<N, T> scaled = egg.radii * direction;
  return egg.center + egg.radii * scaled / std::sqrt(dot(scaled, scaled));
}

/// How often queries on a user's shape and another allocate.
template <class A, class B>
std::size_t asked_by_queries_of(const A& a, const B& b) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  const std::size_t before = heap_watch.requests;
  (void)intersects(a, b);
  (void)distance(a, b);
  (void)closest_points(a, b);
  (void)contact(a, b);
  (void)manifold(a, b);
  (void)shape_cast(a, Vec<N, T>(T(1)), b);
  (void)time_of_impact(a, half_turn<N, T>(), b, Motion<N, T>{});
  (void)ray_cast(a, Ray<N, T>{along_x<N, T>(-4), along_x<N, T>(1)}, T(8));
  (void)contains(a, along_x<N, T>(0.5));
  (void)closest_point(a, along_x<N, T>(3));
  (void)signed_distance(a, along_x<N, T>(0.5));
  return heap_watch.requests - before;
}

template <Dim N, class T>
void expect_none_for_eggs() {
  const Polytope<N, T> round = round_polytope<N, T>(32);
  Vec<N, T> radii(T(1));
  radii[0] = T(0.5);
  for (const double way : {0.0, 0.25, 1.375, 1.5, 4.0}) {
    const Egg<N, T> egg{along_x<N, T>(way), radii};
    EXPECT_EQ(asked_by_queries_of(egg, round), 0U) << way;
    EXPECT_EQ(asked_by_queries_of(egg, Egg<N, T>{along_x<N, T>(0), radii}), 0U) << way;
  }
}

TEST(Allocation, IsNotNeededForShapesOfOnesOwn) {
  expect_none_for_eggs<2, double>();
  expect_none_for_eggs<3, float>();
}

TEST(Allocation, IsSeenWhereThereIsSome) {
  const std::size_t before = heap_watch.requests;
  const std::string text(1000, 'x');
  EXPECT_GT(heap_watch.requests, before);
  EXPECT_EQ(text.size(), 1000U);
}

}  // namespace
}  // namespace graze::test::allocation_test
