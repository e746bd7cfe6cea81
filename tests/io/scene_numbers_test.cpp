// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/json_scene.hpp>
#include <graze/io/scene_numbers.hpp>

namespace graze::io::scene_numbers_test {
namespace {

/// A program's scene in float: with a removed object, names, layers, masks, and numbers without a short decimal.
Scene<3> world() {
  Scene<3> scene;
  const Layer walls = scene.layer("walls");
  const Layer things = scene.layer("things");
  scene.add(HalfSpace<3>{{0, 0, 1}, -0.1F}, {.name = "floor", .layer = walls, .mobility = Mobility::fixed});
  const ObjectId gone = scene.add(Sphere<3>{{9, 9, 9}, 1});
  scene.add(Sphere<3>{{0.1F, 1.0F / 3, 0}, 0.7F},
            {.name = "ball", .layer = things, .mask = only_layer(walls), .user = 7});
  scene.add(Obb<3>{{1, 2, 3}, {0.3F, 0.2F, 0.1F}, Mat<3>({0.6F, 0.8F, 0}, {-0.8F, 0.6F, 0}, {0, 0, 1})});
  scene.add(convex_hull<3, float>(std::vector<Vec<3>>{{0, 0, 0}, {1.1F, 0, 0}, {0, 1.3F, 0}, {0, 0, 0.7F}}));
  scene.remove(gone);
  scene.add(Capsule<3>{{0, 0, 0}, {0, 0, 5.3F}, std::numeric_limits<float>::denorm_min()}, {.name = "rope"});
  scene.remove(scene.find("rope").value());
  scene.except(scene.find("ball").value(), scene.find("floor").value());
  return scene;
}

template <class T>
void expect_same(const Scene<3, T>& found, const Scene<3, T>& expected) {
  EXPECT_EQ(found.layer_names(), expected.layer_names());
  const auto is_same_place = [](const ObjectId& a, const ObjectId& b) {
    return a.index == b.index && a.generation == b.generation;
  };
  const std::vector<ObjectId> ids = found.ids();
  const std::vector<ObjectId> expected_ids = expected.ids();
  ASSERT_TRUE(std::equal(ids.begin(), ids.end(), expected_ids.begin(), expected_ids.end(), is_same_place));
  const std::vector<ObjectId> vacant = found.vacant_ids();
  const std::vector<ObjectId> expected_vacant = expected.vacant_ids();
  EXPECT_TRUE(std::equal(vacant.begin(), vacant.end(), expected_vacant.begin(), expected_vacant.end(), is_same_place));
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Object<3, T>& object = found.object(ids[k]);
    const Object<3, T>& other = expected.object(expected_ids[k]);
    EXPECT_EQ(object.box, other.box);
    EXPECT_EQ((type_name<3, T>(object.shape)), (type_name<3, T>(other.shape)));
    EXPECT_EQ(object.name, other.name);
    EXPECT_EQ(object.layer, other.layer);
    EXPECT_EQ(object.mask, other.mask);
    EXPECT_EQ(object.user, other.user);
    EXPECT_EQ(object.mobility, other.mobility);
  }
  const std::vector<ObjectPair> excepted = found.excepted_pairs();
  const std::vector<ObjectPair> expected_excepted = expected.excepted_pairs();
  EXPECT_TRUE(std::equal(
      excepted.begin(), excepted.end(), expected_excepted.begin(), expected_excepted.end(),
      [&](const ObjectPair& a, const ObjectPair& b) { return is_same_place(a.a, b.a) && is_same_place(a.b, b.b); }));
  EXPECT_EQ(found.pairs().size(), expected.pairs().size());
}

TEST(SceneNumbers, ASceneInFloatComesBackFromAFileAsItWas) {
  const Scene<3> scene = world();
  std::ostringstream out;
  write_json_scene(out, {scene_with_numbers<double>(scene), "a.json", "test", YAxis::up, {}});
  const SceneFile file = parse_json_scene(out.str(), "a.json");
  Scene<3> again = scene_with_numbers<float>(std::get<Scene<3, double>>(file.scene));
  const Scene<3, double>& read = std::get<Scene<3, double>>(file.scene);
  EXPECT_EQ(read.size(), scene.size());
  for (const ObjectId id : scene.ids()) {
    const ObjectId other = again.find(id.index, id.generation).value();
    EXPECT_EQ(again.object(other).box, scene.object(id).box);
    EXPECT_EQ(again.object(other).user, scene.object(id).user);
  }
  EXPECT_EQ(again.pairs().size(), scene.pairs().size());
  // The next id is the same, too.
  Scene<3> original = scene;
  const ObjectId next = original.add(Sphere<3>{{0, 0, 0}, 1});
  const ObjectId next_again = again.add(Sphere<3>{{0, 0, 0}, 1});
  EXPECT_EQ(next_again.index, next.index);
  EXPECT_EQ(next_again.generation, next.generation);
}

TEST(SceneNumbers, OfTheSameTypeAreACopyAndOfTheLargerTypeExact) {
  const Scene<3> scene = world();
  expect_same(scene_with_numbers<float>(scene), scene);
  expect_same(scene_with_numbers<float>(scene_with_numbers<double>(scene)), scene);
  expect_same(scene_with_numbers<float>(Scene<3, double>()), Scene<3>());
}

TEST(SceneNumbers, ThatAreTooLargeAreRefused) {
  Scene<2, double> scene;
  scene.add(Circle<double>{{1e300, 0}, 1}, {.name = "far"});
  EXPECT_THROW(static_cast<void>(scene_with_numbers<float>(scene)), std::invalid_argument);
}

}  // namespace
}  // namespace graze::io::scene_numbers_test
