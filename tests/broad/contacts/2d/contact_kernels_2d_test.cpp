// SPDX-License-Identifier: MIT
// The manifolds that kernels write for 2D spheres, capsules and boxes are bit-identical to those of single calls, with
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
#include <graze/broad/contacts/2d/contact_kernels_2d.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/contact_kernel_checks.hpp"

namespace graze::detail::flat_kernels_test {
namespace {

using V2 = Vec<2, double>;
template <class T>
using Ball = Sphere<2, T>;
template <class T>
using Capsule3 = Capsule<2, T>;
template <class T>
using Box = Aabb<2, T>;
template <class T>
using TurnedBox = Obb<2, T>;
using test::PairsOf;

template <class A, class B>
constexpr Kind2d kind_of() {
  if (is_a<Sphere, A>) {
    if (is_a<Sphere, B>) return Kind2d::sphere_sphere;
    if (is_a<Obb, B>) return Kind2d::sphere_obb;
    return is_a<Aabb, B> ? Kind2d::sphere_aabb : Kind2d::sphere_capsule;
  }
  if (is_a<Capsule, A>) return Kind2d::capsule_capsule;
  if (is_a<Aabb, A>) return is_a<Aabb, B> ? Kind2d::aabb_aabb : Kind2d::aabb_capsule;
  if (is_a<Obb, B>) return Kind2d::obb_obb;
  return is_a<Aabb, B> ? Kind2d::obb_aabb : Kind2d::obb_capsule;
}

template <class T, class A, class B>
void expect_single_calls(const PairsOf<A, B>& drawn, double most_left) {
  test::expect_single_calls_of<2, T>(drawn, most_left,
                                     [] { return contact_kernels_2d<T>()[static_cast<std::size_t>(kind_of<A, B>())]; });
}

enum class Sort { random, grid, scaled, level, far };

/// Draws shapes of about unit size near the origin; on a grid, so that ends, centers and sides coincide; of any size;
/// with nearly parallel sides; or far away.
class Drawer {
 public:
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
  V2 vector(double size) {
    const double x = number(-size, size);
    return V2(x, number(-size, size)) * scale_;
  }
  V2 place() { return vector(0.6) + (sort_ == Sort::far ? V2(3e5, -7e5) : V2(0.0)); }
  double angle() {
    if (sort_ == Sort::grid) return 90 * std::round(number(0, 4));
    return sort_ == Sort::level ? 90 * std::round(number(0, 4)) + number(-1, 1) * 1e-7 : number(0, 360);
  }

  template <class T>
  void draw(Ball<T>& sphere) {
    const V2 center = place();
    sphere = {Vec<2, T>(center), static_cast<T>(std::fabs(number(0.2, 0.8)) * scale_)};
  }
  template <class T>
  void draw(Capsule3<T>& capsule) {
    const V2 start = place();
    const V2 way = sort_ == Sort::level ? V2(1 + number(0, 1), 0) + vector(1e-9) : vector(1);
    capsule = {Vec<2, T>(start), Vec<2, T>(start + way), static_cast<T>(std::fabs(number(0.1, 0.4)) * scale_)};
  }
  template <class T>
  void draw(Box<T>& box) {
    const V2 center = place();
    const V2 half = abs(vector(0.8));
    box = {Vec<2, T>(center - half), Vec<2, T>(center + half)};
  }
  /// Its axes are orthonormal up to the rounding of T, or less precisely; right- or left-handed.
  template <class T>
  void draw(TurnedBox<T>& box) {
    Mat<2, T> axes(rotation_matrix(angle()));
    if (number(-1, 1) > 0.8) axes[0].x *= static_cast<T>(1 + 1e-5);
    if (number(-1, 1) > 0.5) axes[1] = -axes[1];
    const V2 center = place();
    box = {Vec<2, T>(center), Vec<2, T>(abs(vector(0.8))), axes};
  }

