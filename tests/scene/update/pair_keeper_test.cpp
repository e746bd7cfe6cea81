// SPDX-License-Identifier: MIT
// Both methods of maintaining pairs, compared with all pairs, from update to update.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/relation.hpp>
#include <graze/scene/update/pair_keeper.hpp>

#include "catalogue.hpp"

namespace graze::detail::pair_keeper_test {
namespace {

/// Slots with the data of a scene that an update needs.
template <Dim N, class T>
struct World {
  SharedSlots<Object<N, T>> slots;
  PairKeeper<N, T> keeper;

  void set(std::uint32_t slot, const std::optional<AnyShape<N, T>>& shape, const ObjectOptions& options = {}) {
    slots.grow(slot + std::size_t{1});
    keeper.reserve(slots.size());
    auto& place = slots.change(slot);
    place.reset();
    if (!shape) return keeper.note_gone(slot);
    place.emplace(Object<N, T>{bounds(*shape), *shape, "", options.layer, options.mobility, options.mask, 0});
    keeper.note_new(slot, *place);
  }

  void move(std::uint32_t slot, const AnyShape<N, T>& shape) {
    Object<N, T>& object = *slots.change(slot);
    object.shape = shape;
    object.box = bounds(shape);
    keeper.note_moved(slot, object);
  }

  std::vector<Pair> every_pair() const {
    std::vector<Pair> pairs;
    for (std::uint32_t a = 0; a < slots.size(); ++a) {
      for (std::uint32_t b = a + 1; b < slots.size(); ++b) {
        if (!slots[a] || !slots[b] || !may_touch(*slots[a], *slots[b])) continue;
        if (relation(slots[a]->shape, slots[b]->shape) != Relation::apart) pairs.push_back({a, b});
      }
    }
    return pairs;
  }

  /// Both methods report the pairs that touch now: one by a list, the other by begin and end events.
  std::vector<Pair> update(PairPlan plan) {
    const PairPlan taken = keeper.find(slots, serial_executor(), plan);
    if (taken == PairPlan::anew) {
      touching.assign(keeper.found().begin(), keeper.found().end());
    } else {
      for (const Pair& pair : keeper.ended()) {
        const auto known = std::find(touching.begin(), touching.end(), pair);
        EXPECT_NE(known, touching.end());
        if (known != touching.end()) touching.erase(known);
      }
      touching.insert(touching.end(), keeper.began().begin(), keeper.began().end());
      std::sort(touching.begin(), touching.end());
    }
    keeper.commit();
    return touching;
  }

