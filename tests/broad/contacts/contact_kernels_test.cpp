// SPDX-License-Identifier: MIT
// The manifolds that kernels write for 3D spheres, capsules and boxes are bit-identical to those of single calls, with
// every instruction set; and the kernels leave few pairs, so that the comparison is meaningful.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/contact_kernel_checks.hpp"
#include "broad/same_manifolds.hpp"

namespace graze::detail::primitive_kernels_test {
namespace {

template <class T>
using Ball = Sphere<3, T>;
template <class T>
using Capsule3 = Capsule<3, T>;
template <class T>
using Box = Aabb<3, T>;
template <class T>
using TurnedBox = Obb<3, T>;
using test::PairsOf;

template <class A, class B>
constexpr PrimitiveKind kind_of() {
  if (is_a<Capsule, A> && is_a<Aabb, B>) return PrimitiveKind::capsule_aabb;
  if (is_a<Capsule, A> && is_a<Obb, B>) return PrimitiveKind::capsule_obb;
  if (is_a<Capsule, A>) return PrimitiveKind::capsule_capsule;
  if (is_a<Aabb, A>) return PrimitiveKind::aabb_aabb;
  if (is_a<Capsule, B>) return PrimitiveKind::sphere_capsule;
  if (is_a<Aabb, B>) return PrimitiveKind::sphere_aabb;
  return is_a<Obb, B> ? PrimitiveKind::sphere_obb : PrimitiveKind::sphere_sphere;
}

template <class T, class A, class B>
void expect_single_calls(const PairsOf<A, B>& drawn, double most_left) {
  test::expect_single_calls_of<3, T>(drawn, most_left,
                                     [] { return contact_kernels<T>()[static_cast<std::size_t>(kind_of<A, B>())]; });
}

enum class Sort { random, grid, scaled, level };

/// Draws shapes of about unit size near the origin; on a grid, so that ends, centers and sides coincide; of any size;
/// or with nearly parallel axes.
class Drawer {
 public:
  using V3 = Vec<3, double>;

  Drawer(std::uint32_t seed, Sort sort) : random_(seed), sort_(sort) {}

  /// Shapes that overlap or touch.
  template <class A, class B>
  PairsOf<A, B> many(std::size_t count) {
    PairsOf<A, B> drawn;
    for (std::size_t tried = 0; drawn.size() < count && tried < 40 * count; ++tried) {
      scale_ = sort_ == Sort::scaled ? std::pow(10.0, number(-6, 6)) : 1;
      std::pair<A, B> pair;
      draw(pair.first);
      draw(pair.second);
      if (relation(pair.first, pair.second) != Relation::apart) drawn.push_back(pair);
    }
    return drawn;
  }

 private:
  double number(double low, double high) {
    const double drawn = std::uniform_real_distribution<double>(low, high)(random_);
    return sort_ == Sort::grid ? std::round(2 * drawn) / 2 : drawn;
  }
  V3 vector(double size) { return V3(number(-size, size), number(-size, size), number(-size, size)) * scale_; }

  template <class T>
  void draw(Ball<T>& sphere) {
    sphere = {Vec<3, T>(vector(0.6)), static_cast<T>(std::fabs(number(0.2, 0.8)) * scale_)};
  }
  template <class T>
  void draw(Capsule3<T>& capsule) {
    const V3 start = vector(0.6);
    const V3 way = sort_ == Sort::level ? V3(1, 0, 0) + vector(1e-9) : vector(1);
    capsule = {Vec<3, T>(start), Vec<3, T>(start + way), static_cast<T>(std::fabs(number(0.1, 0.4)) * scale_)};
  }

  template <class T>
  void draw(Box<T>& box) {
    const V3 center = vector(0.6);
    const V3 half = abs(vector(0.8));
    box = {Vec<3, T>(center - half), Vec<3, T>(center + half)};
  }
  /// Its axes are orthonormal up to the rounding of T, or less precisely.
  template <class T>
  void draw(TurnedBox<T>& box) {
    V3 axis(number(-1, 1), number(-1, 1), 2);
    Mat<3, T> axes(rotation_matrix(axis, sort_ == Sort::grid ? 90 : number(0, 360)));
    if (number(-1, 1) > 0.8) axes[0].x *= static_cast<T>(1 + 1e-5);
    box = {Vec<3, T>(vector(0.6)), Vec<3, T>(abs(vector(0.8))), axes};
  }

