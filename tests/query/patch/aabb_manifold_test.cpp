// SPDX-License-Identifier: MIT
// The manifold of two AABBs against that of any two faces.
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include <graze/query/manifold.hpp>
#include <graze/query/patch/aabb_manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::aabb_manifold_test {
namespace {

TEST(AabbManifold, InSpaceIsTheRectangleThatTheFacesShare) {
  const Aabb<3, double> floor{{0, 0, 0}, {10, 1, 10}};
  const Aabb<3, double> crate{{8, 0.75, 2}, {12, 3, 4}};
  const auto found = manifold(floor, crate);
  ASSERT_EQ(found.size, 4U);
  EXPECT_EQ(found.normal, (Vec<3, double>(0, 1, 0)));
  const bool is_floor_first = is_in_order(floor, crate);
  for (const auto& point : found.contacts()) {
    EXPECT_EQ(point.depth, 0.25);
    EXPECT_EQ(point.point_a.y, 1);
    EXPECT_EQ(point.point_b.y, 0.75);
    EXPECT_TRUE(point.point_a.x == 8 || point.point_a.x == 10);
    EXPECT_TRUE(point.point_a.z == 2 || point.point_a.z == 4);
    // The crate's corners at x = 8 are on the floor's top; at x = 10 the floor's edge crosses two of the crate's.
    const bool is_corner = point.point_a.x == 8;
    EXPECT_EQ(point.id.a.kind, is_corner ? FeatureKind::face : FeatureKind::edge) << is_floor_first;
    EXPECT_EQ(point.id.b.kind, is_corner ? FeatureKind::vertex : FeatureKind::edge);
  }
}

TEST(AabbManifold, OfBoxesOfOneSizeStaysWhileTheyHardlyMove) {
  const Aabb<3, double> low{{0, 0, 0}, {1, 1, 1}};
  Aabb<3, double> high{{0, 0, 0.99}, {1, 1, 2}};
  const auto before = manifold(low, high);
  high.min.x = 1e-15;
  high.max.y = 1 - 1e-15;
  const auto after = manifold(low, high);
  ASSERT_EQ(before.size, after.size);
  for (std::size_t i = 0; i < before.size; ++i) EXPECT_EQ(before.points[i].id, after.points[i].id);
}

// ---- Against any two faces

using Ids = std::tuple<int, std::uint32_t, int, std::uint32_t>;

template <Dim N>
std::map<Ids, Vec<N, double>> points_by_id(const WideManifold<N>& manifold) {
  std::map<Ids, Vec<N, double>> result;
  for (std::size_t i = 0; i < manifold.size; ++i) {
    const SurfacePair<N>& pair = manifold.pairs[i];
    result[{static_cast<int>(pair.feature_a.kind), pair.feature_a.index, static_cast<int>(pair.feature_b.kind),
            pair.feature_b.index}] = pair.point_a;
  }
  return result;
}

/// Coordinates that often coincide.
template <class T>
T place(double far) {
  const double whole = static_cast<double>(*test::choice(5));
  return static_cast<T>(far +
                        (*test::choice(3) == 0 ? whole + static_cast<double>(*test::choice(1000)) / 1000 : whole));
}

template <Dim N, class T>
void expect_the_same() {
  int seen = 0;
  test::check_property([&] {
    const double far = *test::choice(4) == 0 ? 1e5 : 0;
    Aabb<N, T> a;
    Aabb<N, T> b;
    for (Dim i = 0; i < N; ++i) {
      a.min[i] = place<T>(far);
      a.max[i] = a.min[i] + place<T>(0);
      b.min[i] = place<T>(far);
      b.max[i] = b.min[i] + place<T>(0);
    }
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    RC_PRE(decide(a, b) != Relation::apart);
    ++seen;
    const WideManifold<N> quick = manifold_of_aabbs(a, b);
    const WideManifold<N> plain = manifold_of_found(a, b, penetration_in_order(a, b));
    const auto quick_points = points_by_id(quick);
    const auto plain_points = points_by_id(plain);
    RC_ASSERT(quick_points.size() == quick.size && quick_points.size() == plain_points.size());
    const double size = static_cast<double>(sum_abs(a.max - a.min) + sum_abs(b.max - b.min)) + far;
    for (const auto& [id, point] : plain_points) {
      RC_ASSERT(quick_points.count(id) == 1U);
      RC_ASSERT(max_abs(quick_points.at(id) - point) <= 64 * tolerance::epsilon * size);
    }
    const Vec<N, double> zero(0.0);
    if (!has_faces(relative_to(zero, a)) || !has_faces(relative_to(zero, b))) return;
    for (std::size_t i = 0; i < quick.size; ++i) {
      RC_ASSERT(quick.pairs[i].depth == quick.found.depth);
      const Vec<N, double> way = quick.pairs[i].point_a - quick.pairs[i].point_b;
      RC_ASSERT(dot(way, quick.found.normal) == quick.found.depth);
      RC_ASSERT(way - quick.found.normal * quick.found.depth == (Vec<N, double>(0.0)));
    }
  });
  EXPECT_GT(seen, 0);
}

TEST(AabbManifold, IsThatOfAnyTwoFaces) {
  expect_the_same<2, float>();
  expect_the_same<2, double>();
  expect_the_same<3, float>();
  expect_the_same<3, double>();
}

}  // namespace
}  // namespace graze::detail::aabb_manifold_test