  std::vector<Pair> touching;
};

using Flat = World<2, double>;
using Ball = Sphere<2, double>;

TEST(PairKeeper, KnowsNothingOfAnEmptyWorld) {
  Flat world;
  EXPECT_TRUE(world.update(PairPlan::automatic).empty());
  EXPECT_TRUE(world.keeper.is_current());
}

TEST(PairKeeper, MendsWhatIsAroundAnObjectThatMovesComesOrGoes) {
  Flat world;
  for (std::uint32_t i = 0; i < 5; ++i) world.set(i, Ball{{2.0 * i, 0}, 1});
  EXPECT_EQ(world.update(PairPlan::anew), (std::vector<Pair>{{0, 1}, {1, 2}, {2, 3}, {3, 4}}));
  world.set(2, Ball{{0, 1}, 1});
  EXPECT_FALSE(world.keeper.is_current());
  EXPECT_EQ(world.update(PairPlan::mend), (std::vector<Pair>{{0, 1}, {0, 2}, {3, 4}}));
  world.set(4, std::nullopt);
  EXPECT_EQ(world.update(PairPlan::mend), (std::vector<Pair>{{0, 1}, {0, 2}}));
  world.set(4, HalfSpace<2, double>{{0, 1}, -1});
  EXPECT_EQ(world.update(PairPlan::mend), (std::vector<Pair>{{0, 1}, {0, 2}, {0, 4}, {1, 4}, {3, 4}}));
}

TEST(PairKeeper, SaysThatAPairEndsAndBeginsWhenAnotherObjectTakesAPlace) {
  Flat world;
  world.set(0, Ball{{0, 0}, 1});
  world.set(1, Ball{{1, 0}, 1});
  world.set(2, Ball{{2, 0}, 1});
  world.update(PairPlan::anew);
  world.set(1, std::nullopt);
  world.set(1, Ball{{1, 0}, 0.5});
  const auto listed = [](std::span<const Pair> pairs) { return std::vector<Pair>(pairs.begin(), pairs.end()); };
  world.keeper.find(world.slots, serial_executor(), PairPlan::mend);
  EXPECT_EQ(listed(world.keeper.ended()), (std::vector<Pair>{{0, 1}, {1, 2}}));
  EXPECT_EQ(listed(world.keeper.began()), (std::vector<Pair>{{0, 1}, {1, 2}}));
  world.keeper.commit();
  EXPECT_EQ(world.update(PairPlan::mend), (std::vector<Pair>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(PairKeeper, FindsTheSameAgainAsLongAsNothingWasTakenOver) {
  Flat world;
  for (std::uint32_t i = 0; i < 3; ++i) world.set(i, Ball{{2.0 * i, 0}, 1});
  world.update(PairPlan::anew);
  world.set(1, Ball{{9, 9}, 1});
  world.keeper.find(world.slots, serial_executor(), PairPlan::mend);
  world.keeper.find(world.slots, serial_executor(), PairPlan::anew);
  world.set(2, Ball{{1, 0}, 1});
  EXPECT_EQ(world.update(PairPlan::mend), (std::vector<Pair>{{0, 2}}));
  EXPECT_EQ(world.update(PairPlan::anew), (std::vector<Pair>{{0, 2}}));
}

TEST(PairKeeper, AnObjectThatTouchesManyMovesAndIsLeft) {
  Flat world;
  const std::uint32_t many = 200;
  for (std::uint32_t i = 0; i < many; ++i) world.set(i, Ball{{3.0 * i, 0}, 1});
  world.set(many, HalfSpace<2, double>{{0, 1}, 0});
  EXPECT_EQ(world.update(PairPlan::mend).size(), many);
  world.set(7, Ball{{21, 5}, 1});
  EXPECT_EQ(world.update(PairPlan::mend).size(), many - 1);
  world.set(many, HalfSpace<2, double>{{0, 1}, -3});
  EXPECT_TRUE(world.update(PairPlan::mend).empty());
  world.set(many, HalfSpace<2, double>{{0, 1}, 9});
  EXPECT_EQ(world.update(PairPlan::mend).size(), many);
}

TEST(PairKeeper, ACopyGoesOnByItself) {
  Flat world;
  world.set(0, Ball{{0, 0}, 1});
  world.set(1, Ball{{1, 0}, 1});
  world.update(PairPlan::anew);
  Flat copy = world;
  copy.set(1, Ball{{9, 0}, 1});
  EXPECT_TRUE(copy.update(PairPlan::automatic).empty());
  EXPECT_EQ(world.update(PairPlan::automatic), (std::vector<Pair>{{0, 1}}));
}

template <Dim N, class T>
void check_every_plan() {
  World<N, T> world;
  const std::size_t rounds = *rc::gen::inRange<std::size_t>(1, 5);
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto shapes = *test::some<AnyShape<N, T>>(12, test::any_shape<N, T>());
    for (const AnyShape<N, T>& shape : shapes) {
      const auto slot = static_cast<std::uint32_t>(*rc::gen::inRange(0, 16));
      const int kind = *rc::gen::inRange(0, 8);
      const ObjectOptions options{.layer = static_cast<Layer>(kind % 2),
                                  .mask = kind == 1 ? only_layer(1) : all_layers,
                                  .mobility = kind < 4 ? Mobility::moving : Mobility::fixed};
      world.set(slot, kind == 7 ? std::nullopt : std::optional(shape), options);
    }
    const std::vector<Pair> truth = world.every_pair();
    for (const PairPlan plan : {PairPlan::automatic, PairPlan::anew, PairPlan::mend}) {
      World<N, T> copy = world;
      RC_ASSERT(copy.update(plan) == truth);
    }
    RC_ASSERT(world.update(*rc::gen::arbitrary<bool>() ? PairPlan::mend : PairPlan::anew) == truth);
  }
}

/// Boxes and spheres on a random walk with small steps, sometimes a large one; all of them or few.
template <Dim N, class T>
void check_walk() {
  constexpr std::uint32_t count = 20;
  World<N, T> world;
  std::vector<Vec<N, T>> places(count, Vec<N, T>(T(0)));
  const auto step = [&](std::uint32_t slot, int most) {
    for (Dim i = 0; i < N; ++i) places[slot][i] += static_cast<T>(*rc::gen::inRange(-most, most + 1)) / 64;
    const Vec<N, T> half(slot % 5 == 0 ? T(1) : T(0.5));
    return slot % 3 == 0 ? AnyShape<N, T>(Sphere<N, T>{places[slot], T(0.5)})
                         : AnyShape<N, T>(Aabb<N, T>{places[slot] - half, places[slot] + half});
  };
  for (std::uint32_t slot = 0; slot < count; ++slot) world.set(slot, step(slot, 200));
  const int frames = *rc::gen::inRange(2, 16);
  for (int frame = 0; frame < frames; ++frame) {
    const int share = *rc::gen::element(1, 2, 10);
    const int most = *rc::gen::element(2, 8, 8, 100);
    for (std::uint32_t slot = 0; slot < count; ++slot) {
      if (*rc::gen::inRange(0, share) == 0) world.move(slot, step(slot, most));
    }
    const PairPlan plan =
        *rc::gen::element(PairPlan::anew, PairPlan::anew, PairPlan::mend, PairPlan::mend, PairPlan::automatic);
    RC_ASSERT(world.update(plan) == world.every_pair());
  }
}

RC_GTEST_PROP(PairKeeper, AnyPlanFollowsAWalk2f, ()) { check_walk<2, float>(); }
RC_GTEST_PROP(PairKeeper, AnyPlanFollowsAWalk3d, ()) { check_walk<3, double>(); }

RC_GTEST_PROP(PairKeeper, AnyPlanFindsAllPairs2f, ()) { check_every_plan<2, float>(); }
RC_GTEST_PROP(PairKeeper, AnyPlanFindsAllPairs3d, ()) { check_every_plan<3, double>(); }

}  // namespace
}  // namespace graze::detail::pair_keeper_test
