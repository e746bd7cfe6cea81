// SPDX-License-Identifier: MIT
// A long-running scene: random objects are added, moved and removed for a number of operations (multiplied by
// GRAZE_TEST_SCALE), while every answer is compared with PlainScene's.
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/frustum.hpp>

#include "broad/box_worlds.hpp"
#include "soak.hpp"

namespace graze::scene_soak_test {
namespace {

constexpr std::size_t most_objects = 200;
constexpr double world_size = 20;

bool same_id(const ObjectId& a, const ObjectId& b) { return a.index == b.index && a.generation == b.generation; }

bool same_pair(const ObjectPair& a, const ObjectPair& b) { return same_id(a.a, b.a) && same_id(a.b, b.b); }

template <class T>
bool same_near(const NearObject<T>& a, const NearObject<T>& b) {
  return same_id(a.id, b.id) && a.distance == b.distance;
}

template <class T>
bool same_near_pair(const NearPair<T>& a, const NearPair<T>& b) {
  return same_pair(a.pair, b.pair) && a.distance == b.distance;
}

template <Dim N, class T>
bool same_hit(const ObjectHit<N, T>& a, const ObjectHit<N, T>& b) {
  return same_id(a.id, b.id) && a.hit == b.hit;
}

template <Dim N, class T>
bool same_impact(const ObjectImpact<N, T>& a, const ObjectImpact<N, T>& b) {
  return same_id(a.id, b.id) && a.impact == b.impact;
}

template <Dim N, class T>
bool same_touch(const ObjectTouch<N, T>& a, const ObjectTouch<N, T>& b) {
  return same_id(a.id, b.id) && a.manifold == b.manifold;
}

template <Dim N, class T>
bool same_contact(const ObjectContact<N, T>& a, const ObjectContact<N, T>& b) {
  return same_pair(a.pair, b.pair) && a.manifold == b.manifold;
}

template <Dim N, class T>
class SceneSoak {
 public:
  void run(std::size_t operations) {
    breath_ = test::soak_cycle(operations);
    for (std::size_t operation = 0; operation < operations; ++operation) {
      step(operation);
      ASSERT_TRUE(is_right_) << "at operation " << operation << ", " << held_.size() << " objects";
    }
    empty_all();
    ASSERT_TRUE(is_right_) << "when all objects were removed";
    EXPECT_GE(breaths_, 4U);
    EXPECT_GE(answered_, asked_ / 3) << "of " << asked_ << " queries, too few had non-empty answers";
  }

 private:
  using Shape = AnyShape<N, T>;

  struct Held {
    ObjectId id;
    ObjectId judged;
  };

  void require(bool holds) { is_right_ = is_right_ && holds; }
  double chance() { return numbers_.between(0, 1); }
  Vec<N, T> place() { return numbers_.point<N, T>(0, world_size); }
  T length(double most) { return static_cast<T>(numbers_.between(0.01, most)); }
  std::size_t pick() { return static_cast<std::size_t>(numbers_.between(0, static_cast<double>(held_.size()))); }

  Turn<N, double> any_turn() {
    if constexpr (N == 2) return numbers_.between(-3, 3);
    if constexpr (N == 3) return numbers_.point<3, double>(-3, 3);
  }
  Mat<N, T> any_rotation() { return Mat<N, T>(rotation_of(any_turn())); }

  Shape any_shape() {
    const double kind = chance();
    const Vec<N, T> at = place();
    if (kind < 0.3) return Sphere<N, T>{at, length(1)};
    if (kind < 0.6) return Aabb<N, T>{at, at + length(1.5)};
    if (kind < 0.8) return Capsule<N, T>{at, at + numbers_.point<N, T>(-1, 1), length(0.5)};
    if (kind < 0.98) return Obb<N, T>{at, Vec<N, T>(length(1)), any_rotation()};
    return HalfSpace<N, T>{unit_axis<N, T>(0), length(1)};
  }

  void step(std::size_t operation) {
    const double kind = chance();
    if (kind < 0.15) {
      ask();
    } else if (kind < 0.2 && held_.size() > 1) {
      except_or_accept();
    } else if (kind < 0.45 && !held_.empty()) {
      move();
    } else if (kind < (is_quick_ ? 0.6 : 0.47)) {
      update();
    } else if (const bool grows = held_.size() < test::soak_target(operation, breath_, most_objects);
               held_.empty() || (grows == (chance() < 0.9))) {
      add();
    } else {
      remove(pick());
    }
    live_on(operation);
  }

  void live_on(std::size_t operation) {
    const std::size_t tenth = breath_ / 10;
    if (operation % tenth == 0) is_quick_ = !is_quick_;
    if (operation % (2 * tenth) == tenth) keep_snapshot();
    if (operation % breath_ == breath_ - 1) end_breath();
    if (operation % (2 * tenth) == 2 * tenth - 1) check_snapshot();
  }

  void add() {
    const ObjectOptions options{.layer = static_cast<Layer>(numbers_.between(0, 3)),
                                .mobility = chance() < 0.2 ? Mobility::fixed : Mobility::moving};
    const Shape shape = any_shape();
    held_.push_back({scene_.add(shape, options), judge_.add(shape, options)});
    require(same_id(held_.back().id, held_.back().judged));
  }

