// SPDX-License-Identifier: MIT
// What the filter decides is correct, and for a camera's frustum it decides everything that matters.
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/index/frustum_filter.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/intersects.hpp>

#include "cameras.hpp"

namespace graze::frustum_filter_test {
namespace {

using detail::FrustumFilter;
using detail::RegionProbe;
using Box = Aabb<3, double>;
using V3 = Vec<3, double>;

/// From a square of size 2 at z = 1 to one of size 20 at z = 10: what an eye at the origin sees upwards.
const Frustum<3, double> upwards{
    {{{-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {-10, -10, 10}, {10, -10, 10}, {-10, 10, 10}, {10, 10, 10}}}};

TEST(FrustumFilter, PartsBoxesBesideFacesAndEdges) {
  const FrustumFilter<3> filter(upwards);
  const auto part = [&filter](const V3& center, double half) {
    return filter.part(Box::from_center(center, V3(half)), 0);
  };
  EXPECT_FALSE(part({0, 0, 5}, 1));
  EXPECT_TRUE(part({0, 0, 12}, 1));    // beyond the far plane, but only by the box's bounds
  EXPECT_FALSE(part({0, 0, 11}, 1));   // touches it
  EXPECT_TRUE(part({7.1, 0, 5}, 1));   // its nearest corner, (6.1, _, 6), is beside the plane x = z
  EXPECT_FALSE(part({6.9, 0, 5}, 1));  // (5.9, _, 6) is not
  EXPECT_TRUE(part({-7.1, 0, 5}, 1));
  EXPECT_TRUE(part({0, 7.1, 5}, 1));
  EXPECT_FALSE(filter.part(Box::from_center({7.1, 0, 5}, V3(1)), 0.1));  // by less than the slack
}

TEST(FrustumFilter, PartsABoxThatOnlyAnEdgeParts) {
  // Rotated by 45 degrees about z: |x| + |y| <= sqrt(2) z. Up to z = 6, x is below 8.5.
  Frustum<3, double> turned = upwards;
  const double root = std::sqrt(0.5);
  for (V3& corner : turned.corners) corner = {root * (corner.x - corner.y), root * (corner.x + corner.y), corner.z};
  const Box box{{10, -20, 0}, {30, 20, 6}};
  // Inside the bounds, and partly behind the plane of every face.
  ASSERT_FALSE(intersects(turned, box));
  EXPECT_TRUE(FrustumFilter<3>(turned).part(box, 0));
}

TEST(FrustumFilter, FindsAPointThatIsShared) {
  const FrustumFilter<3> filter(upwards);
  const auto share = [&filter](const V3& center, double half) {
    return filter.share_point(Box::from_center(center, V3(half)), 1e-9);
  };
  EXPECT_TRUE(share({0, 0, 5}, 0.5));
  EXPECT_TRUE(share({4.9, -4.9, 5}, 0.5));
  EXPECT_TRUE(share({5.4, 0, 5}, 0.5));  // its center is not inside
  EXPECT_FALSE(share({5.6, 0, 5}, 0.5));
  EXPECT_FALSE(share({4.9, -4.9, 5}, 0));  // a point leaves no margin
  EXPECT_FALSE(share({0, 0, 11}, 0.5));
}

TEST(FrustumFilter, OfAPyramidAndOfAPointIsRightToo) {
  Frustum<3, double> pyramid = upwards;
  for (std::size_t k = 0; k < 4; ++k) pyramid.corners[k] = V3(0);
  const FrustumFilter<3> filter(pyramid);
  EXPECT_FALSE(filter.part(Box{{-1, -1, -1}, {0, 0, 0}}, 0));
  EXPECT_TRUE(filter.part(Box{{3, -1, 0}, {4, 1, 2}}, 0));
  EXPECT_TRUE(filter.share_point(Box{{-1, -1, 1}, {1, 1, 2}}, 1e-9));
  Frustum<3, double> point;
  point.corners.fill(V3(1, 2, 3));
  EXPECT_FALSE(FrustumFilter<3>(point).part(Box{{0, 0, 0}, {5, 5, 5}}, 0));
  EXPECT_FALSE(FrustumFilter<3>(point).share_point(Box{{0, 0, 0}, {5, 5, 5}}, 1e-9));  // undecided
  EXPECT_TRUE((RegionProbe<Frustum<3, double>>(point).meets(Box{{0, 0, 0}, {5, 5, 5}})));
  EXPECT_FALSE((RegionProbe<Frustum<3, double>>(point).meets(Box{{0, 0, 0}, {5, 5, 2.9}})));
}

/// The probe agrees with `intersects`; the fast test accepts few boxes that are not nearly met.
template <Dim N, class T>
void check_probe(bool is_odd) {
  const test::Source<N, T> from = test::draw_source<N, T>();
  const Frustum<N, T> frustum = is_odd ? test::any_odd_frustum<N, T>(from) : test::any_frustum<N, T>(from);
  const Aabb<N, T> box = test::Entry<Aabb<N, T>>::draw(from);
  if (!is_valid(frustum)) return;
  RC_LOG() << test::to_source(frustum) << " " << test::to_source(box) << "\n";
  const RegionProbe<Frustum<N, T>> probe(frustum);
  const RegionProbe<Inflated<Frustum<N, T>>> inflated(Inflated<Frustum<N, T>>{frustum});
  const bool is_met = intersects(frustum, box);
  RC_CLASSIFY(is_met, "met");
  RC_ASSERT(probe.meets(box) == is_met);
  RC_ASSERT(!is_met || inflated.meets(box));
  Aabb<N, T> larger = box;
  larger.grow(*from.point);
  RC_ASSERT(!is_met || (probe.may_meet(larger) && probe.may_meet_closely(larger)));
}

TEST(FrustumFilter, LetsTheProbeSayWhatIntersectsSays) {
  for (const bool is_odd : {false, true}) {
    test::check_property([is_odd] { check_probe<2, float>(is_odd); });
    test::check_property([is_odd] { check_probe<2, double>(is_odd); });
    test::check_property([is_odd] { check_probe<3, float>(is_odd); });
    test::check_property([is_odd] { check_probe<3, double>(is_odd); });
  }
}

/// With small integers, where faces are flat: boxes that seem to meet do so up to the slack.
RC_GTEST_PROP(FrustumFilter, PartsAllThatACameraDoesNotSee, ()) {
  const auto whole = [] { return *rc::gen::inRange(-40, 41) / 4.0; };
  Frustum<3, double> frustum = upwards;
  const double width = *rc::gen::element(0.25, 1.0, 3.0);
  const int turn = *rc::gen::inRange(0, 4);
  for (V3& corner : frustum.corners) {
    corner.x *= width;
    if (turn == 1) corner = {corner.x * 0.6 - corner.z * 0.8, corner.y, corner.x * 0.8 + corner.z * 0.6};
    if (turn > 1) corner = {corner.x * 0.6 - corner.y * 0.8, corner.x * 0.8 + corner.y * 0.6, corner.z};
    if (turn == 3) corner = {corner.z, corner.x, corner.y};
  }
  const Box box = Box::from_corners({whole(), whole(), whole()}, {whole(), whole(), whole()});
  RC_LOG() << test::to_source(frustum) << " " << test::to_source(box) << "\n";
  const bool looks_met = RegionProbe<Inflated<Frustum<3, double>>>(Inflated<Frustum<3, double>>{frustum}).meets(box);
  const double distance = closest_points(frustum, box).distance;
  RC_CLASSIFY(looks_met, "looks met");
  RC_ASSERT(looks_met == (distance < 1e-11));
}

template <class Index>
void check_index(const std::vector<Box>& boxes) {
  Index index;
  std::vector<bool> expected;
  for (const Box& box : boxes) {
    index.insert(box);
    expected.push_back(intersects(upwards, box));
  }
  std::vector<bool> found(boxes.size(), false);
  index.query(upwards, [&found](const Key& key) { found[key.index] = true; });
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(FrustumFilter, EveryIndexFindsWhatTheFrustumMeets, ()) {
  const auto whole = [] { return *rc::gen::inRange(-24, 25) / 2.0; };
  std::vector<Box> boxes(static_cast<std::size_t>(*rc::gen::inRange(0, 60)));
  for (Box& box : boxes) box = Box::from_center({whole(), whole(), whole()}, V3(*rc::gen::element(0.0, 0.5, 2.0)));
  check_index<BruteForce<3, double>>(boxes);
  check_index<Octree<double>>(boxes);
  check_index<Bvh<3, double>>(boxes);
}

}  // namespace
}  // namespace graze::frustum_filter_test
