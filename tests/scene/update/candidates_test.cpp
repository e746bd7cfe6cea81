// SPDX-License-Identifier: MIT
// Candidates from frame to frame, compared with all pairs of overlapping boxes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/scene/update/candidates.hpp>

namespace graze::detail::candidates_test {
namespace {

constexpr PairFilter anyone = {};
constexpr PairFilter wall = {.mobility = Mobility::fixed};

/// What was recorded, in plain containers.
template <Dim N, class T>
struct World {
  using Box = Aabb<N, T>;

  explicit World(std::size_t count) : boxes(count, Box::nothing()), filters(count) { candidates.reserve(count); }

  void put(std::uint32_t slot, const Box& box, const PairFilter& filter = anyone) {
    boxes[slot] = box;
    filters[slot] = filter;
    candidates.put(slot, box, filter);
    note(slot);
  }

  void move(std::uint32_t slot, const Box& box) {
    boxes[slot] = box;
    candidates.move(slot, box);
    note(slot);
  }

  void note(std::uint32_t slot) {
    if (std::find(changed.begin(), changed.end(), slot) == changed.end()) changed.push_back(slot);
  }

  /// The pairs that must be found, ascending.
  std::vector<Pair> needed() const {
    std::vector<Pair> pairs;
    for (std::uint32_t a = 0; a < boxes.size(); ++a) {
      for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
        if (is_nothing(boxes[a]) || is_nothing(boxes[b]) || !may_touch(filters[a], filters[b])) continue;
        if (boxes_overlap(touching_bounds(boxes[a]), touching_bounds(boxes[b]))) pairs.push_back({a, b});
      }
    }
    return pairs;
  }

  std::vector<Pair> listed(const PairExceptions& exceptions = {}) {
    const std::span<const Pair> list = candidates.list(boxes.size(), serial_executor(), exceptions);
    changed.clear();
    return {list.begin(), list.end()};
  }

  /// The content of the graph, ascending; a pair that is in it twice appears twice.
  std::vector<Pair> linked(std::span<const Pair> touching = {}, const PairExceptions& exceptions = {}) {
    if (!candidates.is_linked()) candidates.link(boxes.size(), touching, serial_executor(), exceptions);
    candidates.follow(changed, serial_executor(), exceptions);
    changed.clear();
    std::vector<Pair> pairs;
    for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
      candidates.graph().visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t /*edge*/) {
        if (slot < other) pairs.push_back({slot, other});
      });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Candidates<N, T> candidates;
  std::vector<Box> boxes;
  std::vector<PairFilter> filters;
  std::vector<std::uint32_t> changed;
};

using Plane2 = World<2, double>;
using Square = Aabb<2, double>;

Square square(double x, double y, double side = 1) { return {{x, y}, {x + side, y + side}}; }

bool are_all_in(const std::vector<Pair>& needed, const std::vector<Pair>& pairs) {
  return std::includes(pairs.begin(), pairs.end(), needed.begin(), needed.end());
}

bool ascend(const std::vector<Pair>& pairs) {
  return std::is_sorted(pairs.begin(), pairs.end()) && std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end();
}

TEST(Candidates, AreThePairsOfBoxesThatOverlapWhereNothingHasMoved) {
  Plane2 world(5);
  world.put(0, square(0, 0));
  world.put(1, square(1, 0));
  world.put(2, square(9, 9), wall);
  world.put(3, square(9.5, 9.5), wall);
  EXPECT_EQ(world.listed(), (std::vector<Pair>{{0, 1}}));
  EXPECT_EQ(world.linked(), (std::vector<Pair>{{0, 1}}));
  world.put(2, square(9, 9));
  EXPECT_EQ(world.linked(), (std::vector<Pair>{{0, 1}, {2, 3}}));
}

TEST(Candidates, LackExceptedPairsInTheListAndInTheGraph) {
  Plane2 world(3);
  for (std::uint32_t slot = 0; slot < 3; ++slot) world.put(slot, square(0, 0));
  PairExceptions exceptions;
  const auto set = [&](bool is_excepted) {
    is_excepted ? exceptions.add(1, 0) : exceptions.remove(1, 0);
    for (const std::uint32_t slot : {0U, 1U}) {
      world.candidates.set_exceptions(slot, is_excepted);
      world.note(slot);
    }
  };
  const std::vector<Pair> all{{0, 1}, {0, 2}, {1, 2}};
  const std::vector<Pair> rest{{0, 2}, {1, 2}};
  EXPECT_EQ(world.listed(), all);
  set(true);
  EXPECT_EQ(world.listed(exceptions), rest);
  set(false);
  EXPECT_EQ(world.linked({}, exceptions), all);
  set(true);
  EXPECT_EQ(world.linked({}, exceptions), rest);
  EXPECT_EQ(world.linked({}, exceptions), rest);
  set(false);
  EXPECT_EQ(world.linked({}, exceptions), all);
}

