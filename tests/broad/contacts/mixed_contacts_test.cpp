// SPDX-License-Identifier: MIT
// The manifolds of many pairs of an oriented box and an AABB are bit-identical to those of single calls, with every
// instruction set; and hardly any pair is left to single calls.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/contacts/mixed_contacts.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/same_manifolds.hpp"
#include "broad/simd_targets.hpp"
#include "catalogue.hpp"

namespace graze::detail::mixed_contacts_test {
namespace {

using V3 = Vec<3, double>;

enum class Sort { random, grid, stacked, resting, flat, far };

/// Draws an AABB and an oriented box, of about unit size.
class MixedDrawer {
 public:
  MixedDrawer(std::uint32_t seed, Sort sort) : random_(seed), sort_(sort) {}

  /// Pairs in either order that overlap or touch.
  template <class T>
  std::vector<AnyShape<3, T>> many(std::size_t count) {
    std::vector<AnyShape<3, T>> drawn;
    for (std::size_t tried = 0; drawn.size() < 2 * count && tried < 40 * count; ++tried) {
      const V3 center = vector(0.6) * (sort_ == Sort::far ? 1e5 : 1.0);
      const V3 half = abs(vector(0.8)) + (sort_ == Sort::grid ? 0.5 : 0.01);
      const Aabb<3, T> box{Vec<3, T>(center - half), Vec<3, T>(center + half)};
      const Obb<3, T> other = turned_box<T>(center, half);
      if (relation(box, other) == Relation::apart) continue;
      if (tried % 3 == 0) {
        drawn.insert(drawn.end(), {box, other});
      } else {
        drawn.insert(drawn.end(), {other, box});
      }
    }
    return drawn;
  }

 private:
  double number(double low, double high) {
    const double drawn = std::uniform_real_distribution<double>(low, high)(random_);
    return sort_ == Sort::grid ? std::round(2 * drawn) / 2 : drawn;
  }
  V3 vector(double size) { return V3(number(-size, size), number(-size, size), number(-size, size)); }

  /// One on the other, if they are stacked.
  template <class T>
  Obb<3, T> turned_box(const V3& below, const V3& half_below) {
    V3 half = abs(vector(0.8));
    V3 center = below + vector(0.6);
    V3 axis(number(-1, 1), number(-1, 1), 2);
    if (sort_ == Sort::flat) half.y = 0;
    if (sort_ == Sort::stacked) {
      center.z = below.z + half_below.z + half.z - 0.01;
      axis = V3(0, 0, 1);
    }
    Mat<3, double> turn = rotation_matrix(axis, sort_ == Sort::grid ? 90 : number(0, 360));
    if (sort_ == Sort::resting) {
      const double tilt = std::pow(10.0, number(-15, -4));
      turn = rotation_matrix(V3(number(-1, 1), 1, 0), 57 * tilt) * rotation_matrix(V3(0, 0, 1), number(0, 360));
      center.z = below.z + half_below.z + half.z + number(-1, 1) * tilt;
    }
    Mat<3, T> axes(turn);
    if (number(-1, 1) > 0.8) axes[0].x *= static_cast<T>(1 + 1e-5);
    return {Vec<3, T>(center), Vec<3, T>(half), axes};
  }

  std::mt19937 random_;
  Sort sort_;
};

/// The number of pairs that are left to single calls.
template <class T>
std::size_t left_of(const std::vector<AnyShape<3, T>>& shapes, const std::string& where) {
  const std::size_t count = shapes.size() / 2;
  std::vector<Manifold<3, T>> found(count);
  MixedPairs<T> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_TRUE(pairs.add({&shapes[2 * i], &shapes[2 * i + 1]}, &found[i], i));
  }
  std::vector<bool> is_left(count);
  std::size_t left_count = 0;
  pairs.contact([&](std::size_t place) {
    EXPECT_FALSE(is_left.at(place)) << where;
    is_left[place] = true;
    ++left_count;
  });
  for (std::size_t i = 0; i < count; ++i) {
    if (is_left[i]) continue;
    EXPECT_TRUE(test::same_manifolds(found[i], manifold(shapes[2 * i], shapes[2 * i + 1])))
        << where << '\n'
        << test::to_source<3, T>(shapes[2 * i]) << '\n'
        << test::to_source<3, T>(shapes[2 * i + 1]);
  }
  return left_count;
}

/// Whether there are kernels for this instruction set: it must have vectors of at least four doubles.
bool has_kernels([[maybe_unused]] std::int64_t target) {
#if HWY_ARCH_X86
  return target <= HWY_AVX2;  // better sets have lower bits
#else
  return false;
#endif
}

/// With every instruction set; at most this share may be left, if there are kernels.
template <class T>
void expect_single_calls(const std::vector<AnyShape<3, T>>& shapes, double most_left) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    const std::size_t left = left_of<T>(shapes, hwy::TargetName(target));
    if (!has_kernels(target)) {
      EXPECT_EQ(2 * left, shapes.size());
    } else {
      EXPECT_LE(static_cast<double>(2 * left), most_left * static_cast<double>(shapes.size()))
          << hwy::TargetName(target);
    }
  }
}

template <class T>
void expect_most_taken(Sort sort) {
  const auto shapes = MixedDrawer(3, sort).many<T>(256);
  ASSERT_EQ(shapes.size(), 512U);
  expect_single_calls<T>(shapes, 0.05);
}

TEST(MixedPairs, AreNearlyAllTakenByKernels) {
  for (const Sort sort : {Sort::random, Sort::stacked}) {
    expect_most_taken<float>(sort);
    expect_most_taken<double>(sort);
  }
}

/// The last batch may be incomplete, and there may be no pairs.
TEST(MixedPairs, MayBeAnyNumber) {
  for (const std::size_t count : {0U, 1U, 2U, 63U, 64U, 65U, 255U}) {
    expect_single_calls<float>(MixedDrawer(7, Sort::random).many<float>(count), 1);
    expect_single_calls<double>(MixedDrawer(7, Sort::random).many<double>(count), 1);
  }
}

TEST(MixedPairs, AreNoOthers) {
  const AnyShape<3> box = Aabb<3>{{0, 0, 0}, {1, 1, 1}};
  const AnyShape<3> turned = Obb<3>{{0, 0, 0}, {1, 1, 1}, Mat<3, float>(1.0F)};
  const AnyShape<3> sphere = Sphere<3>{{0, 0, 0}, 1};
  Manifold<3> found;
  MixedPairs<float> pairs;
  for (const auto& pair : {ShapePair<3, float>{&box, &box}, {&turned, &turned}, {&sphere, &turned}, {&box, &sphere}}) {
    EXPECT_FALSE(pairs.add(pair, &found, 0));
  }
  pairs.contact([](std::size_t) { FAIL() << "there is no pair"; });
}

RC_GTEST_PROP(MixedPairs, AreWhatSingleCallsSay, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  for (const Sort sort : {Sort::random, Sort::grid, Sort::stacked, Sort::resting, Sort::flat, Sort::far}) {
    expect_single_calls<float>(MixedDrawer(seed, sort).many<float>(24), 1);
    expect_single_calls<double>(MixedDrawer(seed, sort).many<double>(24), 1);
  }
}

}  // namespace
}  // namespace graze::detail::mixed_contacts_test
