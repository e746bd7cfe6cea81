// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/scene/storage/object_index.hpp>

namespace graze::detail::object_index_test {
namespace {

using Index = ObjectIndex<2, double>;
using Slots = Index::Slots;
using Box = Aabb<2, double>;

/// Slots, and an index that is notified of every change.
struct World {
  Slots slots;
  Index index;

  void set(std::uint32_t slot, const std::optional<AnyShape<2, double>>& shape) {
    slots.grow(slot + std::size_t{1});
    index.reserve(slots.size());
    auto& place = slots.change(slot);
    place.reset();
    if (shape) place.emplace(Object<2, double>{bounds(*shape), *shape, "", 0, Mobility::moving, all_layers, 0});
    index.note(slot);
  }

  std::set<std::uint32_t> in(const Box& region) const { return in(index, region); }

  std::set<std::uint32_t> in(const Index& asked, const Box& region) const {
    const SlotIndex<2, double>& current = asked.over(slots);
    std::set<std::uint32_t> found;
    current.query(region, [&](std::uint32_t slot) { found.insert(slot); });
    return found;
  }
};

using Found = std::set<std::uint32_t>;
const Box everywhere{{-1e9, -1e9}, {1e9, 1e9}};

TEST(ObjectIndex, CatchesUpWithWhatHasComeMovedAndGone) {
  World world;
  EXPECT_TRUE(world.in(everywhere).empty());
  world.set(0, Box{{0, 0}, {1, 1}});
  world.set(3, Box{{5, 5}, {6, 6}});
  EXPECT_EQ(world.in(everywhere), (Found{0, 3}));
  EXPECT_EQ(world.in({{0, 0}, {2, 2}}), (Found{0}));
  world.set(0, Box{{8, 8}, {9, 9}});
  world.set(3, std::nullopt);
  world.set(4, Box{{1, 1}, {2, 2}});
  EXPECT_EQ(world.in({{0, 0}, {2, 2}}), (Found{4}));
  EXPECT_EQ(world.in(everywhere), (Found{0, 4}));
}

TEST(ObjectIndex, AnObjectThatIsReplacedBeforeAnyoneAsksIsThereOnce) {
  World world;
  world.set(0, Box{{0, 0}, {1, 1}});
  world.set(0, std::nullopt);
  world.set(0, Box{{5, 5}, {6, 6}});
  EXPECT_EQ(world.in(everywhere), (Found{0}));
  EXPECT_EQ(world.index.over(world.slots).size(), 1U);
}

TEST(ObjectIndex, WhatHasNoPointsIsNotIn) {
  World world;
  world.set(0, Compound<2, double>{});
  world.set(1, HalfSpace<2, double>{{0, 1}, 0});
  EXPECT_EQ(world.in(everywhere), (Found{1}));
  world.set(1, Compound<2, double>{});
  EXPECT_TRUE(world.in(everywhere).empty());
}

TEST(ObjectIndex, FindsTheSameWhetherMuchOrLittleHasChanged) {
  World world;
  constexpr std::uint32_t count = 300;
  for (std::uint32_t k = 0; k < count; ++k) world.set(k, Box{{2.0 * k, 0}, {2.0 * k + 1, 1}});
  world.set(7, HalfSpace<2, double>{{1, 0}, 4});
  EXPECT_EQ(world.in({{-1, 0}, {9, 1}}), (Found{0, 1, 2, 3, 4, 7}));
  for (std::uint32_t k = 100; k < 110; ++k) world.set(k, Box{{2.0 * k, 5}, {2.0 * k + 1, 6}});
  world.set(3, std::nullopt);
  EXPECT_EQ(world.in({{-1, 0}, {9, 1}}), (Found{0, 1, 2, 4, 7}));
  EXPECT_EQ(world.in({{199, 5}, {203, 6}}), (Found{100, 101}));
  for (std::uint32_t k = 50; k < count; ++k) world.set(k, std::nullopt);
  EXPECT_EQ(world.in(everywhere).size(), 49U);
  EXPECT_EQ(world.index.over(world.slots).size(), 49U);
  EXPECT_EQ(world.index.over(world.slots).nearest({{4, 3}, {4, 3}}, 2).front().key.index, 7U);
}

TEST(ObjectIndex, VisitsWhatAMovingBoxMayTouchInOrder) {
  World world;
  for (std::uint32_t k = 0; k < 100; ++k) world.set(k, Box{{2.0 * k, 0}, {2.0 * k + 1, 1}});
  world.set(7, Box{{14, 9}, {15, 10}});
  world.set(100, HalfSpace<2, double>{{-1, 0}, -12.5});
  std::vector<std::uint32_t> visited;
  const SweptBox<2> sweep = swept_box_of(Box{{17.2, 0}, {17.8, 1}}, Vec<2, double>(-8, 0));
  world.index.over(world.slots).visit_swept(sweep, [&visited](std::uint32_t slot) {
    visited.push_back(slot);
    return 1.0;
  });
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{100, 8, 6, 5}));
}

TEST(ObjectIndex, WhatWasSharedStaysAndACopyGoesItsOwnWay) {
  World world;
  world.set(0, Box{{0, 0}, {1, 1}});
  const Index shared = world.index.share(world.slots);
  const World copy = world;
  world.set(0, Box{{5, 5}, {6, 6}});
  EXPECT_EQ(world.in({{4, 4}, {9, 9}}), (Found{0}));
  EXPECT_EQ(world.in(shared, {{0, 0}, {2, 2}}), (Found{0}));
  EXPECT_EQ(copy.in({{0, 0}, {2, 2}}), (Found{0}));
  World moved = std::move(world);
  EXPECT_EQ(moved.in({{4, 4}, {9, 9}}), (Found{0}));
}

}  // namespace
}  // namespace graze::detail::object_index_test