TEST(Candidates, StayWhileAllMoveALittle) {
  Plane2 world(40);
  const auto place = [&](std::uint32_t slot, double time) { return square(1.2 * slot + 0.05 * time, 0); };
  for (std::uint32_t slot = 0; slot < 40; ++slot) world.put(slot, place(slot, 0));
  EXPECT_TRUE(world.listed().empty());
  const Pair* last = nullptr;
  int kept = 0;
  for (int time = 1; time < 20; ++time) {
    for (std::uint32_t slot = 0; slot < 40; ++slot) world.move(slot, place(slot, time));
    const std::span<const Pair> list = world.candidates.list(40, serial_executor());
    kept += list.size() == 39 && list.data() == last ? 1 : 0;
    last = list.data();
  }
  EXPECT_GT(kept, 5);  // neighbours, 0.2 apart, are candidates by the margin alone
}

TEST(Candidates, OfOneThatMovesALittleStayInTheGraph) {
  Plane2 world(3);
  world.put(0, square(0, 0));
  world.put(1, square(1.5, 0));
  world.put(2, square(1.5, 1.6));
  EXPECT_TRUE(world.linked().empty());
  world.move(0, square(0.1, 0));
  EXPECT_TRUE(world.linked().empty());  // a margin of twice that step
  world.move(0, square(0.32, 0));
  const std::vector<Pair> near = {{0, 1}};  // and more
  EXPECT_EQ(world.linked(), near);
  world.move(0, square(0.33, 0));
  EXPECT_EQ(world.linked(), near);
  world.move(0, square(-40, 0));
  EXPECT_TRUE(world.linked().empty());
}

/// Squares of side 1 in a row, 0.1 apart.
Plane2 row(std::uint32_t count) {
  Plane2 world(count);
  for (std::uint32_t slot = 0; slot < count; ++slot) world.put(slot, square(1.1 * slot, 0));
  return world;
}

std::vector<Pair> neighbours(std::uint32_t count) {
  std::vector<Pair> pairs;
  for (std::uint32_t slot = 0; slot + 1 < count; ++slot) pairs.push_back({slot, slot + 1});
  return pairs;
}

TEST(Candidates, AllHaveAMarginInAGraphIfSomeMoveAtFirst) {
  Plane2 world = row(300);
  EXPECT_TRUE(world.listed().empty());
  for (const std::uint32_t slot : {7U, 100U, 200U}) world.move(slot, square(1.1 * slot, 0.06));
  EXPECT_EQ(world.linked(), neighbours(300));
  for (const std::uint32_t slot : {50U, 150U}) world.move(slot, square(1.1 * slot, -0.11));  // nearly two such steps
  EXPECT_EQ(world.linked(), neighbours(300));
}

TEST(Candidates, AFewThatMoveAtFirstAndLongStepsMakeNoMarginForAll) {
  for (const std::uint32_t moved : {1U, 3U}) {
    Plane2 world = row(300);
    EXPECT_TRUE(world.listed().empty());
    for (std::uint32_t slot = 0; slot < moved; ++slot) world.move(slot, square(1.1 * slot, moved == 1 ? -0.06 : -0.2));
    EXPECT_FALSE(are_all_in({{150, 151}}, world.linked())) << moved;
  }
}

TEST(Candidates, APairThatTouchesStaysInTheGraphUntilItIsParted) {
  Plane2 world(2);
  world.put(0, square(0, 0));
  world.put(1, square(0.5, 0));
  const std::vector<Pair> pair = {{0, 1}};
  EXPECT_EQ(world.listed(), pair);
  EXPECT_EQ(world.linked(pair), pair);
  world.move(1, square(7, 0));
  EXPECT_EQ(world.linked(), pair);
  std::uint32_t number = 9;
  world.candidates.graph().visit_pairs_of(1, [&](std::uint32_t /*other*/, std::uint32_t edge) { number = edge; });
  EXPECT_TRUE(world.candidates.graph().is_touching(number));
  world.candidates.part(pair[0], number);
  EXPECT_TRUE(world.linked().empty());
}

TEST(Candidates, TouchingPairsAreLinkedWhateverBecameOfTheirObjects) {
  Plane2 world(3);
  world.put(0, square(0, 0));
  world.put(1, square(5, 0));
  EXPECT_EQ(world.linked(std::vector<Pair>{{0, 1}, {1, 2}}), (std::vector<Pair>{{0, 1}, {1, 2}}));
}

