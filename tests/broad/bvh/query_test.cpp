// SPDX-License-Identifier: MIT
// Counts the nodes that a walk visits; spatial_index_laws.hpp compares what it finds with BruteForce.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/query/distance_squared.hpp>

#include "broad/box_worlds.hpp"
#include "broad/bvh_checks.hpp"
#include "broad/simd_targets.hpp"
#include "number_of_cases.hpp"

namespace graze::detail::bvh_query_test {
namespace {

/// A row of unit cubes with gaps, inserted one by one from one end to the other.
template <Dim N, class T>
BvhTree<N, T> row(std::uint32_t length) {
  BvhTree<N, T> tree(0);
  for (std::uint32_t k = 0; k < length; ++k) {
    Vec<N, T> low(T(0));
    low[0] = static_cast<T>(2 * k);
    tree.insert(k, {low, low + T(1)});
  }
  return tree;
}

constexpr std::uint32_t length = 1U << 14U;

/// Nodes on the path to a box, and as many beside it whose bounds contain it, too. A tree of this many boxes has at
/// most six levels.
constexpr std::size_t path = 2 * 6;

TEST(BvhQuery, LooksAtOnePathForOneBox) {
  const BvhTree<2, float> tree = row<2, float>(length);
  for (std::uint32_t k = 0; k < length; k += 97) {
    const test::Effort effort = test::effort_of(tree, tree.box(k));
    EXPECT_EQ(effort.found, 1U);
    EXPECT_LE(effort.looks, path);
  }
  EXPECT_EQ(test::effort_of(tree, Aabb<2>{{0, 5}, {1e6F, 6}}).looks, 1U);
  EXPECT_EQ(test::effort_of(tree, Aabb<2>{{100, 0}, {198.5F, 1}}).found, 50U);
  EXPECT_LE(test::effort_of(tree, Aabb<2>{{100, 0}, {198.5F, 1}}).looks, 50 / bvh_least + path);
}

TEST(BvhQuery, EndsWhenTheVisitorDoes) {
  const BvhTree<2, float> tree = row<2, float>(1000);
  const test::CountingRegion<2, float> counting{Aabb<2>::everything()};
  const RegionProbe<Aabb<2>> everything(Aabb<2>::everything());
  const auto visits_of = [&tree](const auto& probe) {
    int visits = 0;
    EXPECT_FALSE(visit_met(tree, probe, [&visits](const BvhName&) { return ++visits < 3; }));
    EXPECT_TRUE(visit_met(tree, probe, [](const BvhName&) { return true; }));
    return visits;
  };
  EXPECT_EQ(visits_of(everything), 3);
  counting.looks = 0;
  int visits = 0;
  EXPECT_FALSE(visit_met(tree, counting, [&visits](const BvhName&) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
  EXPECT_LE(counting.looks, 4 * block_size);  // the children of one path
}

/// More than a walk can store at once.
TEST(BvhQuery, FindsAllOfManyOnce) {
  const BvhTree<2, float> tree = row<2, float>(length);
  std::vector<int> visits(length);
  const RegionProbe<Aabb<2>> everything(Aabb<2>::everything());
  EXPECT_TRUE(visit_met(tree, everything, [&visits](const BvhName& name) { return ++visits[name.slot] > 0; }));
  EXPECT_EQ(visits, std::vector<int>(length, 1));
}

TEST(BvhQuery, FollowsARayOnlyAsFarAsItIsAsked) {
  const BvhTree<3, double> tree = row<3, double>(length);
  const Ray<3, double> along{{-10, 0.5, 0.5}, {1, 0, 0}};
  std::vector<std::pair<std::uint32_t, double>> hits;
  visit_along(tree, along, [&hits](const BvhName& name, double t) {
    hits.emplace_back(name.slot, t);
    return hits.size() < 3;
  });
  EXPECT_EQ(hits, (std::vector<std::pair<std::uint32_t, double>>{{0, 10}, {1, 12}, {2, 14}}));
  hits.clear();
  visit_along(tree, along, [&hits](const BvhName& name, double t) {
    hits.emplace_back(name.slot, t);
    return true;
  });
  ASSERT_EQ(hits.size(), length);
  for (std::uint32_t k = 0; k < length; ++k) EXPECT_EQ(hits[k], (std::pair<std::uint32_t, double>{k, 10 + 2.0 * k}));
}

TEST(BvhQuery, TheFirstBoxOnARayTakesOnePathDown) {
  const BvhTree<3, double> tree = row<3, double>(length);
  for (const double x : {-10.0, 3.25, 30'000.5}) {
    const Ray<3, double> along{{x, 0.5, 0.5}, {1, 0, 0}};
    const std::optional<BvhHit> first = first_along(tree, along);
    const double slot = std::max(0.0, std::ceil((x - 1) / 2));  // boxes from 2 slot to 2 slot + 1
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->name.slot, static_cast<std::uint32_t>(slot));
    EXPECT_EQ(first->t, std::max(0.0, 2 * slot - x));
    BvhFirstWalk<3, double> walk{
        along, slabs_of(along, finite_size(tree.bounds())), std::numeric_limits<double>::infinity(), {0, 0}};
    EXPECT_LE((bvh_kernels<3, double>().find_first(tree.nodes(), tree.root(), walk)), path);
    EXPECT_EQ(walk.name, first->name);
  }
  const Ray<3, double> beside{{-10, 0.5, 2}, {1, 0, 0}};
  EXPECT_FALSE(first_along(tree, beside).has_value());
}

TEST(BvhQuery, OfBoxesOnARayAtOncePrefersTheLowestSlot) {
  for (const double margin : {0.0, 0.5}) {
    BvhTree<3, double> tree(margin);
    const Aabb<3, double> box{{4, 0, 0}, {5, 1, 1}};
    for (const std::uint32_t slot : {7U, 3U, 9U, 5U}) tree.insert(slot, box, 10 * slot);
    tree.insert(1, {{6, 0, 0}, {7, 1, 1}}, 10);
    tree.insert(2, {{4, -1, 0}, {std::numeric_limits<double>::infinity(), 1, 1}}, 20);  // beside the tree
    const Ray<3, double> along{{0, 0.5, 0.5}, {2, 0, 0}};
    std::vector<BvhHit> hits;
    visit_along(tree, along, [&hits](const BvhName& name, double t) {
      hits.push_back({t, name});
      return true;
    });
    EXPECT_EQ(hits, (std::vector<BvhHit>{
                        {2, {2, 20}}, {2, {3, 30}}, {2, {5, 50}}, {2, {7, 70}}, {2, {9, 90}}, {3, {1, 10}}}));
    EXPECT_EQ(first_along(tree, along), (BvhHit{2, {2, 20}}));
  }
}

TEST(BvhQuery, LooksForTheNearestOnlyNearby) {
  const BvhTree<3, double> tree = row<3, double>(length);
  for (const double x : {-5.0, 1.25, 20'001.5, 1e6}) {
    NearestKeys nearest(1);
    EXPECT_LE(find_near(tree, Vec<3, double>(x, 0.5, 0.5), nearest), path) << x;
    const double right_of_box = std::fmod(x, 2) - 1;
    const double distance = x < 0 ? 5 : x > 1e5 ? 1e6 - 2 * length + 1 : std::min(right_of_box, 1 - right_of_box);
    EXPECT_EQ(nearest.reach(), distance * distance) << x;
  }
}

/// With difficult directions.
template <class T>
Ray<3, T> nasty_ray(test::Numbers& numbers, double size) {
  constexpr T tiny = std::numeric_limits<T>::denorm_min();
  constexpr T huge = std::numeric_limits<T>::max();
  const std::array<T, 8> odd = {T(0), T(-0.0), T(1), T(-1), tiny, -tiny, huge, -huge};
  Ray<3, T> ray{numbers.point<3, T>(-size, size), numbers.point<3, T>(-1, 1)};
  for (Dim i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(numbers.between(0, 16));
    if (k < odd.size()) ray.direction[i] = odd[k];
  }
  return ray;
}

/// The largest and smallest numbers: a ray enters exactly what entry_of reports for each box.
template <class T>
void expect_hits_as_box_by_box(double size, std::uint64_t seed) {
  test::Numbers numbers(seed);
  BvhTree<3, T> tree(0);
  constexpr std::uint32_t count = 300;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec<3, T> low = numbers.point<3, T>(-size, size);
    const Vec<3, T> extent = numbers.point<3, T>(0, k % 10 == 0 ? size : size / 10);
    const Aabb<3, T> box{low, low + extent};
    tree.insert(k, is_valid(box) ? box : Aabb<3, T>{low, low});
  }
  std::size_t all = 0;
  for (int round = 0; round < 200; ++round) {
    Ray<3, T> ray = nasty_ray<T>(numbers, size);
    if (round % 3 == 0) ray.origin = tree.box(7).min;  // at a corner
    if (!is_valid(ray)) continue;
    std::vector<BvhHit> expected;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::optional<double> t = entry_of(ray, tree.box(k));
      if (t) expected.push_back({*t, {k, 0}});
    }
    std::sort(expected.begin(), expected.end());
    std::vector<BvhHit> hits;
    visit_along(tree, ray, [&hits](const BvhName& name, double t) {
      hits.push_back({t, name});
      return true;
    });
    EXPECT_EQ(hits, expected) << size << ", round " << round;
    all += hits.size();
  }
  EXPECT_GT(all, 100U) << size;
}

TEST(BvhQuery, ARayEntersWhatItEntersBoxByBox) {
  for (const double size : {1.0, 1e-42, 1e-30, 1e18, 1e35, 3e38}) expect_hits_as_box_by_box<float>(size, 1);
  for (const double size : {1.0, 1e-320, 1e-300, 1e150, 1e304, 1.7e307}) expect_hits_as_box_by_box<double>(size, 2);
}

/// The same for distances.
template <class T>
void expect_distances_as_box_by_box(double size, std::uint64_t seed) {
  test::Numbers numbers(seed);
  BvhTree<3, T> tree(0);
  constexpr std::uint32_t count = 300;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec<3, T> low = numbers.point<3, T>(-size, size);
    tree.insert(k, {low, low});
  }
  for (std::size_t round = 0; round < test::number_of_cases(100); ++round) {
    const Vec<3, T> point = round % 4 == 0 ? tree.box(9).min : numbers.point<3, T>(-2 * size, 2 * size);
    if (!is_finite(point)) continue;
    for (const std::size_t k : {1U, 3U, 8U, 9U, 40U, 300U}) {
      NearestKeys expected(k);
      NearestKeys nearest(k);
      for (std::uint32_t slot = 0; slot < count; ++slot) {
        expected.offer({{slot, 0, 0}, distance_squared(point, tree.box(slot))});
      }
      find_near(tree, point, nearest);
      EXPECT_EQ(nearest.sorted(), expected.sorted()) << size << ", round " << round << ", " << k;
      const Aabb<3, T> from{min(point, tree.box(7).min), max(point, tree.box(7).min)};
      NearestKeys expected_near_box(k);
      NearestKeys near_box(k);
      for (std::uint32_t slot = 0; slot < count; ++slot) {
        expected_near_box.offer({{slot, 0, 0}, distance_squared(from, tree.box(slot))});
      }
      find_near(tree, from, near_box);
      EXPECT_EQ(near_box.sorted(), expected_near_box.sorted()) << size << ", round " << round << ", " << k;
    }
  }
}

TEST(BvhQuery, TheNearestAreThoseBoxByBox) {
  for (const double size : {1.0, 1e-42, 1e-20, 1e18, 1e25, 1e38}) expect_distances_as_box_by_box<float>(size, 3);
  for (const double size : {1.0, 1e-320, 1e-160, 1e150, 1e304}) expect_distances_as_box_by_box<double>(size, 4);
}

/// Boxes on a lattice, every third of them extended, some beside the tree: among equally near boxes, also if there are
/// more than a walk can store, the lowest slots count.
template <Dim N, class T>
void expect_lowest_slots_of_equally_near(int size, T reach) {
  test::Numbers numbers(5);
  BvhTree<N, T> tree(0);
  constexpr std::uint32_t count = 900;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t slot = k * 7 % count;
    Vec<N, T> low;
    for (Dim i = 0; i < N; ++i) low[i] = static_cast<T>(static_cast<int>(numbers.between(0, size)));
    Aabb<N, T> box{low, low};
    if (slot % 3 == 0) box = {low - reach, low + reach};
    if (slot % 200 == 13) box.max[0] = std::numeric_limits<T>::infinity();
    tree.insert(slot, box);
  }
  for (std::size_t round = 0; round < test::number_of_cases(60); ++round) {
    Vec<N, T> point;
    for (Dim i = 0; i < N; ++i) point[i] = static_cast<T>(static_cast<int>(numbers.between(-5 * size, 5 * size))) / 2;
    for (const std::size_t k : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 33U}) {
      NearestKeys expected(k);
      NearestKeys nearest(k);
      for (std::uint32_t slot = 0; slot < count; ++slot) {
        expected.offer({{slot, 0, 0}, distance_squared(point, tree.box(slot))});
      }
      find_near(tree, point, nearest);
      EXPECT_EQ(nearest.sorted(), expected.sorted()) << "round " << round << ", " << k;
    }
  }
}

