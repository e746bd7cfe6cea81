// SPDX-License-Identifier: MIT
// touching_pairs_test.cpp tests on hard cases that certain verdicts are right; this tests that easy cases are certain,
// so that the slow path is rare.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/touching/touching_kernels.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/simd_targets.hpp"

namespace graze::detail::touch_kernels_test {
namespace {

/// The share of neighbouring pairs that a kernel decides, the minimum over all instruction sets.
template <class A, class B>
double settled_share(TouchKind kind, const std::vector<A>& a, const std::vector<B>& b) {
  using T = scalar_of<A>;
  std::vector<const T*> rows_a;
  std::vector<const T*> rows_b;
  const std::size_t count = a.size() / touch_group * touch_group;
  for (std::size_t i = 0; i < count; ++i) {
    rows_a.push_back(reinterpret_cast<const T*>(&a[i]));
    rows_b.push_back(reinterpret_cast<const T*>(&b[i]));
  }
  double least = 1;
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    std::vector<GroupVerdict> verdicts(count / touch_group);
    touching_kernels<dimension_of<A>, T>()[kind](rows_a.data(), rows_b.data(), verdicts.size(), verdicts.data());
    std::size_t settled = 0;
    std::size_t apart = 0;
    for (const GroupVerdict& verdict : verdicts) {
      EXPECT_EQ(verdict.apart & verdict.overlapping, 0);
      settled +=
          static_cast<std::size_t>(std::popcount(static_cast<std::uint16_t>(verdict.apart | verdict.overlapping)));
      apart += static_cast<std::size_t>(std::popcount(verdict.apart));
    }
    EXPECT_GT(apart, count / 10) << hwy::TargetName(target);
    EXPECT_LT(apart, count - count / 10) << hwy::TargetName(target);
    least = std::min(least, static_cast<double>(settled) / static_cast<double>(count));
  }
  return least;
}

/// Random shapes in a volume where about half of the pairs meet.
template <Dim N, class T>
class Room {
 public:
  Vec<N, T> point(double reach) {
    Vec<N, T> result;
    for (Dim i = 0; i < N; ++i) result[i] = number(-reach, reach);
    return result;
  }
  T number(double low, double high) { return static_cast<T>(std::uniform_real_distribution<>(low, high)(random_)); }

  Vec<N, T> size() {
    Vec<N, T> result;
    for (Dim i = 0; i < N; ++i) result[i] = number(0.2, 1.5);
    return result;
  }
  Mat<N, T> axes() {
    if constexpr (N == 2) {
      return Mat<2, T>(rotation_matrix(number(-180, 180)));
    } else {
      return Mat<3, T>(rotation_matrix({number(-1, 1), number(-1, 1), number(0.1, 1)}, number(-180, 180)));
    }
  }
  Sphere<N, T> sphere() { return {point(1.5), number(0.2, 1.5)}; }
  Aabb<N, T> aabb() {
    const Vec<N, T> center = point(1.5);
    const Vec<N, T> half = size();
    return {center - half, center + half};
  }
  Obb<N, T> obb() { return {point(2), size(), axes()}; }
  Capsule<N, T> capsule() { return {point(2), point(2), number(0.1, 0.8)}; }

  template <class Make>
  auto many(const Make& make) {
    std::vector<decltype(make())> result;
    for (int i = 0; i < 1600; ++i) result.push_back(make());
    return result;
  }

