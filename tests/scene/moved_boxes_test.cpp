// SPDX-License-Identifier: MIT
// Scenes in which many boxes move at once, compared with one without an index, memory or lists.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>

#include "spaces.hpp"

namespace graze::moved_boxes_test {
namespace {

/// Without owners, which differ between two scenes.
using PlainPair = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<PlainPair> plain(const std::vector<ObjectPair>& pairs) {
  std::vector<PlainPair> result;
  for (const ObjectPair& pair : pairs) {
    result.emplace_back(pair.a.index, pair.a.generation, pair.b.index, pair.b.generation);
  }
  return result;
}

std::vector<std::uint32_t> indexes(const std::vector<ObjectId>& ids) {
  std::vector<std::uint32_t> result;
  for (const ObjectId& id : ids) result.push_back(id.index);
  return result;
}

template <Dim N, class T>
class TwoWorlds {
 public:
  using Box = Aabb<N, T>;

  explicit TwoWorlds(unsigned seed) : random_(seed) {
    for (std::size_t k = 0; k < 150; ++k) add(some_box());
  }

  void add(const AnyShape<N, T>& shape) {
    ids_.push_back(scene_.add(shape));
    plain_ids_.push_back(plain_.add(shape));
  }

  void remove_one() {
    const std::size_t k = random_() % ids_.size();
    scene_.remove(ids_[k]);
    plain_.remove(plain_ids_[k]);
    ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(k));
    plain_ids_.erase(plain_ids_.begin() + static_cast<std::ptrdiff_t>(k));
  }

  /// Moves all by a limited step.
  void move_all(T step) {
    std::vector<Box> boxes;
    for (const ObjectId& id : ids_) {
      Box box = scene_.object(id).box;
      Vec<N, T> way;
      for (Dim i = 0; i < N; ++i) way[i] = step * static_cast<T>(random_() % 17) / 8 - step;
      boxes.push_back({box.min + way, box.max + way});
    }
    scene_.move(ids_, boxes);
    for (std::size_t k = 0; k < ids_.size(); ++k) plain_.move(plain_ids_[k], boxes[k]);
  }

  /// Moves some, in any order, possibly one twice.
  void move_some() {
    std::vector<ObjectId> ids;
    std::vector<Box> boxes;
    for (std::size_t n = random_() % 12; n > 0; --n) {
      const std::size_t k = random_() % ids_.size();
      ids.push_back(ids_[k]);
      boxes.push_back(some_box());
      plain_.move(plain_ids_[k], boxes.back());
    }
    scene_.move(ids, boxes);
  }

  void snapshot() { snapshot_ = scene_.snapshot(); }
  void go_on_with_a_copy() { scene_ = Scene<N, T>(scene_); }

  void expect_the_same_update() {
    const SceneEvents expected = plain_.update();
    const SceneEvents& events = scene_.update(serial_executor());
    EXPECT_EQ(plain(events.began), plain(expected.began));
    EXPECT_EQ(plain(events.stayed), plain(expected.stayed));
    EXPECT_EQ(plain(events.ended), plain(expected.ended));
    EXPECT_EQ(plain(scene_.pairs()), plain(plain_.pairs()));
  }

  void expect_the_same_answer() {
    const Box region = some_box();
    EXPECT_EQ(indexes(scene_.overlapping(region)), indexes(plain_.overlapping(region)));
  }

  unsigned random() { return static_cast<unsigned>(random_()); }

  /// Its sides are multiples of an eighth, so that some only touch.
  Box some_box() {
    Box box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<T>(random_() % (N == 2 ? 96 : 40)) / 8;
      box.max[i] = box.min[i] + static_cast<T>(4 + random_() % 8) / 8;
    }
    return box;
  }

 private:
  std::mt19937 random_;
  Scene<N, T> scene_;
  PlainScene<N, T> plain_;
  std::vector<ObjectId> ids_;
  std::vector<ObjectId> plain_ids_;
  std::shared_ptr<const SceneView<N, T>> snapshot_;
};

template <class Space>
class MovedBoxes : public testing::Test {};

TYPED_TEST_SUITE(MovedBoxes, test::Spaces);

/// Small steps, so that candidates remain valid for several frames; sometimes something invalidates them.
TYPED_TEST(MovedBoxes, BeginStayAndEndAsInAWorldWithoutLists) {
  using T = typename TypeParam::scalar;
  TwoWorlds<TypeParam::dimension, T> worlds(7);
  for (int frame = 0; frame < 120 && !this->HasFailure(); ++frame) {
    const unsigned chance = worlds.random() % 32;
    if (chance == 0) worlds.add(worlds.some_box());
    if (chance == 1) worlds.remove_one();
    if (chance == 2) worlds.move_some();
    if (chance == 3) worlds.snapshot();
    if (chance == 4) worlds.go_on_with_a_copy();
    if (chance == 5) worlds.expect_the_same_answer();
    if (chance != 6) worlds.move_all(T(1) / 32);
    worlds.expect_the_same_update();
  }
  worlds.expect_the_same_answer();
}

/// The same with a sphere among them, which is not a box until it is moved to one.
TYPED_TEST(MovedBoxes, AreThoseOfAWorldThatHoldsMoreThanBoxes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  TwoWorlds<N, T> worlds(8);
  for (int frame = 0; frame < 40 && !this->HasFailure(); ++frame) {
    if (frame % 8 == 0) worlds.add(Sphere<N, T>{Vec<N, T>(T(3)), T(1)});
    if (frame % 4 < 2) worlds.move_some();
    if (frame % 8 > 4) worlds.move_all(T(1) / 32);
    worlds.expect_the_same_update();
    worlds.expect_the_same_answer();
  }
}

}  // namespace
}  // namespace graze::moved_boxes_test