/// Many boxes at each position, or one at each position but as far away as others on the opposite side.
template <Dim N, class T>
void expect_lowest_slots_of_equally_near() {
  expect_lowest_slots_of_equally_near<N, T>(6, 8);
  expect_lowest_slots_of_equally_near<N, T>(12, 1);
  expect_lowest_slots_of_equally_near<N, T>(40, 0);
}

TEST(BvhQuery, OfEquallyNearBoxesTheLowestSlotsAreFound) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    expect_lowest_slots_of_equally_near<2, float>();
    expect_lowest_slots_of_equally_near<3, float>();
    expect_lowest_slots_of_equally_near<2, double>();
    expect_lowest_slots_of_equally_near<3, double>();
  }
}

/// Boxes at 1, 2, and so on, and some that share the position of the last wanted one.
struct SharedLastPlace {
  std::uint32_t wanted;
  std::uint32_t sharing;
  std::uint32_t lowest;    // which of them has the lowest slot
  bool is_first_infinite;  // and is therefore beside the tree
};

template <Dim N, class T>
void expect_lowest_slot_in(const SharedLastPlace& place) {
  BvhTree<N, T> tree(0);
  Vec<N, T> at(T(0));
  for (std::uint32_t k = 1; k < place.wanted; ++k) {
    at[0] = static_cast<T>(k);
    tree.insert(place.sharing + k, {at, at});
  }
  at[0] = static_cast<T>(place.wanted);
  for (std::uint32_t k = 0; k < place.sharing; ++k) {
    Aabb<N, T> box{at, at};
    if (k == 0 && place.is_first_infinite) box.max[0] = std::numeric_limits<T>::infinity();
    tree.insert((k + place.sharing - place.lowest) % place.sharing, box);
  }
  std::vector<Neighbour> expected;
  for (std::uint32_t k = 1; k <= place.wanted; ++k) {
    const std::uint32_t slot = k < place.wanted ? place.sharing + k : 0;
    expected.push_back({{slot, 0, 0}, static_cast<double>(k) * k});
  }
  NearestKeys nearest(place.wanted);
  find_near(tree, Vec<N, T>(T(0)), nearest);
  EXPECT_EQ(nearest.sorted(), expected) << place.wanted << " wanted, " << place.sharing << " share the last place, "
                                        << place.lowest << (place.is_first_infinite ? ", one infinite" : "");
}