  std::mt19937 random_;
  Sort sort_;
  double scale_ = 1;
};

/// Calls `check(pairs)` for all kinds.
template <class T, class Check>
void for_each_kind(Drawer drawer, std::size_t count, const Check& check) {
  check(drawer.many<Ball<T>, Ball<T>>(count));
  check(drawer.many<Ball<T>, Capsule3<T>>(count));
  check(drawer.many<Capsule3<T>, Capsule3<T>>(count));
  check(drawer.many<Ball<T>, Box<T>>(count));
  check(drawer.many<Ball<T>, TurnedBox<T>>(count));
  check(drawer.many<Box<T>, Box<T>>(count));
  check(drawer.many<Capsule3<T>, Box<T>>(count));
  check(drawer.many<Capsule3<T>, TurnedBox<T>>(count));
}

template <class T>
void expect_most_taken() {
  for_each_kind<T>(Drawer(5, Sort::random), 1000, [](const auto& drawn) {
    ASSERT_EQ(drawn.size(), 1000U);
    expect_single_calls<T>(drawn, 0.1);  // e.g. rods that are less than seven degrees from parallel
  });
}

TEST(ContactKernels, LeaveHardlyAnyPairs) {
  expect_most_taken<float>();
  expect_most_taken<double>();
}

/// The last group may be incomplete, and there may be no pairs.
TEST(ContactKernels, TakeAnyNumberOfPairs) {
  for (std::size_t count = 0; count < 20; ++count) {
    for_each_kind<double>(Drawer(7, Sort::random), count,
                          [](const auto& drawn) { expect_single_calls<double>(drawn, 1); });
  }
}

RC_GTEST_PROP(ContactKernels, SayOfAnyShapesWhatSingleCallsDo, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  for (const Sort sort : {Sort::random, Sort::grid, Sort::scaled, Sort::level}) {
    for_each_kind<float>(Drawer(seed, sort), 24, [](const auto& drawn) { expect_single_calls<float>(drawn, 1); });
    for_each_kind<double>(Drawer(seed, sort), 24, [](const auto& drawn) { expect_single_calls<double>(drawn, 1); });
  }
}

/// Cases where halves are rounded, and where sums overflow.
TEST(ContactKernels, TakeBoxesWithTheLeastAndTheLargestNumbers) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = 0.75 * std::numeric_limits<double>::max();
  const std::vector<Box<double>> boxes{{{-least, 0, 0}, {least, 2, 3}},
                                       {{0, -1, -least}, {1, least, 3 * least}},
                                       {{least, least, least}, {2, 3, 4}},
                                       {{most / 4, most / 4, most / 4}, {most, most, most}},
                                       {{-most / 4, 0, 0}, {most / 2, most / 2, most / 2}},
                                       {{-most, -most, -most}, {most, most, most}}};
  PairsOf<Box<double>, Box<double>> drawn;
  for (const auto& a : boxes) {
    for (const auto& b : boxes) {
      if (relation(a, b) != Relation::apart) drawn.emplace_back(a, b);
    }
  }
  expect_single_calls<double>(drawn, 0.1);  // all but the two whose depth overflows
}

/// In any order, among pairs of other kinds, and more than a kernel's batch.
TEST(ContactKernels, ServeContacts) {
  using Any = AnyShape<3, double>;
  Drawer drawer(11, Sort::random);
  std::vector<Any> shapes;
  std::vector<Pair> candidates;
  const auto add = [&](const Any& a, const Any& b) {
    const auto place = static_cast<std::uint32_t>(shapes.size());
    shapes.insert(shapes.end(), {a, b});
    candidates.push_back(place % 4 == 0 ? Pair{place, place + 1} : Pair{place + 1, place});
  };
  const auto spheres = drawer.many<Ball<double>, Ball<double>>(500);
  const auto mixed = drawer.many<Ball<double>, Capsule3<double>>(500);
  const auto rods = drawer.many<Capsule3<double>, Capsule3<double>>(500);
  const auto boxes = drawer.many<Ball<double>, Box<double>>(500);
  const auto turned = drawer.many<Ball<double>, TurnedBox<double>>(500);
  const auto leaning = drawer.many<Capsule3<double>, Box<double>>(500);
  const auto lying = drawer.many<Capsule3<double>, TurnedBox<double>>(500);
  for (std::size_t i = 0; i < 500; ++i) {
    add(leaning[i].first, leaning[i].second);
    add(lying[i].first, lying[i].second);
    add(spheres[i].first, spheres[i].second);
    add(mixed[i].first, mixed[i].second);
    add(rods[i].first, rods[i].second);
    add(boxes[i].first, boxes[i].second);
    add(turned[i].first, turned[i].second);
    add(boxes[i].second, turned[i].second);
    add(boxes[i].second, boxes[(i + 1) % 500].second);
  }
  const auto found = contacts(std::span<const Any>(shapes), candidates, {});
  ASSERT_GE(found.size(), 3500U);  // pairs of two boxes need not touch
  for (const auto& one : found) {
    EXPECT_TRUE(test::same_manifolds(one.manifold, manifold(shapes[one.pair.a], shapes[one.pair.b])));
  }
}

}  // namespace
}  // namespace graze::detail::primitive_kernels_test