 private:
  std::mt19937 random_{7};
};

template <Dim N, class T>
void expect_most_settled(double share) {
  Room<N, T> room;
  const auto spheres = room.many([&] { return room.sphere(); });
  const auto others = room.many([&] { return room.sphere(); });
  const auto boxes = room.many([&] { return room.aabb(); });
  const auto other_boxes = room.many([&] { return room.aabb(); });
  const auto turned = room.many([&] { return room.obb(); });
  const auto other_turned = room.many([&] { return room.obb(); });
  const auto capsules = room.many([&] { return room.capsule(); });
  const auto other_capsules = room.many([&] { return room.capsule(); });
  EXPECT_GE(settled_share(TouchKind::sphere_sphere, spheres, others), share);
  EXPECT_GE(settled_share(TouchKind::sphere_aabb, spheres, boxes), share);
  EXPECT_GE(settled_share(TouchKind::sphere_obb, spheres, turned), share);
  EXPECT_GE(settled_share(TouchKind::sphere_capsule, spheres, capsules), share);
  EXPECT_GE(settled_share(TouchKind::aabb_aabb, boxes, other_boxes), 1);
  EXPECT_GE(settled_share(TouchKind::aabb_obb, boxes, turned), share);
  EXPECT_GE(settled_share(TouchKind::aabb_capsule, boxes, capsules), share);
  EXPECT_GE(settled_share(TouchKind::obb_capsule, turned, capsules), share);
  EXPECT_GE(settled_share(TouchKind::obb_obb, turned, other_turned), share);
  EXPECT_GE(settled_share(TouchKind::capsule_capsule, capsules, other_capsules), share);
}

TEST(TouchingKernels, SettleAllButAFewRandomPairsOfAThousand) {
  expect_most_settled<2, float>(0.997);
  expect_most_settled<3, float>(0.997);
  expect_most_settled<2, double>(0.997);
  expect_most_settled<3, double>(0.997);
}

/// Crates with equal orientation in a row, each overlapping the next by a hundredth of its size: no two edges cross, so
/// nine of fifteen axes are degenerate.
TEST(TouchingKernels, SettleCratesInARow) {
  std::vector<Obb<3>> crates;
  std::vector<Obb<3>> others;
  Room<3, float> room;
  for (int i = 0; i < 160; ++i) {
    const Mat<3, float> axes = room.axes();
    const Vec<3, float> place = room.point(30);
    crates.push_back({place, {1, 2, 0.5F}, axes});
    others.push_back({place + axes[0] * (i % 2 == 0 ? 1.98F : 2.02F), {1, 2, 0.5F}, axes});
  }
  EXPECT_EQ(settled_share(TouchKind::obb_obb, crates, others), 1);
}

/// The number of pairs that a list's kernel leaves undecided. Certain verdicts must be right.
template <Dim N, class T>
std::size_t left_open(TouchListKernel<T> kernel, const std::vector<Obb<N, T>>& boxes, const std::vector<Pair>& pairs) {
  std::vector<GroupVerdict> verdicts(pairs.size() / touch_group);
  kernel(reinterpret_cast<const T*>(boxes.data()), pairs.data(), verdicts.size(), verdicts.data());
  std::size_t open = 0;
  for (std::size_t i = 0; i < verdicts.size() * touch_group; ++i) {
    const std::uint32_t bit = 1U << i % touch_group;
    const GroupVerdict& verdict = verdicts[i / touch_group];
    const Relation truth = relation(boxes[pairs[i].a], boxes[pairs[i].b]);
    if ((verdict.apart & bit) != 0) {
      EXPECT_EQ(truth, Relation::apart) << "pair " << i;
    } else if ((verdict.overlapping & bit) != 0) {
      EXPECT_EQ(truth, Relation::overlapping) << "pair " << i;
    } else {
      ++open;
    }
  }
  return open;
}

/// The first leaves pairs that touch within the greatest skew of axes; the second leaves hardly any.
template <Dim N, class T>
void expect_two_kernels_for_oriented_boxes() {
  Room<N, T> room;
  const auto boxes = room.many([&] { return room.obb(); });
  std::vector<Pair> pairs;
  for (std::uint32_t step = 1; step <= 4; ++step) {
    for (std::uint32_t i = 0; i + 4 < boxes.size(); ++i) pairs.push_back({i, i + step});
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    const TouchingKernels<T>& kernels = touching_kernels<N, T>();
    const std::size_t open = left_open(kernels.of_obbs, boxes, pairs);
    EXPECT_GT(open, pairs.size() / 500) << hwy::TargetName(target);
    EXPECT_LT(open, pairs.size() / 25) << hwy::TargetName(target);
    EXPECT_LT(left_open(kernels.of_open_obbs, boxes, pairs), pairs.size() / 500) << hwy::TargetName(target);
  }
}

TEST(TouchingKernels, LeaveFewOrientedBoxesToTheSecondKernelAndHardlyAnyToNone) {
  expect_two_kernels_for_oriented_boxes<2, float>();
  expect_two_kernels_for_oriented_boxes<3, float>();
  expect_two_kernels_for_oriented_boxes<2, double>();
  expect_two_kernels_for_oriented_boxes<3, double>();
}

TEST(TouchingKernels, KeepTheOverlappingPairsInTheirOrder) {
  std::mt19937 random(11);
  std::vector<Pair> pairs(20 * touch_group);
  std::vector<GroupVerdict> verdicts(20);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) pairs[i] = {i, 1000 + i};
  for (GroupVerdict& verdict : verdicts) verdict.overlapping = static_cast<std::uint16_t>(random());
  verdicts[3].overlapping = 0xFFFF;
  verdicts[4].overlapping = 0;
  std::vector<Pair> expected;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if ((verdicts[i / touch_group].overlapping >> i % touch_group & 1U) != 0) expected.push_back(pairs[i]);
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    std::vector<Pair> kept(pairs.size());
    kept.resize(touching_kernels<3, float>().keep(pairs.data(), verdicts.data(), verdicts.size(), kept.data()));
    EXPECT_EQ(kept, expected) << hwy::TargetName(target);
  }
}

}  // namespace
}  // namespace graze::detail::touch_kernels_test