TEST(BvhQuery, OfBoxesThatShareTheLastPlaceTheLowestSlotIsFound) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    for (std::uint32_t wanted = 1; wanted <= 10; ++wanted) {
      for (const std::uint32_t sharing : {2U, 3U, 9U, 100U}) {
        for (const std::uint32_t lowest : {0U, 1U, sharing / 2, sharing - 1}) {
          for (const bool is_first_infinite : {false, true}) {
            const SharedLastPlace place{wanted, sharing, lowest, is_first_infinite};
            expect_lowest_slot_in<2, float>(place);
            expect_lowest_slot_in<3, double>(place);
          }
        }
      }
    }
  }
}

TEST(BvhQuery, FindsAsManyAsThereAreWhereMoreAreWanted) {
  for (const std::uint32_t count : {1U, 5U, 7U, 40U}) {
    const BvhTree<2, float> tree = row<2, float>(count);
    for (const std::size_t k : {1U, 6U, 8U, 50U}) {
      NearestKeys nearest(k);
      find_near(tree, Vec<2>(-1, 0), nearest);
      const std::vector<Neighbour> sorted = nearest.sorted();
      ASSERT_EQ(sorted.size(), std::min<std::size_t>(k, count));
      for (std::uint32_t slot = 0; slot < sorted.size(); ++slot) {
        const double distance = 2.0 * slot + 1;
        EXPECT_EQ(sorted[slot], (Neighbour{{slot, 0, 0}, distance * distance}));
      }
    }
  }
}

