// SPDX-License-Identifier: MIT
// Every index answers as BruteForce does after any sequence of calls, and rejects invalid input. A new index adds one
// line to Indexes.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/sphere.hpp>

#include "index_operations.hpp"
#include "thread_executor.hpp"

namespace graze::test {

template <Dim N, class T>
using Indexes = testing::Types<  //
    BruteForce<N, T>,            //
    Orthtree<N, T>,              //
    Bvh<N, T>,                   //
    Grid<N, T>>;

/// An index of a type; the number selects its settings. Small capacities make tall trees of few boxes.
template <class I>
I index_number(int number) {
  if constexpr (requires { I(OrthtreeOptions{}); }) {
    constexpr std::array<OrthtreeOptions, 4> options = {{{8, 16}, {1, 6}, {2, 3}, {3, 0}}};
    return I(options[static_cast<std::size_t>(number) % options.size()]);
  } else if constexpr (requires { I(GridOptions{}); }) {
    constexpr std::array<GridOptions, 4> options = {{{0}, {0.5}, {3}, {1e6}}};
    return I(options[static_cast<std::size_t>(number) % options.size()]);
  } else if constexpr (requires { I(BvhOptions{}); }) {
    constexpr std::array<BvhOptions, 4> options = {{{0}, {0.5}, {3}, {1e6}}};
    return I(options[static_cast<std::size_t>(number) % options.size()]);
  } else {
    return I();
  }
}

/// The message of an exception.
std::string message_of(const auto& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

/// The cube of size 1 at a position on the first axis.
template <class I>
typename I::Box cube(int place) {
  typename I::Box box;
  box.min *= 0;
  box.min[0] = static_cast<scalar_of<typename I::Box>>(place);
  box.max = box.min + scalar_of<typename I::Box>(1);
  return box;
}

/// Cubes in a row, at a distance of two units.
template <class I>
std::vector<Key> insert_row(I& index, int length) {
  std::vector<Key> keys;
  for (int k = 0; k < length; ++k) keys.push_back(index.insert(cube<I>(2 * k)));
  return keys;
}

template <class I>
class SpatialIndexLaws : public testing::Test {};
TYPED_TEST_SUITE_P(SpatialIndexLaws);

TYPED_TEST_P(SpatialIndexLaws, AnySequenceOfOperationsAnswersAsBruteForceDoes) {
  static_assert(SpatialIndex<TypeParam>);
  EXPECT_TRUE(rc::check([] {
    const double unit = *rc::gen::element(1.0, 0.1, 1e5);
    Trial<TypeParam>(index_number<TypeParam>(*rc::gen::inRange(0, 4)), unit).run(*any_steps());
  }));
}

TYPED_TEST_P(SpatialIndexLaws, AKeyIsAnErrorOnceItsBoxIsGoneOrInAnotherIndex) {
  TypeParam index;
  const Key key = index.insert(cube<TypeParam>(0));
  index.erase(key);
  const Key newcomer = index.insert(cube<TypeParam>(7));
  EXPECT_EQ(newcomer.index, key.index);  // the slot is reused
  EXPECT_EQ(message_of([&] { index.update(key, cube<TypeParam>(1)); }),
            "SpatialIndex: the key (index 0, generation 1) names no box any more; it was erased");
  TypeParam other;
  const Key foreign = other.insert(cube<TypeParam>(0));
  EXPECT_EQ(message_of([&] { index.erase(foreign); }),
            "SpatialIndex: the key (index 0, generation 1) belongs to another index");
  EXPECT_EQ(message_of([&] { index.box(Key{}); }),
            "SpatialIndex: the key (index 0, generation 0) is default-constructed; only insert returns keys");
  for (const Key& bad : {key, foreign, Key{}}) {
    EXPECT_FALSE(index.contains(bad));
    EXPECT_THROW(index.update(bad, cube<TypeParam>(1)), std::out_of_range);
    EXPECT_THROW(index.erase(bad), std::out_of_range);
    EXPECT_THROW(index.box(bad), std::out_of_range);
  }
  TypeParam copy = index;
  const Key of_copy = copy.insert(cube<TypeParam>(0));
  EXPECT_EQ(message_of([&] { index.box(of_copy); }),
            "SpatialIndex: the key (index 1, generation 1) belongs to another index");
  EXPECT_EQ(index.box(newcomer), cube<TypeParam>(7));
  EXPECT_EQ(index.size(), 1U);
}

TYPED_TEST_P(SpatialIndexLaws, ACopyLivesByItselfAndAnswersToTheSameKeys) {
  TypeParam index;
  const std::vector<Key> keys = insert_row(index, 20);
  TypeParam copy = index;
  index.erase(keys[3]);
  index.update(keys[4], cube<TypeParam>(100));
  EXPECT_EQ(copy.size(), 20U);
  EXPECT_EQ(copy.box(keys[3]), cube<TypeParam>(6));
  EXPECT_EQ(count(copy, cube<TypeParam>(8)), 1U);
  EXPECT_EQ(count(index, cube<TypeParam>(8)), 0U);
}

TYPED_TEST_P(SpatialIndexLaws, ABoxThatIsNoneIsRefusedAndNothingIsLost) {
  using Box = typename TypeParam::Box;
  using T = scalar_of<Box>;
  TypeParam index;
  const std::vector<Key> keys = insert_row(index, 20);
  Box nan = cube<TypeParam>(0);
  nan.max[0] = std::numeric_limits<T>::quiet_NaN();
  Box swapped = cube<TypeParam>(0);
  std::swap(swapped.min[1], swapped.max[1]);
  Box at_infinity = cube<TypeParam>(0);
  at_infinity.min[1] = at_infinity.max[1] = std::numeric_limits<T>::infinity();
  const auto insert = [&index](const Box& box) { return message_of([&] { index.insert(box); }); };
  EXPECT_EQ(insert(nan), "SpatialIndex: the box has a coordinate that is not a number");
  EXPECT_EQ(insert(swapped), "SpatialIndex: the box has a min above its max");
  EXPECT_EQ(insert(at_infinity),
            "SpatialIndex: the box lies at infinity; its min must be below +infinity, its max above -infinity");
  for (const Box& bad : {nan, swapped, at_infinity}) {
    EXPECT_THROW(index.update(keys[0], bad), std::invalid_argument);
  }
  EXPECT_EQ(index.size(), 20U);
  for (int k = 0; k < 20; ++k) EXPECT_EQ(index.box(keys[static_cast<std::size_t>(k)]), cube<TypeParam>(2 * k));
  EXPECT_EQ(index.insert(cube<TypeParam>(0)).index, 20U);
}

TYPED_TEST_P(SpatialIndexLaws, ABoxWithInfiniteSidesIsFoundWhereItReaches) {
  using Box = typename TypeParam::Box;
  using T = scalar_of<Box>;
  TypeParam index;
  insert_row(index, 20);
  Box half = cube<TypeParam>(50);
  half.max[0] = std::numeric_limits<T>::infinity();
  const Key key = index.insert(half);
  const Key everything = index.insert(Box::everything());
  const auto found = [&index](const auto& region) {
    std::vector<Key> keys;
    index.query(region, [&keys](Key k) { keys.push_back(k); });
    return keys;
  };
  using Point = decltype(half.min);
  Point far = half.min;
  far[0] = T(1e9);
  EXPECT_EQ(found(far), (std::vector{key, everything}));
  EXPECT_EQ((found(Sphere<dimension_of<Box>, T>{far, T(3)})), (std::vector{key, everything}));
  EXPECT_EQ(found(-far), std::vector{everything});
  EXPECT_EQ(index.nearest(far, 1), (std::vector<Neighbour>{{key, 0}}));
}

TYPED_TEST_P(SpatialIndexLaws, AQuestionAboutNonsenseIsRefused) {
  using Box = typename TypeParam::Box;
  using T = scalar_of<Box>;
  constexpr Dim N = dimension_of<Box>;
  TypeParam index;
  insert_row(index, 3);
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  const auto ignore = [](auto...) {};
  Box box = cube<TypeParam>(0);
  box.min[1] = nan;
  EXPECT_THROW(index.query(box, ignore), std::invalid_argument);
  EXPECT_EQ(message_of([&] {
              index.query(Sphere<N, T>{Vec<N, T>(T(0)), T(-1)}, ignore);
            }),
            "SpatialIndex: the region has a negative radius");
  EXPECT_THROW(index.nearest(Vec<N, T>(nan), 1), std::invalid_argument);
  EXPECT_EQ(message_of([&] {
              index.ray_cast(Ray<N, T>{Vec<N, T>(T(0)), Vec<N, T>(T(0))}, ignore);
            }),
            "SpatialIndex: the ray has a direction of length zero");
  EXPECT_THROW(index.cast(box, Vec<N, T>(T(1)), ignore), std::invalid_argument);
  EXPECT_EQ(message_of([&] { index.cast(cube<TypeParam>(0), Vec<N, T>(nan), ignore); }),
            "SpatialIndex: the motion has a number that is not finite");
}

TYPED_TEST_P(SpatialIndexLaws, TheVisitorEndsAVisitAndItsExceptionPassesThrough) {
  using Box = typename TypeParam::Box;
  TypeParam index;
  insert_row(index, 30);
  int visits = 0;
  index.query(Box::everything(), [&visits](Key) { return ++visits < 7; });
  EXPECT_EQ(visits, 7);
  visits = 0;
  const auto fail = [&visits](auto...) {
    ++visits;
    throw std::runtime_error("enough");
  };
  const Ray<dimension_of<Box>, scalar_of<Box>> along{cube<TypeParam>(0).min};
  EXPECT_THROW(index.query(Box::everything(), fail), std::runtime_error);
  EXPECT_THROW(index.ray_cast(along, fail), std::runtime_error);
  EXPECT_THROW(index.cast(cube<TypeParam>(0), along.direction, fail), std::runtime_error);
  index.insert(cube<TypeParam>(0));
  EXPECT_THROW(index.pairs(fail), std::runtime_error);
  EXPECT_EQ(visits, 4);
  EXPECT_EQ(count(index, Box::everything()), 31U);
}

/// Every way in which an index calls back with its boxes.
template <class I>
auto visits_of_all() {
  using Box = typename I::Box;
  using Ball = Sphere<dimension_of<Box>, scalar_of<Box>>;
  using Along = Ray<dimension_of<Box>, scalar_of<Box>>;
  using Visit = std::function<void(const I&, const std::function<void()>&)>;
  std::vector<Visit> visits = {
      [](const I& index, const auto& call) { index.query(Box::everything(), [&](Key) { call(); }); },
      [](const I& index, const auto& call) {
        index.query(Ball{cube<I>(0).min, 5}, [&](Key) { call(); });
      },
      [](const I& index, const auto& call) { index.ray_cast(Along{cube<I>(0).min}, [&](Key, double) { call(); }); },
      [](const I& index, const auto& call) { index.cast(cube<I>(0), cube<I>(0).min, [&](Key, double) { call(); }); },
      [](const I& index, const auto& call) { index.pairs([&](Key, Key) { call(); }); },
  };
  if constexpr (requires(const I& index) { index.visit_cells([](const auto&) {}); }) {
    visits.push_back([](const I& index, const auto& call) { index.visit_cells([&](const auto&) { call(); }); });
  }
  return visits;
}

TYPED_TEST_P(SpatialIndexLaws, AVisitorThatChangesTheIndexIsAnError) {
  using Box = typename TypeParam::Box;
  using Change = std::function<void(TypeParam&, const Key&)>;
  std::vector<std::pair<Change, std::size_t>> changes = {
      {[](TypeParam& index, const Key&) { index.insert(cube<TypeParam>(3)); }, 102},
      {[](TypeParam& index, const Key& key) { index.update(key, cube<TypeParam>(9)); }, 101},
      {[](TypeParam& index, const Key& key) { index.erase(key); }, 100},
      {[](TypeParam& index, const Key&) { index.clear(); }, 0},
  };
  if constexpr (requires(TypeParam & index) { index.assign(std::span<const Box>()); }) {
    changes.push_back({[](TypeParam& index, const Key&) { index.assign(std::vector<Box>(5, cube<TypeParam>(0))); }, 5});
  }
  for (const auto& [changing, left] : changes) {
    const Change& change = changing;  // Clang 14 captures no bindings
    for (const auto& visit : visits_of_all<TypeParam>()) {
      TypeParam index;
      const std::vector<Key> keys = insert_row(index, 100);  // enough for several cells
      index.insert(cube<TypeParam>(0));                      // so that there is a pair
      EXPECT_EQ(message_of([&] { visit(index, [&] { change(index, keys[5]); }); }),
                "SpatialIndex: a visitor changed the index that it visits; keep the keys and change it afterwards");
      EXPECT_EQ(index.size(), left);
      EXPECT_EQ(count(index, Box::everything()), left);
    }
  }
}

/// All that an index reports of its boxes, in order.
template <class I>
std::vector<std::pair<Key, double>> answers_of(const I& index) {
  using Box = typename I::Box;
  constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;
  std::vector<std::pair<Key, double>> answers;
  const auto note = [&answers](Key key) { answers.emplace_back(key, 0); };
  const auto note_hit = [&answers](Key key, double t) { answers.emplace_back(key, t); };
  for (int place = 0; place < 64; place += 5) {
    const Box box = cube<I>(place);
    index.query(box, note);
    index.query(Sphere<N, T>{box.min, T(7)}, note);
    index.ray_cast(Ray<N, T>{box.min, unit_axis<N, T>(0)}, note_hit);
    for (const Neighbour& near : index.nearest(box.max, 9)) answers.emplace_back(near.key, near.distance_squared);
  }
  return answers;
}

TYPED_TEST_P(SpatialIndexLaws, ManyThreadsMayAskAtOnceAndHearTheSame) {
  TypeParam index;
  const std::vector<Key> keys = insert_row(index, 100);
  for (std::size_t k = 0; k < keys.size(); k += 3) index.update(keys[k], cube<TypeParam>(static_cast<int>(k)));
  for (std::size_t k = 1; k < keys.size(); k += 7) index.erase(keys[k]);
  const auto expect_same = [](const TypeParam& reading) {
    const auto expected = answers_of(TypeParam(reading));  // from a copy, so that this index has not been queried yet
    std::vector<std::vector<std::pair<Key, double>>> heard(4);
    ThreadExecutor(heard.size()).parallel_for(heard.size(), [&](std::size_t k) { heard[k] = answers_of(reading); });
    EXPECT_GT(expected.size(), 500U);
    for (const auto& mine : heard) EXPECT_EQ(mine, expected);
  };
  expect_same(index);
  if constexpr (requires { index.assign(std::span<const typename TypeParam::Box>()); }) {
    std::vector<typename TypeParam::Box> boxes;
    for (int k = 0; k < 100; ++k) boxes.push_back(cube<TypeParam>(2 * k));
    index.assign(boxes);
    expect_same(index);
  }
}

TYPED_TEST_P(SpatialIndexLaws, RaysMeetBoxesInOrderAndEqualOnesByKey) {
  using Box = typename TypeParam::Box;
  constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;
  TypeParam index;
  const Key far = index.insert(cube<TypeParam>(8));
  const Key near = index.insert(cube<TypeParam>(2));
  const Key twin = index.insert(cube<TypeParam>(2));
  index.insert(cube<TypeParam>(-5));
  Ray<N, T> ray{Vec<N, T>(T(0)), Vec<N, T>(T(0))};
  ray.direction[0] = T(2);
  std::vector<std::pair<Key, double>> hits;
  index.ray_cast(ray, [&hits](Key key, double t) { hits.emplace_back(key, t); });
  EXPECT_EQ(hits, (std::vector<std::pair<Key, double>>{{near, 1}, {twin, 1}, {far, 4}}));
  const Key around = index.insert({Vec<N, T>(T(-1)), Vec<N, T>(T(9))});
  hits.clear();
  index.ray_cast(ray, [&hits](Key key, double t) {
    hits.emplace_back(key, t);
    return false;
  });
  EXPECT_EQ(hits, (std::vector<std::pair<Key, double>>{{around, 0}}));
}

TYPED_TEST_P(SpatialIndexLaws, AMovingBoxMeetsBoxesInOrderAndEqualOnesByKey) {
  using Box = typename TypeParam::Box;
  constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;
  using Hits = std::vector<std::pair<Key, double>>;
  TypeParam index;
  const Key far = index.insert(cube<TypeParam>(8));
  const Key near = index.insert(cube<TypeParam>(4));
  const Key twin = index.insert(cube<TypeParam>(4));
  index.insert(cube<TypeParam>(-5));
  Vec<N, T> motion(T(0));
  const auto hits_of = [&](const Box& box, std::size_t most) {
    Hits hits;
    index.cast(box, motion, [&](Key key, double t) {
      hits.emplace_back(key, t);
      return hits.size() < most;
    });
    return hits;
  };
  const T side = cube<TypeParam>(0).max[0];  // cubes begin at their number
  const Box mover = cube<TypeParam>(0);
  motion[0] = 2 * (T(8) - side);
  const double t_near = static_cast<double>(T(4) - side) / static_cast<double>(motion[0]);
  EXPECT_EQ(hits_of(mover, 9), (Hits{{near, t_near}, {twin, t_near}, {far, 0.5}}));
  EXPECT_EQ(hits_of(mover, 1), (Hits{{near, t_near}}));
  motion[0] = T(8) - side;
  EXPECT_EQ(hits_of(mover, 9).back(), (std::pair<Key, double>{far, 1}));  // it arrives
  motion[0] = T(0);
  EXPECT_TRUE(hits_of(mover, 9).empty());
  EXPECT_EQ(hits_of(cube<TypeParam>(4), 9), (Hits{{near, 0}, {twin, 0}}));
}

TYPED_TEST_P(SpatialIndexLaws, TheNearestComeByDistanceAndEqualOnesByKey) {
  using Box = typename TypeParam::Box;
  TypeParam index;
  const std::vector<Key> keys = insert_row(index, 4);  // from 0, 2, 4, 6 on
  auto from = cube<TypeParam>(3).min;
  using Neighbours = std::vector<Neighbour>;
  EXPECT_EQ(index.nearest(from, 3), (Neighbours{{keys[1], 0}, {keys[2], 1}, {keys[0], 4}}));
  EXPECT_EQ(index.nearest(cube<TypeParam>(5).min, 2), (Neighbours{{keys[2], 0}, {keys[3], 1}}));
  from[0] = static_cast<scalar_of<Box>>(3.5);
  EXPECT_EQ(index.nearest(from, 2), (Neighbours{{keys[1], 0.25}, {keys[2], 0.25}}));
  EXPECT_EQ(index.nearest(from, 9).size(), 4U);
  EXPECT_TRUE(index.nearest(from, 0).empty());
  index.clear();
  EXPECT_TRUE(index.nearest(from, 5).empty());
}

TYPED_TEST_P(SpatialIndexLaws, ThePlacesOfErasedBoxesAreUsedAgain) {
  TypeParam index;
  for (int round = 0; round < 50; ++round) {
    const std::vector<Key> keys = insert_row(index, 40);
    for (const Key& key : keys) EXPECT_LT(key.index, 40U);
    for (std::size_t k = 0; k < keys.size(); ++k) index.erase(keys[k * 7 % keys.size()]);
    EXPECT_EQ(index.size(), 0U);
  }
}

REGISTER_TYPED_TEST_SUITE_P(SpatialIndexLaws, AnySequenceOfOperationsAnswersAsBruteForceDoes,
                            AKeyIsAnErrorOnceItsBoxIsGoneOrInAnotherIndex, ACopyLivesByItselfAndAnswersToTheSameKeys,
                            ABoxThatIsNoneIsRefusedAndNothingIsLost, ABoxWithInfiniteSidesIsFoundWhereItReaches,
                            AQuestionAboutNonsenseIsRefused, TheVisitorEndsAVisitAndItsExceptionPassesThrough,
                            AVisitorThatChangesTheIndexIsAnError, ManyThreadsMayAskAtOnceAndHearTheSame,
                            RaysMeetBoxesInOrderAndEqualOnesByKey, AMovingBoxMeetsBoxesInOrderAndEqualOnesByKey,
                            TheNearestComeByDistanceAndEqualOnesByKey, ThePlacesOfErasedBoxesAreUsedAgain);

}  // namespace graze::test
