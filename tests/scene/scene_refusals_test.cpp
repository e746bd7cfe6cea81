// SPDX-License-Identifier: MIT
// Input that a scene rejects: invalid shapes of every type, and more objects than it can hold. Each message states the
// fact, and nothing changes.
#include <cstdint>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/index/key_table.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "scene/scene_sight.hpp"

namespace graze::scene_refusals_test {
namespace {

/// The message of the exception, which must have that type.
template <class Error>
std::string message_of(const auto& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another error: ") + error.what();
  }
  return "no error";
}

/// An invalid shape, and the expected message.
template <Dim N, class T>
struct Faulty {
  AnyShape<N, T> shape;
  std::string words;
};

/// NaN in each field of every type that has fields, and their other defects.
template <Dim N, class T>
std::vector<Faulty<N, T>> faulty_shapes() {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Vec<N, T> zero(T(0));
  const Vec<N, T> one(T(1));
  Vec<N, T> hole = one;  // the last coordinate is NaN
  hole[N - 1] = nan;
  Vec<N, T> endless = one;
  endless[N - 1] = -infinity;
  Vec<N, T> below = one;  // in one coordinate only
  below[N - 1] = T(-1);
  const Mat<N, T> straight(T(1));
  Mat<N, T> torn = straight;
  torn[N - 1][0] = nan;
  return {
      {hole, "a point, has a coordinate that is not finite"},
      {endless, "a point, has a coordinate that is not finite"},
      {Segment<N, T>{hole, one}, "a segment, has a start that is not finite"},
      {Segment<N, T>{one, hole}, "a segment, has an end that is not finite"},
      {Ray<N, T>{hole, one}, "a ray, has an origin that is not finite"},
      {Ray<N, T>{one, hole}, "a ray, has a direction that is not finite"},
      {Ray<N, T>{one, zero}, "a ray, has a direction of length zero"},
      {Sphere<N, T>{hole, T(1)}, "a sphere, has a center that is not finite"},
      {Sphere<N, T>{one, nan}, "a sphere, has a radius that is not finite"},
      {Sphere<N, T>{one, infinity}, "a sphere, has a radius that is not finite"},
      {Sphere<N, T>{one, T(-1)}, "a sphere, has a negative radius"},
      {Aabb<N, T>{hole, one}, "an aabb, has a min that is not finite"},
      {Aabb<N, T>{zero, hole}, "an aabb, has a max that is not finite"},
      {Aabb<N, T>{endless, one}, "an aabb, has a min that is not finite"},
      {Aabb<N, T>{zero, below}, "an aabb, has a min above its max"},
      {Aabb<N, T>::nothing(), "an aabb, has a min that is not finite"},
      {Obb<N, T>{hole, one, straight}, "an obb, has a center that is not finite"},
      {Obb<N, T>{zero, hole, straight}, "an obb, has half_extents that are not finite"},
      {Obb<N, T>{zero, below, straight}, "an obb, has a negative half extent"},
      {Obb<N, T>{zero, one, torn}, "an obb, has axes that are not finite"},
      {Obb<N, T>{zero, one, Mat<N, T>(T(2))},
       "an obb, has axes that are not orthonormal (unit length, at right angles)"},
      {Plane<N, T>{hole, T(0)}, "a plane, has a normal that is not finite"},
      {Plane<N, T>{one, nan}, "a plane, has an offset that is not finite"},
      {Plane<N, T>{zero, T(0)}, "a plane, has a normal of length zero"},
      {HalfSpace<N, T>{hole, T(0)}, "a half_space, has a normal that is not finite"},
      {HalfSpace<N, T>{one, nan}, "a half_space, has an offset that is not finite"},
      {HalfSpace<N, T>{zero, T(0)}, "a half_space, has a normal of length zero"},
      {Triangle<N, T>{hole, one, zero}, "a triangle, has a corner that is not finite"},
      {Triangle<N, T>{one, hole, zero}, "a triangle, has a corner that is not finite"},
      {Triangle<N, T>{one, zero, hole}, "a triangle, has a corner that is not finite"},
      {Capsule<N, T>{hole, one, T(1)}, "a capsule, has an a that is not finite"},
      {Capsule<N, T>{one, hole, T(1)}, "a capsule, has a b that is not finite"},
      {Capsule<N, T>{one, zero, nan}, "a capsule, has a radius that is not finite"},
      {Capsule<N, T>{one, zero, T(-1)}, "a capsule, has a negative radius"},
      {Compound<N, T>{{{Sphere<N, T>{}, Aabb<N, T>{}}, {Sphere<N, T>{one, nan}, Aabb<N, T>{}}}},
       "a compound, has a part that is not valid"},
  };
}

template <class Space>
class SceneRefusals : public testing::Test {};
TYPED_TEST_SUITE(SceneRefusals, test::Spaces);

/// Two that touch, one of them new since the last update, and a slot to be reused.
template <Dim N, class T>
Scene<N, T> some_scene() {
  Scene<N, T> scene;
  scene.add(Sphere<N, T>{}, {.name = "ball", .layer = scene.layer("balls")});
  const ObjectId gone = scene.add(Sphere<N, T>{});
  scene.add(Sphere<N, T>{});
  scene.update();
  scene.remove(gone);
  return scene;
}

TYPED_TEST(SceneRefusals, AFaultyShapeIsNotAddedTheFactIsNamedAndNothingChanges) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Scene<N, T> scene = some_scene<N, T>();
  const test::SceneSight<N, T> before = test::ray_verdict_of(scene);
  for (const Faulty<N, T>& faulty : faulty_shapes<N, T>()) {
    const auto named = [&] { scene.add(faulty.shape, {.name = "bad"}); };
    EXPECT_EQ(message_of<std::invalid_argument>(named), "Scene: object \"bad\", " + faulty.words);
    const auto nameless = [&] { scene.add(faulty.shape); };
    EXPECT_EQ(message_of<std::invalid_argument>(nameless), "Scene: the object, " + faulty.words);
    EXPECT_TRUE(test::ray_verdict_of(scene) == before) << faulty.words;
    EXPECT_EQ(scene.find("bad"), std::nullopt);
  }
  // The next ids are those that would have been issued without the rejected calls.
  EXPECT_EQ(scene.add(Sphere<N, T>{}, {.name = "bad"}), (ObjectId{1, 3, before.ids[0].owner}));
  EXPECT_EQ(scene.add(Sphere<N, T>{}), (ObjectId{3, 1, before.ids[0].owner}));
}