/// Fails from some call on.
class Broken final : public Executor {
 public:
  explicit Broken(int calls) : calls_(calls) {}
  std::size_t concurrency() const override { return 1; }
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    if (calls_-- <= 0) throw std::runtime_error("broken");
    serial_executor().parallel_for(count, task);
  }

 private:
  mutable int calls_;
};

TEST(Candidates, AreRightAgainAfterAFailure) {
  Plane2 world(12);
  for (std::uint32_t slot = 0; slot < 12; ++slot) world.put(slot, square(0.9 * slot, 0));
  EXPECT_THROW(world.candidates.link(12, {}, Broken(0)), std::runtime_error);
  EXPECT_FALSE(world.candidates.is_linked());
  EXPECT_EQ(world.linked(), world.needed());
  world.move(3, square(0, 0));
  world.move(4, square(0.1, 0));
  EXPECT_THROW(world.candidates.follow(world.changed, Broken(0)), std::runtime_error);
  world.move(3, square(5, 0));
  world.put(9, Square::nothing());
  EXPECT_TRUE(are_all_in(world.needed(), world.linked()));
  EXPECT_THROW(world.candidates.list(12, Broken(0)), std::runtime_error);
  EXPECT_TRUE(are_all_in(world.needed(), world.listed()));
}

TEST(Candidates, ACopyGoesOnByItself) {
  Plane2 world(12);
  for (std::uint32_t slot = 0; slot < 12; ++slot) world.put(slot, square(0.9 * slot, 0));
  world.listed();
  Plane2 listing = world;
  world.linked();
  Plane2 linking = world;
  EXPECT_TRUE(linking.candidates.is_linked());
  EXPECT_FALSE(listing.candidates.is_linked());
  for (Plane2* each : {&world, &listing, &linking}) each->move(5, square(0.3, 0.2));
  EXPECT_TRUE(are_all_in(world.needed(), world.linked()));
  EXPECT_TRUE(are_all_in(world.needed(), linking.linked()));
  EXPECT_TRUE(are_all_in(world.needed(), listing.listed()));
}

template <Dim N, class T>
Aabb<N, T> any_box() {
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    box.min[i] = static_cast<T>(*rc::gen::inRange(-40, 40)) / 4;
    box.max[i] = box.min[i] + static_cast<T>(*rc::gen::inRange(0, 8)) / 4;
  }
  if (*rc::gen::inRange(0, 12) == 0) box.max[0] = std::numeric_limits<T>::infinity();
  return box;
}

template <Dim N, class T>
Aabb<N, T> moved(Aabb<N, T> box, int most) {
  for (Dim i = 0; i < N; ++i) {
    const T step = static_cast<T>(*rc::gen::inRange(-most, most + 1)) / 32;
    box.min[i] += step;
    box.max[i] += step;
  }
  return box;
}

/// Frames with few changes or many, small or large ones, one method or the other.
template <Dim N, class T>
void check_frames() {
  constexpr std::uint32_t slots = 24;
  World<N, T> world(slots);
  for (std::uint32_t slot = 0; slot < slots; ++slot) world.put(slot, any_box<N, T>());
  const int frames = *rc::gen::inRange(1, 12);
  for (int frame = 0; frame < frames; ++frame) {
    const int step = *rc::gen::element(1, 4, 16);
    const int share = *rc::gen::element(1, 6);
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
      if (*rc::gen::inRange(0, share) != 0) continue;
      const int kind = *rc::gen::inRange(0, 60);
      if (kind == 0) {
        world.put(slot, Aabb<N, T>::nothing());
      } else if (kind == 1 || is_nothing(world.boxes[slot])) {
        world.put(slot, any_box<N, T>(), kind % 2 == 0 ? anyone : wall);
      } else {
        world.move(slot, moved(world.boxes[slot], step));
      }
    }
    const std::vector<Pair> pairs = *rc::gen::arbitrary<bool>() ? world.listed() : world.linked();
    RC_ASSERT(ascend(pairs));
    RC_ASSERT(are_all_in(world.needed(), pairs));
    for (const Aabb<N, T>& box : world.boxes) {
      if (!is_valid(box)) continue;
      for (Dim i = 0; i < N; ++i) {
        RC_ASSERT(std::max(std::fabs(box.min[i]), std::fabs(box.max[i])) <= world.candidates.largest());
      }
    }
  }
}

RC_GTEST_PROP(Candidates, MissNoPairFromFrameToFrame2f, ()) { check_frames<2, float>(); }
RC_GTEST_PROP(Candidates, MissNoPairFromFrameToFrame3d, ()) { check_frames<3, double>(); }

}  // namespace
}  // namespace graze::detail::candidates_test