/// In the order of their entries, although the path is diagonal and nodes overlap.
template <Dim N, class T>
void check_swept_boxes() {
  test::Numbers numbers(20'261'128);
  BvhTree<N, T> tree(0.5);
  constexpr std::uint32_t count = 2000;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec<N, T> low = numbers.point<N, T>(0, 60);
    tree.insert(k, {low, low + numbers.point<N, T>(0, 3)});
  }
  tree.insert(count, Aabb<N, T>::everything());
  for (int round = 0; round < 50; ++round) {
    const Vec<N, T> low = numbers.point<N, T>(0, 60);
    const SweptBox<N> sweep = swept_box_of(Aabb<N, T>{low, low + T(2)}, numbers.point<N, T>(-60, 60));
    std::vector<std::pair<double, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k <= count; ++k) {
      if (const std::optional<double> t = sweep.entry(tree.box(k))) expected.emplace_back(*t, k);
    }
    std::sort(expected.begin(), expected.end());
    const double limit = expected[expected.size() / 2].first;
    std::vector<std::pair<double, std::uint32_t>> all;
    std::vector<std::pair<double, std::uint32_t>> up_to_limit;
    const auto into = [](auto& list, double most) {
      return [&list, most](const BvhName& name, double t) {
        list.emplace_back(t, name.slot);
        return most;
      };
    };
    const auto entry = [&sweep](const Aabb<N, T>& box) { return sweep.entry(box); };
    visit_swept(tree, sweep, entry, into(all, 1.0));
    EXPECT_EQ(all, expected);
    visit_swept(tree, sweep, entry, into(up_to_limit, limit));
    std::erase_if(expected, [limit](const auto& each) { return each.first > limit; });
    EXPECT_EQ(up_to_limit, expected);
  }
}

TEST(BvhQuery, VisitsWhatAMovingBoxMayTouchInOrder) {
  check_swept_boxes<2, float>();
  check_swept_boxes<3, float>();
  check_swept_boxes<2, double>();
  check_swept_boxes<3, double>();
  const SweptBox<2> sweep = swept_box_of(Aabb<2>{}, Vec<2>(1, 0));
  const auto entry = [&sweep](const Aabb<2>& box) { return sweep.entry(box); };
  visit_swept(BvhTree<2, float>(0), sweep, entry, [](const BvhName&, double) -> double {
    ADD_FAILURE();
    return 0;
  });
}

}  // namespace
}  // namespace graze::detail::bvh_query_test