  std::mt19937 random_;
  Sort sort_;
  double scale_ = 1;
};

/// Calls `check(pairs)` for all kinds.
template <class T, class Check>
void for_each_kind(Drawer drawer, std::size_t count, const Check& check) {
  check(drawer.many<Ball<T>, Ball<T>>(count));
  check(drawer.many<Ball<T>, TurnedBox<T>>(count));
  check(drawer.many<Ball<T>, Box<T>>(count));
  check(drawer.many<Ball<T>, Capsule3<T>>(count));
  check(drawer.many<TurnedBox<T>, TurnedBox<T>>(count));
  check(drawer.many<TurnedBox<T>, Box<T>>(count));
  check(drawer.many<TurnedBox<T>, Capsule3<T>>(count));
  check(drawer.many<Box<T>, Box<T>>(count));
  check(drawer.many<Box<T>, Capsule3<T>>(count));
  check(drawer.many<Capsule3<T>, Capsule3<T>>(count));
}

template <class T>
void expect_most_taken() {
  for_each_kind<T>(Drawer(5, Sort::random), 1000, [](const auto& drawn) {
    ASSERT_EQ(drawn.size(), 1000U);
    expect_single_calls<T>(drawn, 0.02);
  });
}

TEST(ContactKernels2d, LeaveHardlyAnyPairs) {
  expect_most_taken<float>();
  expect_most_taken<double>();
}

/// A box on a box, slightly tilted, with a depth smaller than the effect of the tilt.
TEST(ContactKernels2d, TakeBoxesThatRestOnBoxes) {
  std::mt19937 random(11);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  PairsOf<TurnedBox<double>, TurnedBox<double>> turned;
  PairsOf<TurnedBox<double>, Box<double>> mixed;
  while (mixed.size() < 1000) {
    const double tilt = std::pow(10.0, number(-15, -4));
    const V2 half(number(0.1, 1), number(0.1, 1));
    const V2 other(number(0.1, 1), number(0.1, 1));
    const V2 place(number(-1, 1), half.y + other.y + number(-1, 1) * tilt);
    const TurnedBox<double> above{place, other, rotation_matrix((mixed.size() % 2 == 0 ? 57 : -57) * tilt)};
    const TurnedBox<double> below{V2(0.0), half, Mat<2, double>(1.0)};
    if (relation(above, below) == Relation::apart) continue;
    if (turned.size() % 3 == 0) {
      turned.emplace_back(below, above);
    } else {
      turned.emplace_back(above, below);
    }
    mixed.emplace_back(above, Box<double>{-half, half});
  }
  expect_single_calls<double>(turned, 0.5);
  expect_single_calls<double>(mixed, 0.5);
}

/// The last group may be incomplete, and there may be no pairs.
TEST(ContactKernels2d, TakeAnyNumberOfPairs) {
  for (std::size_t count = 0; count < 20; ++count) {
    for_each_kind<double>(Drawer(7, Sort::random), count,
                          [](const auto& drawn) { expect_single_calls<double>(drawn, 1); });
  }
}

/// Cases where halves are rounded, and where sums overflow.
TEST(ContactKernels2d, TakeBoxesWithTheLeastAndTheLargestNumbers) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = 0.75 * std::numeric_limits<double>::max();
  const std::vector<Box<double>> boxes{{{-least, 0}, {least, 2}},          {{0, -least}, {1, 3 * least}},
                                       {{least, least}, {2, 3}},           {{most / 4, most / 4}, {most, most}},
                                       {{-most / 4, 0}, {most / 2, most}}, {{-most, -most}, {most, most}}};
  PairsOf<Box<double>, Box<double>> drawn;
  for (const auto& a : boxes) {
    for (const auto& b : boxes) {
      if (relation(a, b) != Relation::apart) drawn.emplace_back(a, b);
    }
  }
  expect_single_calls<double>(drawn, 0.1);  // all but those whose depth overflows
}

RC_GTEST_PROP(ContactKernels2d, SayOfAnyShapesWhatSingleCallsDo, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  for (const Sort sort : {Sort::random, Sort::grid, Sort::scaled, Sort::level, Sort::far}) {
    for_each_kind<float>(Drawer(seed, sort), 24, [](const auto& drawn) { expect_single_calls<float>(drawn, 1); });
    for_each_kind<double>(Drawer(seed, sort), 24, [](const auto& drawn) { expect_single_calls<double>(drawn, 1); });
  }
}

}  // namespace
}  // namespace graze::detail::flat_kernels_test