TYPED_TEST(SceneRefusals, NothingMovesToAFaultyShape) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Scene<N, T> scene = some_scene<N, T>();
  const test::SceneSight<N, T> before = test::ray_verdict_of(scene);
  const ObjectId sphere = *scene.find("ball");
  for (const Faulty<N, T>& faulty : faulty_shapes<N, T>()) {
    const std::string words = "Scene: object \"ball\", " + faulty.words;
    EXPECT_EQ(message_of<std::invalid_argument>([&] { scene.move(sphere, faulty.shape); }), words);
    const std::vector<ObjectMove<N, T>> moves{{before.ids[1], Sphere<N, T>{Vec<N, T>(T(7))}}, {sphere, faulty.shape}};
    EXPECT_EQ(message_of<std::invalid_argument>([&] { scene.move(moves); }), words);
    EXPECT_TRUE(test::ray_verdict_of(scene) == before) << faulty.words;
    EXPECT_TRUE((std::holds_alternative<Sphere<N, T>>(scene.object(sphere).shape)));
  }
}

/// A scene with a small limit, because a full one would need too much memory.
class SmallScene : public Scene<2, double> {
 public:
  explicit SmallScene(std::uint32_t most) { this->SceneView<2, double>::ids_ = detail::KeyTable(most); }
};

TEST(SceneThatIsFull, RefusesOneMoreSaysSoAndChangesNothing) {
  using Ball = Sphere<2, double>;
  SmallScene scene(3);
  const ObjectId first = scene.add(Ball{}, {.name = "first"});
  scene.add(Ball{});
  scene.add(Ball{});
  scene.update();
  const test::SceneSight<2, double> before = test::ray_verdict_of<2, double>(scene);
  for (int time = 0; time < 2; ++time) {
    EXPECT_EQ(message_of<std::length_error>([&] { scene.add(Ball{}, {.name = "more"}); }),
              "Scene: full; it holds at most 536870912 objects");
    EXPECT_TRUE((test::ray_verdict_of<2, double>(scene) == before));
    EXPECT_EQ(scene.find("more"), std::nullopt);
  }
  EXPECT_EQ(max_objects, 536870912U);
  scene.remove(first);  // which makes space for one
  const ObjectId more = scene.add(Ball{}, {.name = "more"});
  EXPECT_EQ(more, (ObjectId{0, 3, first.owner}));
  EXPECT_THROW(scene.add(Ball{}), std::length_error);
  EXPECT_EQ(scene.update().began.size(), 2U);
}

}  // namespace
}  // namespace graze::scene_refusals_test
