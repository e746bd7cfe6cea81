// SPDX-License-Identifier: MIT
// Rays in a scene, compared with casting at every object.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/ray_cast.hpp>
#include <graze/scene/scene.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"

namespace graze::scene_ray_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using Way = Ray<2, double>;

std::vector<ObjectId> ids_of(const std::vector<ObjectHit<2, double>>& hits) {
  std::vector<ObjectId> ids;
  for (const auto& each : hits) ids.push_back(each.id);
  return ids;
}

/// With the face of a mesh.
template <Dim N, class T>
std::optional<MeshHit<N, T>> hit_of(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max) {
  if (const auto* const mesh = std::get_if<Mesh<N, T>>(&shape)) return ray_cast(*mesh, ray, t_max);
  const auto hit = ray_cast(shape, ray, t_max);
  return hit ? std::optional(MeshHit<N, T>{*hit}) : std::nullopt;
}

TEST(SceneRay, HitsObjectsInOrder) {
  World scene;
  const ObjectId far = scene.add(Ball{{9, 0}, 1});
  const ObjectId near = scene.add(Ball{{4, 0}, 1}, {.layer = 3});
  scene.add(Ball{{6, 1.5}, 1});
  const ObjectId behind_all = scene.add(HalfSpace<2, double>{{-1, 0}, -20});
  const Way ray{{0, 0}, {2, 0}};
  const auto first = scene.ray_cast(ray);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->id, near);
  EXPECT_EQ(first->hit.t, 1.5);
  EXPECT_EQ(first->hit.point, (Vec<2, double>(3, 0)));
  EXPECT_EQ(first->hit.normal, (Vec<2, double>(-1, 0)));
  EXPECT_EQ(ids_of(scene.ray_cast_all(ray)), (std::vector<ObjectId>{near, far, behind_all}));
  EXPECT_EQ(ids_of(scene.ray_cast_all(ray, 4)), (std::vector<ObjectId>{near, far}));
  EXPECT_EQ(scene.ray_cast(ray, 100, only_layer(0))->id, far);
  EXPECT_FALSE(scene.ray_cast(ray, 1));
  EXPECT_FALSE(scene.ray_cast(Way{{0, 0}, {-1, 0}}));
}

TEST(SceneRay, AmongEqualHitsTheLowestIdIsFirst) {
  World scene;
  const ObjectId first = scene.add(Aabb<2, double>{{2, -1}, {3, 1}});
  const ObjectId second = scene.add(Aabb<2, double>{{2, -5}, {9, 5}});
  const auto hits = scene.ray_cast_all(Way{{0, 0}, {1, 0}});
  EXPECT_EQ(ids_of(hits), (std::vector<ObjectId>{first, second}));
  EXPECT_EQ(scene.ray_cast(Way{{0, 0}, {1, 0}})->id, first);
  EXPECT_EQ(scene.ray_cast(Way{{2.5, 0}, {1, 0}})->hit.t, 0);  // from inside
}

TEST(SceneRay, HitsOfMeshesHaveAFace) {
  Scene<3, double> scene;
  const Mesh<3, double> box = test::box_mesh<double>({{2, -1, -1}, {4, 1, 1}});
  scene.add(box);
  const ObjectId ball = scene.add(Sphere<3, double>{{8, 0, 0}, 1});
  const Ray<3, double> ray{{0, 0.25, 0.5}, {1, 0, 0}};
  const auto hits = scene.ray_cast_all(ray);
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].hit, *ray_cast(box, ray));
  EXPECT_LT(hits[0].hit.face, box.faces().size());
  EXPECT_EQ(hits[1].id, ball);
  EXPECT_EQ(hits[1].hit.face, no_face);
  EXPECT_EQ(scene.ray_cast(ray)->hit, hits[0].hit);
  EXPECT_EQ(scene.ray_cast({{3, 0, 0}, {1, 0, 0}})->hit.face, no_face);
}