  /// Moves one, or several at once.
  void move() {
    if (chance() < 0.8) {
      const Held& held = held_[pick()];
      const Shape shape = any_shape();
      scene_.move(held.id, shape);
      return judge_.move(held.judged, shape);
    }
    if (chance() < 0.3) return move_balls();
    std::vector<ObjectMove<N, T>> moves;
    std::vector<ObjectMove<N, T>> judged;
    for (int k = 0; k < 5; ++k) {
      const Held& held = held_[pick()];
      moves.push_back({held.id, any_shape()});
      judged.push_back({held.judged, moves.back().shape});
    }
    scene_.move(moves);
    judge_.move(judged);
  }

  /// Moves several, which become shapes of one type.
  void move_balls() {
    std::vector<ObjectId> ids;
    std::vector<Sphere<N, T>> spheres;
    std::vector<ObjectMove<N, T>> judged;
    for (int k = 0; k < 5; ++k) {
      const Held& held = held_[pick()];
      ids.push_back(held.id);
      spheres.push_back({place(), length(1)});
      judged.push_back({held.judged, spheres.back()});
    }
    scene_.move(ids, spheres);
    judge_.move(judged);
  }

  void remove(std::size_t number) {
    const Held held = held_[number];
    scene_.remove(held.id);
    judge_.remove(held.judged);
    held_[number] = held_.back();
    held_.pop_back();
    require(!scene_.contains(held.id) && scene_.size() == held_.size());
  }

  /// Of two arbitrary objects, or of two that touch.
  void except_or_accept() {
    const std::vector<ObjectPair> touching = chance() < 0.1 ? judge_.pairs() : std::vector<ObjectPair>();
    ObjectPair judged{held_[pick()].judged, held_[pick()].judged};
    if (!touching.empty()) judged = touching[touching.size() / 2];
    if (judged.a == judged.b) return;
    const ObjectId a = *scene_.find(judged.a.index, judged.a.generation);
    const ObjectId b = *scene_.find(judged.b.index, judged.b.generation);
    if (const bool is_excepted = chance() < 0.7; is_excepted) {
      scene_.except(a, b);
      judge_.except(judged.b, judged.a);
    } else {
      scene_.accept(b, a);
      judge_.accept(judged.a, judged.b);
    }
    require(scene_.excepted(a, b) == judge_.excepted(judged.a, judged.b));
  }

  void update() {
    const SceneEvents& events = scene_.update(serial_executor());
    const SceneEvents expected = judge_.update();
    compare(events.began, expected.began, same_pair);
    compare(events.stayed, expected.stayed, same_pair);
    compare(events.ended, expected.ended, same_pair);
    std::vector<ObjectPair> touching;
    std::merge(expected.began.begin(), expected.began.end(), expected.stayed.begin(), expected.stayed.end(),
               std::back_inserter(touching));
    compare(scene_.pairs(), touching, same_pair);
  }

  template <class List, class Same>
  void compare(const List& found, const List& expected, const Same& same) {
    require(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), same));
    ++asked_;
    if (!expected.empty()) ++answered_;
  }

  /// Queries the scene, or a snapshot of its current state.
  void ask() {
    if (chance() < 0.8) return ask(scene_);
    ask(*scene_.snapshot());
  }

  void ask(const SceneView<N, T>& view) {
    const double kind = chance();
    const LayerMask layers = chance() < 0.5 ? all_layers : only_layer(1);
    if (kind < 0.1) {
      const Shape shape = any_region();
      compare(view.contacts_with(shape, {.layers = layers}), judge_.contacts_with(shape, {.layers = layers}),
              same_touch<N, T>);
    } else if (kind < 0.25) {
      const Shape region = any_region();
      compare(view.overlapping(region, layers), judge_.overlapping(region, layers), same_id);
    } else if (kind < 0.35) {
      const Shape region = any_region();
      compare(view.cull(region, layers), judge_.cull(region, layers), same_id);
    } else if (kind < 0.45) {
      const Frustum<N, T> frustum = any_frustum();
      compare(view.cull(frustum, layers), judge_.cull(frustum, layers), same_id);
    } else if (kind < 0.55) {
      const Shape shape = any_region();
      compare(view.nearest(shape, 4, {.layers = layers}), judge_.nearest(shape, 4, {.layers = layers}), same_near<T>);
    } else if (kind < 0.65) {
      const Vec<N, T> point = place();
      compare(view.nearest(point, 4, layers), judge_.nearest(point, 4, layers), same_near<T>);
    } else if (kind < 0.8) {
      cast_ray(view, layers);
    } else if (kind < 0.95) {
      cast_shape(view, layers);
    } else {
      ask_for_pairs(view);
    }
  }

