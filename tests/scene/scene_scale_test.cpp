// SPDX-License-Identifier: MIT
// Scale invariance of scenes: objects scaled by 2^k have the same pairs, hits and neighbours, from the smallest numbers
// to the largest ones.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/random/linear_congruential.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/scene/scene.hpp>

#include "broad/same_manifolds.hpp"
#include "catalogue.hpp"
#include "query/scaled_shapes.hpp"

namespace graze::test::scene_scale_test {
namespace {

template <class T>
constexpr auto exponents() {
  if constexpr (std::is_same_v<T, float>) {
    return std::array{-140, -126, -60, 60, 100, 118};
  } else {
    return std::array{-1060, -1022, -600, -120, 120, 600, 1012};
  }
}

template <class Space>
class SceneScale : public testing::Test {};
TYPED_TEST_SUITE(SceneScale, Spaces);

/// Spheres, boxes, capsules and triangles in quarters, from -16 to 16, above a floor.
template <Dim N, class T>
std::vector<AnyShape<N, T>> shapes_above_a_floor() {
  detail::LinearCongruential random(11);
  const auto quarters = [&](std::size_t below) { return static_cast<T>(random.below(below)) / 4; };
  const auto point = [&] {
    Vec<N, T> v;
    for (Dim i = 0; i < N; ++i) v[i] = quarters(128) - 16;
    return v;
  };
  std::vector<AnyShape<N, T>> shapes = {HalfSpace<N, T>{unit_axis<N, T>(N - 1), T(-14)}};
  for (int i = 0; i < 60; ++i) {
    const Vec<N, T> at = point();
    shapes.push_back(Sphere<N, T>{at, quarters(16)});
    shapes.push_back(Aabb<N, T>::from_corners(at, at + (point() + T(16)) / T(8)));
    shapes.push_back(Capsule<N, T>{point(), at, quarters(8)});
    shapes.push_back(Triangle<N, T>{at, point(), point()});
  }
  return shapes;
}

template <Dim N, class T>
Scene<N, T> scene_of(const std::vector<AnyShape<N, T>>& shapes, int exponent) {
  Scene<N, T> scene;
  for (const AnyShape<N, T>& shape : shapes) scene.add(scaled<N, T>(shape, exponent));
  return scene;
}

template <Dim N, class T>
std::vector<std::array<std::uint32_t, 2>> numbers_of(const std::vector<ObjectPair>& pairs) {
  std::vector<std::array<std::uint32_t, 2>> numbers;
  for (const auto& [a, b] : pairs) numbers.push_back({a.index, b.index});
  return numbers;
}

/// The hits of a ray, by number, and their times.
template <Dim N, class T>
std::vector<std::pair<std::uint32_t, T>> hits_in(const Scene<N, T>& scene, int exponent) {
  std::vector<std::pair<std::uint32_t, T>> hits;
  Vec<N, T> direction(T(1));
  direction[0] = 2;
  const Ray<N, T> ray{scaled<N, T>(Vec<N, T>(T(-12)), exponent), scaled<N, T>(direction, exponent)};
  for (const auto& hit : scene.ray_cast_all(ray)) hits.push_back({hit.id.index, hit.hit.t});
  return hits;
}

/// The objects near a point, by number, and their distances in units of 2^exponent.
template <Dim N, class T>
std::vector<std::pair<std::uint32_t, T>> near_in(const Scene<N, T>& scene, int exponent) {
  std::vector<std::pair<std::uint32_t, T>> near;
  for (const auto& object : scene.nearest(scaled<N, T>(Vec<N, T>(T(3)), exponent), 20)) {
    near.push_back({object.id.index, scaled(object.distance, -exponent)});
  }
  return near;
}

TYPED_TEST(SceneScale, PairsContactsAndHitsAreTheSameAtEitherEndOfTheNumbers) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto shapes = shapes_above_a_floor<N, T>();
  Scene<N, T> scene = scene_of<N, T>(shapes, 0);
  const auto pairs = numbers_of<N, T>(scene.pairs());
  const auto hits = hits_in<N, T>(scene, 0);
  const auto near = near_in<N, T>(scene, 0);
  EXPECT_GT(pairs.size(), 10U);
  EXPECT_GT(hits.size(), 2U);
  for (const int exponent : exponents<T>()) {
    SCOPED_TRACE("times 2^" + std::to_string(exponent));
    Scene<N, T> large = scene_of<N, T>(shapes, exponent);
    EXPECT_EQ((numbers_of<N, T>(large.pairs())), pairs);
    EXPECT_EQ((hits_in<N, T>(large, exponent)), hits);
    // Distances among the smallest numbers have few bits, so many are equal.
    if (exponent > -std::numeric_limits<T>::max_exponent + 20) {
      EXPECT_EQ((near_in<N, T>(large, exponent)), near);
    }
    for (const auto& contact : large.contacts()) {
      EXPECT_TRUE(same_manifolds(contact.manifold,
                                 manifold(large.object(contact.pair.a).shape, large.object(contact.pair.b).shape)));
    }
    large.update();
    EXPECT_EQ((numbers_of<N, T>(large.pairs())), pairs);
  }
}

}  // namespace
}  // namespace graze::test::scene_scale_test