TEST(SceneRay, NonsenseIsRefused) {
  const World scene;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.ray_cast(Way{{0, 0}, {0, 0}}), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast(Way{{nan, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast(Way{{0, 0}, {1, 0}}, -1), std::invalid_argument);
  EXPECT_THROW(scene.ray_cast_all(Way{{0, 0}, {1, 0}}, nan), std::invalid_argument);
  EXPECT_FALSE(scene.ray_cast(Way{{0, 0}, {1, 0}}));
  EXPECT_TRUE(scene.ray_cast_all(Way{{0, 0}, {1, 0}}).empty());
}

template <Dim N, class T>
void check_against_every_object() {
  Scene<N, T> scene;
  for (const AnyShape<N, T>& shape : *test::some<AnyShape<N, T>>(12, test::any_shape<N, T>())) scene.add(shape);
  const Ray<N, T> ray = *test::any<Ray<N, T>>();
  const T t_max = *rc::gen::element(std::numeric_limits<T>::infinity(), T(1), T(0));
  std::vector<ObjectHit<N, T>> expected;
  for (const ObjectId id : scene.ids()) {
    RC_LOG() << test::to_source<N, T>(scene.object(id).shape) << "\n";
    if (const auto hit = hit_of(scene.object(id).shape, ray, t_max)) expected.push_back({id, *hit});
  }
  RC_LOG() << test::to_source(ray) << ", " << t_max << "\n";
  std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.hit.t < b.hit.t; });
  RC_ASSERT(scene.ray_cast_all(ray, t_max) == expected);
  const auto first = scene.ray_cast(ray, t_max);
  RC_ASSERT(first.has_value() == !expected.empty());
  if (first) RC_ASSERT(first->id == expected.front().id && first->hit.t == expected.front().hit.t);
}

/// A row of boxes that a ray passes at one corner each, as closely as T permits: for any t_max, exactly the hits up to
/// it are found.
template <Dim N, class T>
void check_that_t_max_hides_only_what_is_beyond() {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto vector = [&](double size) {
    Vec<N, T> v;
    for (Dim i = 0; i < N; ++i) v[i] = static_cast<T>(number(-size, size));
    return v;
  };
  const Ray<N, T> ray{vector(seed % 2 == 0 ? 1 : 1000), vector(1)};
  RC_PRE(max_abs(ray.direction) > T(0.01));
  Scene<N, T> scene;
  for (int i = 0; i < 40; ++i) {
    const Vec<N, T> corner(wide<N, T>(ray.origin) + wide<N, T>(ray.direction) * number(0, 20));
    const Vec<N, T> other = corner + vector(0.5);
    scene.add(Aabb<N, T>{min(corner, other), max(corner, other)});
  }
  const std::vector<ObjectHit<N, T>> all = scene.ray_cast_all(ray);
  for (const ObjectHit<N, T>& last : all) {
    for (const T t_max : {std::nextafter(last.hit.t, T(0)), last.hit.t, last.hit.t * T(1.25)}) {
      RC_LOG() << test::to_source(ray) << " up to " << t_max << "\n";
      const auto is_hidden = [t_max](const ObjectHit<N, T>& hit) { return hit.hit.t > t_max; };
      const std::vector<ObjectHit<N, T>> expected(all.begin(), std::find_if(all.begin(), all.end(), is_hidden));
      RC_ASSERT(scene.ray_cast_all(ray, t_max) == expected);
      const auto first = scene.ray_cast(ray, t_max);
      RC_ASSERT(first.has_value() == !expected.empty());
      if (first) RC_ASSERT(*first == all.front());
    }
  }
}

RC_GTEST_PROP(SceneRay, TMaxHidesOnlyWhatIsBeyond2f, ()) { check_that_t_max_hides_only_what_is_beyond<2, float>(); }
RC_GTEST_PROP(SceneRay, TMaxHidesOnlyWhatIsBeyond3f, ()) { check_that_t_max_hides_only_what_is_beyond<3, float>(); }
RC_GTEST_PROP(SceneRay, TMaxHidesOnlyWhatIsBeyond2d, ()) { check_that_t_max_hides_only_what_is_beyond<2, double>(); }
RC_GTEST_PROP(SceneRay, TMaxHidesOnlyWhatIsBeyond3d, ()) { check_that_t_max_hides_only_what_is_beyond<3, double>(); }

RC_GTEST_PROP(SceneRay, HitsWhatEveryObjectSays2f, ()) { check_against_every_object<2, float>(); }
RC_GTEST_PROP(SceneRay, HitsWhatEveryObjectSays3f, ()) { check_against_every_object<3, float>(); }
RC_GTEST_PROP(SceneRay, HitsWhatEveryObjectSays2d, ()) { check_against_every_object<2, double>(); }
RC_GTEST_PROP(SceneRay, HitsWhatEveryObjectSays3d, ()) { check_against_every_object<3, double>(); }

}  // namespace
}  // namespace graze::scene_ray_test
