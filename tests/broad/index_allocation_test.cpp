// SPDX-License-Identifier: MIT
// Queries of an index do not allocate, whatever the region and the number of hits. Nor does a ray that meets fewer than
// a hundred boxes: its queue is on the stack up to that size. The nearest boxes are returned in a vector. This program
// counts the calls of operator new; other tests compare answers.
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>

#include "box_worlds.hpp"
#include "heap_watch.hpp"

namespace graze::test::index_allocation_test {
namespace {

/// The number of boxes in a set, and how often a list of 128 doubles its capacity to hold them and their cells.
constexpr std::size_t many = 2000;
constexpr std::size_t growths = 5;

/// Calls ask(index, boxes) for every set, with an index that contains its boxes.
template <class I>
void in_every_world(const auto& ask) {
  using Box = typename I::Box;
  for (const auto& world : box_worlds<dimension_of<Box>, scalar_of<Box>>(many, 5)) {
    SCOPED_TRACE(world.name);
    I index;
    for (const Box& box : world.boxes) {
      if (!is_nothing(box)) index.insert(box);
    }
    ask(index, world.boxes);
  }
}

/// Rays from one box in every so many to the next.
template <Dim N, class T>
std::vector<Ray<N, T>> rays_between(const std::vector<Aabb<N, T>>& boxes, std::size_t step) {
  std::vector<Ray<N, T>> rays;
  for (std::size_t k = 0; k + 1 < boxes.size(); k += step) {
    const Ray<N, T> ray{boxes[k].min, boxes[k + 1].min - boxes[k].min};
    if (is_valid(ray)) rays.push_back(ray);
  }
  return rays;
}

/// Finds all boxes that meet a region, or the first.
template <class I, class R>
void expect_none_asked(const I& index, const R& region) {
  std::size_t found = 0;
  EXPECT_EQ(requests_of([&] { index.query(region, [&found](Key) { ++found; }); }), 0U) << found << " were found";
  EXPECT_EQ(requests_of([&] { index.query(region, [](Key) { return false; }); }), 0U);
}

template <class I>
class IndexAllocation : public testing::Test {};
using Tested =
    testing::Types<Bvh<2, float>, Bvh<3, double>, QuadTree<double>, Octree<float>, Grid<2, float>, Grid<3, double>>;
TYPED_TEST_SUITE(IndexAllocation, Tested);

TYPED_TEST(IndexAllocation, IsNotNeededToFindWhatMeetsABox) {
  using Box = typename TypeParam::Box;
  in_every_world<TypeParam>([](const TypeParam& index, const std::vector<Box>& boxes) {
    for (std::size_t k = 0; k < boxes.size(); k += 29) expect_none_asked(index, boxes[k]);
    expect_none_asked(index, Box::everything());
    expect_none_asked(index, Box::nothing());
  });
}

TYPED_TEST(IndexAllocation, IsNotNeededToFindWhatMeetsAnotherRegion) {
  using Box = typename TypeParam::Box;
  constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;
  in_every_world<TypeParam>([](const TypeParam& index, const std::vector<Box>& boxes) {
    for (const Ray<N, T>& ray : rays_between(boxes, 199)) {
      const Vec<N, T> a = ray.origin;
      const Vec<N, T> b = ray.origin + ray.direction;
      expect_none_asked(index, a);
      expect_none_asked(index, ray);
      expect_none_asked(index, Segment<N, T>{a, b});
      expect_none_asked(index, Sphere<N, T>{a, T(5)});
      expect_none_asked(index, Capsule<N, T>{a, b, T(1)});
      Frustum<N, T> frustum;
      for (Vec<N, T>& corner : frustum.corners) corner = a + corner * T(5);
      expect_none_asked(index, frustum);
    }
  });
}

TYPED_TEST(IndexAllocation, IsNotNeededAlongARayThatMeetsFewerThanAHundred) {
  using Box = typename TypeParam::Box;
  in_every_world<TypeParam>([](const TypeParam& index, const std::vector<Box>& boxes) {
    for (const auto& ray : rays_between(boxes, 29)) {
      std::size_t hits = 0;
      const std::size_t asked = requests_of([&] { index.ray_cast(ray, [&hits](Key, double) { ++hits; }); });
      const std::size_t asked_for_one = requests_of([&] { index.ray_cast(ray, [](Key, double) { return false; }); });
      const std::size_t allowed = hits < 100 ? 0 : growths;
      EXPECT_LE(asked, allowed) << hits << " hits";
      EXPECT_LE(asked_for_one, allowed) << hits << " hits";
    }
  });
}

TYPED_TEST(IndexAllocation, IsThatOfTheAnswerAndLittleMoreForTheNearest) {
  using Box = typename TypeParam::Box;
  in_every_world<TypeParam>([](const TypeParam& index, const std::vector<Box>& boxes) {
    for (std::size_t k = 0; k < boxes.size(); k += 29) {
      if (!is_finite(boxes[k].min)) continue;
      for (const std::size_t wanted : {1U, 8U, 100U}) {
        const std::size_t asked = requests_of([&] { (void)index.nearest(boxes[k].min, wanted); });
        EXPECT_GE(asked, 1U);
        EXPECT_LE(asked, 1 + growths) << wanted;
      }
      EXPECT_EQ(requests_of([&] { (void)index.nearest(boxes[k].min, 0); }), 0U);
    }
  });
}

template <class I>
void expect_only_the_answer() {
  in_every_world<I>([](const I& index, const auto& boxes) {
    for (std::size_t k = 0; k < boxes.size(); k += 29) {
      if (!is_finite(boxes[k].min)) continue;
      EXPECT_EQ(requests_of([&] { (void)index.nearest(boxes[k].min, 8); }), 1U);
      EXPECT_EQ(requests_of([&] { (void)index.nearest(boxes[k].min, 100); }), 1U);
    }
  });
}

TEST(BvhAllocation, IsThatOfTheAnswerForTheNearest) {
  expect_only_the_answer<Bvh<2, double>>();
  expect_only_the_answer<Bvh<3, float>>();
}

TEST(HeapCount, SeesWhatIsAsked) {
  EXPECT_GT(requests_of([] { EXPECT_EQ(std::string(1000, 'x').size(), 1000U); }), 0U);
}

}  // namespace
}  // namespace graze::test::index_allocation_test
