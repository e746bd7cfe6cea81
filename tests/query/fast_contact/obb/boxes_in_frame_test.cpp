// SPDX-License-Identifier: MIT
// The fast contact of an AABB and an oriented box against the general method for boxes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/obb/boxes_in_frame.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

#ifdef GRAZE_HAS_LANES

namespace graze::detail::seen_boxes_test {
namespace {

using V3 = Vec<3, double>;

TEST(ObbAndAabbInFrame, IsSeenFromTheOrientedOne) {
  const Aabb<3, double> box{{1e6, 0, 0}, {1e6 + 2, 4, 6}};
  const Obb<3, double> other{{1e6 + 8, 1, 1}, {1, 2, 3}, rotation_matrix(V3(0, 0, 1), 30)};
  const ObbAndAabbInFrame<double> seen(other, box);
  EXPECT_EQ(seen.origin(), other.center);
  EXPECT_EQ(seen.first().center, V3(0.0));
  EXPECT_EQ(seen.second().center, V3(-7, 1, 2));
  EXPECT_EQ(seen.second().half_extents, V3(1, 2, 3));
  EXPECT_TRUE(seen.are_apart_for_certain());
}

TEST(SeenInOrder, HasTheOrientedBoxFirst) {
  const Aabb<3, float> box{{0, 0, 0}, {2, 2, 2}};
  const Obb<3, float> other{{1, 1, 2.5F}, {1, 1, 1}, Mat<3, float>(rotation_matrix(V3(0, 0, 1), 45))};
  const auto one = manifold(box, other);
  const auto turned = manifold(other, box);
  ASSERT_EQ(one.size, 4U);
  ASSERT_EQ(turned.size, 4U);
  EXPECT_EQ(one.normal, (Vec<3, float>(0, 0, 1)));
  EXPECT_EQ(turned.normal, -one.normal);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(one.points[i].point_a, turned.points[i].point_b);
    EXPECT_EQ(one.points[i].id.a, turned.points[i].id.b);
    EXPECT_EQ(one.points[i].depth, 0.5F);
  }
}

// ---- Against the general method for boxes

enum class Kind { any, stacked, flat, far };

struct Drawn {
  Aabb<3, double> box;
  Obb<3, double> other;
};

Drawn draw(Kind kind) {
  const auto share = [] { return static_cast<double>(*test::choice(1001)) / 1000; };
  const auto place = [&] { return V3(share(), share(), share()); };
  const V3 center = place() * (kind == Kind::far ? 1e6 : 1.0);
  const V3 half = place() + 0.1;
  const V3 axis = place() - 0.5;
  Drawn result{{center - half, center + half}, {center + (place() - 0.5) * 2.0, place() + 0.1}};
  result.other.axes = rotation_matrix(length(axis) > 0.1 ? axis : V3(1, 0, 0), 360 * share());
  if (kind == Kind::flat) result.other.half_extents[static_cast<Dim>(*test::choice(3))] = 0;
  if (kind == Kind::stacked) {
    result.other.axes = rotation_matrix(V3(0, 0, 1), 90 * static_cast<double>(*test::choice(5)) * share());
    result.other.center.z = center.z + half.z + result.other.half_extents.z - 0.01;
  }
  return result;
}

template <class T>
void expect_the_same(Kind kind) {
  int seen = 0;
  test::check_property([&] {
    const Drawn drawn = draw(kind);
    const Aabb<3, T> a{Vec<3, T>(drawn.box.min), Vec<3, T>(drawn.box.max)};
    const Obb<3, T> b{Vec<3, T>(drawn.other.center), Vec<3, T>(drawn.other.half_extents), Mat<3, T>(drawn.other.axes)};
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const auto quick = contact(a, b);
    const auto points = manifold(a, b);
    const bool is_apart = decide(a, b) == Relation::apart;
    RC_ASSERT(quick.has_value() == !is_apart);
    RC_ASSERT((points.size == 0) == is_apart);
    RC_PRE(!is_apart);
    ++seen;
    const V3 origin = reference(b);
    const auto local_a = relative_to(origin, a);
    const auto local_b = relative_to(origin, b);
    const BoxesContact<3> plain = contact_of_boxes(local_b, local_a);
    const double error = quick->error + plain.found.error;
    const double ulp = static_cast<double>(std::numeric_limits<T>::epsilon());
    RC_ASSERT(std::fabs(static_cast<double>(quick->depth) - plain.found.depth) <= error + ulp * plain.found.depth);
    RC_ASSERT(points.normal == quick->normal);
    // Another axis may be as good.
    if (max_abs(V3(quick->normal) + plain.found.normal) > 1e-9 + ulp) return;
    const SurfacePairs<3> pairs = pairs_of_boxes(local_b, local_a, plain);
    if (pairs.size() <= 4) {
      RC_ASSERT(points.size == pairs.size());
    } else {
      RC_ASSERT(points.size >= 2U);  // one may be chosen twice
    }
    const double allowed = 8 * error + 4 * ulp * static_cast<double>(max_abs(b.center) + 2);
    for (const auto& point : points.contacts()) {
      const auto same = std::find_if(pairs.begin(), pairs.end(), [&](const SurfacePair<3>& pair) {
        return ContactId{pair.feature_b, pair.feature_a} == point.id;
      });
      RC_ASSERT(same != pairs.end());
      RC_ASSERT(max_abs(V3(point.point_a) - (same->point_b + origin)) <= allowed);
      RC_ASSERT(std::fabs(static_cast<double>(point.depth) - same->depth) <= allowed);
    }
  });
  EXPECT_GT(seen, 0);
}

TEST(ObbAndAabbInFrame, TouchAsAllBoxesDo) {
  for (const Kind kind : {Kind::any, Kind::stacked, Kind::flat, Kind::far}) {
    expect_the_same<float>(kind);
    expect_the_same<double>(kind);
  }
}

}  // namespace
}  // namespace graze::detail::seen_boxes_test

#endif
