// SPDX-License-Identifier: MIT
// A probe agrees with `intersects`, and prunes nothing that `intersects` accepts.
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/index/region.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"
#include "unbounded_compound.hpp"

namespace graze::region_test {
namespace {

using detail::RegionProbe;

/// The box, and a larger one.
template <Dim N, class T>
Aabb<N, T> around(Aabb<N, T> box, const Vec<N, T>& point) {
  box.grow(point);
  return box;
}

template <class R>
void expect_sound(const R& region, const Aabb<dimension_of<R>, scalar_of<R>>& box,
                  const Vec<dimension_of<R>, scalar_of<R>>& corner) {
  const RegionProbe<R> probe(region);
  RC_ASSERT(probe.meets(box) == intersects(region, box));
  if (!probe.meets(box)) return;
  const auto larger = around(box, corner);
  RC_ASSERT(probe.may_meet(box) && probe.may_meet_closely(box));
  RC_ASSERT(probe.may_meet(larger) && probe.may_meet_closely(larger));
  RC_ASSERT(boxes_overlap(probe.reach(detail::finite_size(larger)), box));
  RC_ASSERT(boxes_overlap(probe.reach(detail::finite_size(larger)), larger));
}

/// No shape that touches an inflated region has a box that is missed.
template <class R, class S>
void check_generous_region() {
  EXPECT_TRUE(rc::check([] {
    const auto [region, shape] = *test::any_pair<R, S>();
    if (!intersects(region, shape)) return;
    const Inflated<R> inflated{region};
    const RegionProbe<Inflated<R>> probe(inflated);
    RC_ASSERT(probe.meets(bounds(shape)));
    RC_ASSERT(probe.may_meet(bounds(shape)));
    RC_ASSERT(boxes_overlap(probe.reach(detail::finite_size(bounds(shape))), bounds(shape)));
  }));
}

TEST(Region, AGenerousOneIsMetByTheBoxesOfAllThatTouchesIt) {
  check_generous_region<Segment<2, double>, Ray<2, double>>();
  check_generous_region<Sphere<3, float>, Triangle<3, float>>();
  check_generous_region<Obb<3, double>, Obb<3, double>>();
  // Separate by just more than the rounding of boxes, but within the band of the pair.
  const Segment<2, double> region{{-1, 0}, {0, 0}};
  const Ray<2, double> ray{{0x1p-52, 0}, {1, 0}};
  ASSERT_TRUE(intersects(region, ray));
  const RegionProbe<Aabb<2, double>> strict(bounds(region));
  const RegionProbe<Inflated<Segment<2, double>>> inflated(Inflated<Segment<2, double>>{region});
  EXPECT_FALSE(strict.meets(bounds(ray)));
  EXPECT_TRUE(inflated.meets(bounds(ray)));
  EXPECT_FALSE(inflated.meets({{0x1p-30, 0}, {1, 1}}));
}

TEST(Region, OfACompoundThatIsNotBoundedMeetsWhatAFarPartOfItTouches) {
  using Any = AnyShape<2, double>;
  const Aabb<2, double> below{{-1e30, -1}, {1.5e33, 0}};
  for (const Any& far : test::far_shapes<2, double>()) {
    ASSERT_TRUE(intersects(far, test::along_x<2, double>()));
    const Any region = test::beside_a_plane<2, double>(far);
    const RegionProbe<Any> strict(region);
    EXPECT_EQ(strict.meets(below), intersects(region, below));
    const RegionProbe<Inflated<Any>> inflated(Inflated<Any>{region});
    const auto box = bounds(test::along_x<2, double>());
    EXPECT_TRUE(inflated.may_meet(box));
    EXPECT_TRUE(inflated.meets(box));
    EXPECT_TRUE(boxes_overlap(inflated.reach(detail::finite_size(box)), box));
  }
}

template <class R>
void check_region() {
  constexpr Dim N = dimension_of<R>;
  using T = scalar_of<R>;
  EXPECT_TRUE(rc::check([] {
    const auto [region, box] = *test::any_pair<R, Aabb<N, T>>();
    expect_sound<R>(region, box, *test::any<Vec<N, T>>());
  }));
}

TEST(Region, SaysWhatIntersectsSaysInThePlane) {
  check_region<Aabb<2, double>>();
  check_region<Sphere<2, float>>();
  check_region<Sphere<2, double>>();
  check_region<Obb<2, double>>();
  check_region<Ray<2, float>>();
}

TEST(Region, SaysWhatIntersectsSaysInSpace) {
  check_region<Aabb<3, float>>();
  check_region<Sphere<3, double>>();
  check_region<Obb<3, float>>();
  check_region<Obb<3, double>>();
  check_region<Capsule<3, float>>();
  check_region<Polytope<3, double>>();
  check_region<Plane<3, double>>();
  check_region<HalfSpace<3, float>>();
}

RC_GTEST_PROP(Region, MayBeAUsersShape, ()) {
  const auto [egg_box, box] = *test::any_pair<Aabb<3, float>, Aabb<3, float>>();
  const user::Ellipsoid<float> egg{egg_box.center(), egg_box.half_extents() + 0.01F};
  expect_sound(egg, box, *test::any<Vec<3, float>>());
}

template <class R>
void expect_refused(const R& region) {
  EXPECT_THROW(RegionProbe<R>{region}, std::invalid_argument);
}

TEST(Region, RefusesNonsense) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  expect_refused(Aabb<2>{{0, nan}, {1, 1}});
  expect_refused(Sphere<2>{{0, 0}, -1});
  expect_refused(Sphere<2>{{nan, 0}, 1});
  expect_refused(Vec<2>(nan, 0));
  expect_refused(Ray<3>{{0, 0, 0}, {0, 0, 0}});
}

TEST(Region, OfABoxWithInfiniteSidesThePartNearTheRegionCounts) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Aabb<2, double> quarter{{1, 1}, {infinity, infinity}};
  const auto meets = [&quarter](const auto& region) {
    return RegionProbe<std::remove_cvref_t<decltype(region)>>(region).meets(quarter);
  };
  EXPECT_TRUE(meets(Sphere<2, double>{{0, 0}, 1.5}));
  EXPECT_FALSE(meets(Sphere<2, double>{{0, 0}, 1.4}));  // although their boxes overlap
  EXPECT_TRUE(meets(Sphere<2, double>{{1e9, 1e9}, 1}));
  EXPECT_FALSE(meets(Aabb<2, double>::nothing()));
  EXPECT_TRUE(meets(Aabb<2, double>::everything()));
  EXPECT_FALSE(meets(HalfSpace<2, double>{{0, 1}, 0.5}));
  EXPECT_TRUE(meets(HalfSpace<2, double>{{0, 1}, 1}));
  EXPECT_FALSE(meets(Compound<2, double>{}));
}

}  // namespace
}  // namespace graze::region_test