  /// Compares the first hit, and all hits.
  void cast_ray(const SceneView<N, T>& view, LayerMask layers) {
    const Ray<N, T> ray{place(), numbers_.point<N, T>(-1, 1)};
    const T t_max = chance() < 0.5 ? T(20) : std::numeric_limits<T>::infinity();
    const std::vector<ObjectHit<N, T>> expected = judge_.ray_cast_all(ray, t_max, layers);
    compare(view.ray_cast_all(ray, t_max, layers), expected, same_hit<N, T>);
    const std::optional<ObjectHit<N, T>> first = view.ray_cast(ray, t_max, layers);
    require(first ? !expected.empty() && same_hit(*first, expected.front()) : expected.empty());
  }

  /// Compares the first impact, and all impacts, of a shape that translates, and the first of one that also rotates.
  void cast_shape(const SceneView<N, T>& view, LayerMask layers) {
    const Shape shape = any_shape();
    const Vec<N, T> motion = numbers_.point<N, T>(-world_size, world_size);
    const SceneQuery query{.layers = layers};
    const std::vector<ObjectImpact<N, T>> expected = judge_.shape_cast_all(shape, motion, query);
    compare(view.shape_cast_all(shape, motion, query), expected, same_impact<N, T>);
    const std::optional<ObjectImpact<N, T>> first = view.shape_cast(shape, motion, query);
    require(first ? !expected.empty() && same_impact(*first, expected.front()) : expected.empty());
    const Motion<N, T> path{motion, Turn<N, T>(any_turn()), place()};
    const std::optional<ObjectImpact<N, T>> found = view.time_of_impact(shape, path, query);
    const std::optional<ObjectImpact<N, T>> judged = judge_.time_of_impact(shape, path, query);
    require(found ? judged && same_impact(*found, *judged) : !judged);
  }

  /// Also those of objects that have changed since the last update.
  void ask_for_pairs(const SceneView<N, T>& view) {
    const double margin = numbers_.between(0, 1);
    compare(view.candidates(margin), judge_.candidates(margin), same_pair);
    const std::vector<ObjectContact<N, T>> expected = judge_.contacts();
    compare(view.contacts(serial_executor()), expected, same_contact<N, T>);
    std::vector<ObjectPair> touching;
    for (const ObjectContact<N, T>& contact : expected) touching.push_back(contact.pair);
    compare(view.pairs(), touching, same_pair);
    compare(view.excepted_pairs(), judge_.excepted_pairs(), same_pair);
    const T within = length(0.2);
    compare(view.closest_pairs(within), judge_.closest_pairs(within), same_near_pair<T>);
  }

  /// As large as an object, or up to as wide as the world.
  Shape any_region() {
    if (chance() < 0.7) return any_shape();
    return Sphere<N, T>{place(), length(world_size / 2)};
  }

  /// Of a camera anywhere, with any orientation.
  Frustum<N, T> any_frustum() {
    const T depth = length(12);
    const T slope = length(1);
    Frustum<N, T> frustum;
    for (Vec<N, T>& corner : frustum.corners) {
      const T ahead = corner[N - 1] > T(0) ? depth : depth * T(0.1);
      corner *= ahead * slope;
      corner[N - 1] = ahead;
    }
    return transformed(frustum, Pose<N, T>{any_rotation(), place()});
  }

  void keep_snapshot() {
    snapshot_ = scene_.snapshot();
    kept_ids_ = snapshot_->ids();
    kept_pairs_ = snapshot_->pairs();
    kept_found_ = snapshot_->overlapping(Aabb<N, T>{Vec<N, T>(T(0)), Vec<N, T>(T(7))});
  }

  /// It is unchanged, whatever happened to the scene.
  void check_snapshot() {
    if (!snapshot_) return;
    require(snapshot_->ids() == kept_ids_);
    require(snapshot_->pairs() == kept_pairs_);
    require(snapshot_->overlapping(Aabb<N, T>{Vec<N, T>(T(0)), Vec<N, T>(T(7))}) == kept_found_);
  }

  void end_breath() {
    empty_all();
    ++breaths_;
  }

  void empty_all() {
    while (!held_.empty()) remove(held_.size() / 2);
    update();
    require(scene_.size() == 0 && scene_.ids().empty() && scene_.pairs().empty());
    require(scene_.nearest(place(), 1).empty());
    update();
    require(scene_.events().ended.empty());
  }

  Scene<N, T> scene_;
  PlainScene<N, T> judge_;
  test::Numbers numbers_{20'261'122};
  std::vector<Held> held_;
  std::shared_ptr<const SceneView<N, T>> snapshot_;
  std::vector<ObjectId> kept_ids_;
  std::vector<ObjectId> kept_found_;
  std::vector<ObjectPair> kept_pairs_;
  std::size_t breath_ = 0;
  std::size_t breaths_ = 0;
  std::size_t asked_ = 0;
  std::size_t answered_ = 0;  // non-empty answers
  bool is_quick_ = false;     // updates follow each other quickly, so few objects have changed
  bool is_right_ = true;
};

TEST(SceneSoak, LosesNothingAndIsEmptyAtTheEndIn2D) { SceneSoak<2, double>().run(test::soak_operations()); }

TEST(SceneSoak, LosesNothingAndIsEmptyAtTheEndIn3D) { SceneSoak<3, float>().run(test::soak_operations()); }

}  // namespace
}  // namespace graze::scene_soak_test
