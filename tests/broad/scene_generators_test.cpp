// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>

#include "spaces.hpp"

namespace graze::worlds_test {
namespace {

constexpr std::size_t thousands = 5000;

template <class Space>
class WorldsTest : public testing::Test {};

TYPED_TEST_SUITE(WorldsTest, test::Spaces);

/// The extents of a box along each axis, in double.
template <Dim N, class T>
Vec<N, double> widths(const Aabb<N, T>& box) {
  return wide<N, T>(box.max) - wide<N, T>(box.min);
}

template <Dim N, class T>
double volume(const Aabb<N, T>& box) {
  const Vec<N, double> edges = widths(box);
  double product = 1;
  for (Dim i = 0; i < N; ++i) product *= edges[i];
  return product;
}

template <Dim N, class T>
bool is_within(const Aabb<N, T>& inner, const Aabb<N, T>& outer) {
  for (Dim i = 0; i < N; ++i) {
    if (inner.min[i] < outer.min[i] || inner.max[i] > outer.max[i]) return false;
  }
  return true;
}

template <Dim N, class T>
double pairs_per_box(const MovingBoxes<N, T>& world) {
  const std::vector<Pair> pairs = overlapping_pairs<N, T>(world.boxes());
  return static_cast<double>(pairs.size()) / static_cast<double>(world.boxes().size());
}

/// FNV-1a over the bits of all coordinates (Fowler, Noll and Vo).
template <Dim N, class T>
std::uint64_t hash_of(std::span<const Aabb<N, T>> boxes) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Aabb<N, T>& box : boxes) {
    for (const Vec<N, T>& corner : {box.min, box.max}) {
      for (Dim i = 0; i < N; ++i) hash = (hash ^ std::bit_cast<Bits>(corner[i])) * 0x100000001b3U;
    }
  }
  return hash;
}

TEST(Worlds, AreFoundByTheirNames) {
  EXPECT_EQ(all_worlds().size(), 8U);
  std::set<std::string> names;
  for (const World world : all_worlds()) {
    EXPECT_EQ(world_named(name_of(world)), world);
    names.insert(std::string(name_of(world)));
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"brownian", "heavy", "cluster", "line", "plane", "lattice", "giants", "point"}));
  EXPECT_EQ(name_of(World::brownian), "brownian");
  EXPECT_EQ(name_of(World::point), "point");
  EXPECT_FALSE(world_named("Brownian"));
  EXPECT_FALSE(world_named(""));
}

TYPED_TEST(WorldsTest, HaveAsManyBoxesAsAskedForAllOfThemValid) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 100U}) {
      SCOPED_TRACE(std::string(name_of(world)) + ", " + std::to_string(count) + " boxes");
      MovingBoxes<N, T> boxes(world, count, 1);
      for (int frame = 0; frame < 3; ++frame, boxes.step()) {
        ASSERT_EQ(boxes.boxes().size(), count);
        for (const Aabb<N, T>& box : boxes.boxes()) EXPECT_EQ(defect(box), "");
      }
    }
  }
}

TYPED_TEST(WorldsTest, HaveAFewPairsPerBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    if (world == World::lattice || world == World::point) continue;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const double pairs = pairs_per_box(MovingBoxes<N, T>(world, thousands, seed));
      EXPECT_GT(pairs, 0.5) << name_of(world) << ", seed " << seed;
      EXPECT_LT(pairs, 4) << name_of(world) << ", seed " << seed;
    }
  }
}

TYPED_TEST(WorldsTest, StayAsDenseWhileTheyMove) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    MovingBoxes<N, T> boxes(world, 1000, 4);
    const double before = pairs_per_box(boxes);
    for (int frame = 0; frame < 200; ++frame) boxes.step();
    const double after = pairs_per_box(boxes);
    EXPECT_GT(after, 0.7 * before) << name_of(world);
    EXPECT_LT(after, 1.3 * before) << name_of(world);
  }
}

TYPED_TEST(WorldsTest, MoveEveryBoxByATenthOfAUnitAtMostAndStayWithinTheirBounds) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    SCOPED_TRACE(name_of(world));
    MovingBoxes<N, T> boxes(world, 300, 5);
    const Aabb<N, T> bounds = boxes.bounds();
    // The rounding to T at either end of a step.
    const double rounding = max_abs(wide<N, T>(bounds.max)) * static_cast<double>(std::numeric_limits<T>::epsilon());
    std::vector<Aabb<N, T>> before;
    for (int frame = 0; frame < 100; ++frame) {
      before.assign(boxes.boxes().begin(), boxes.boxes().end());
      boxes.step();
      EXPECT_NE((hash_of<N, T>(before)), hash_of(boxes.boxes()));
      for (std::size_t k = 0; k < before.size(); ++k) {
        const Aabb<N, T>& box = boxes.boxes()[k];
        EXPECT_TRUE(is_within(box, bounds));
        EXPECT_LE(max_abs(wide<N, T>(box.min) - wide<N, T>(before[k].min)), 0.1 + rounding);
        EXPECT_LE(max_abs(widths(box) - widths(before[k])), 2 * rounding) << "a box changed its size";
      }
    }
    EXPECT_EQ(boxes.bounds(), bounds);
  }
}

TYPED_TEST(WorldsTest, EqualSeedsGiveEqualBoxesAndOtherSeedsGiveOthers) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    if (world == World::lattice) continue;  // only its motion is random
    MovingBoxes<N, T> first(world, 100, 7);
    MovingBoxes<N, T> second(world, 100, 7);
    const MovingBoxes<N, T> other(world, 100, 8);
    EXPECT_NE(hash_of(first.boxes()), hash_of(other.boxes())) << name_of(world);
    for (int frame = 0; frame < 3; ++frame, first.step(), second.step()) {
      EXPECT_EQ(hash_of(first.boxes()), hash_of(second.boxes()));
    }
  }
}

TYPED_TEST(WorldsTest, BoxesAreThoseOfDoubleRounded) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : all_worlds()) {
    MovingBoxes<N, T> boxes(world, 100, 6);
    MovingBoxes<N, double> exact(world, 100, 6);
    for (int frame = 0; frame < 3; ++frame, boxes.step(), exact.step()) {
      for (std::size_t k = 0; k < 100; ++k) {
        EXPECT_EQ(boxes.boxes()[k].min, (Vec<N, T>(exact.boxes()[k].min))) << name_of(world);
        EXPECT_EQ(boxes.boxes()[k].max, (Vec<N, T>(exact.boxes()[k].max))) << name_of(world);
      }
    }
  }
}

/// The walls that contain the centers of a scene, derived from its bounds.
template <Dim N, class T>
Vec<N, double> wall_widths(const MovingBoxes<N, T>& world) {
  Vec<N, double> largest(0.0);
  for (const Aabb<N, T>& box : world.boxes()) {
    for (Dim i = 0; i < N; ++i) largest[i] = std::max(largest[i], widths(box)[i]);
  }
  return widths(world.bounds()) - largest;
}

TYPED_TEST(WorldsTest, BrownianHasTheDensityThatWasPublished) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const MovingBoxes<N, T> world(World::brownian, 20000, 1);
  const Vec<N, double> walls = wall_widths(world);
  double room = 1;
  for (Dim i = 0; i < N; ++i) room *= walls[i];
  EXPECT_NEAR(20000 / room, N == 2 ? 0.3 : 0.1, 1e-4);
  double sum = 0;
  for (const Aabb<N, T>& box : world.boxes()) {
    const Vec<N, double> edges = widths(box);
    for (Dim i = 0; i < N; ++i) {
      sum += edges[i];
      EXPECT_GE(edges[i], 1 - 1e-5);
      EXPECT_LE(edges[i], std::sqrt(static_cast<double>(N)) + 1e-5);
    }
  }
  // The mean width of the unit square and of the unit cube over all directions: its perimeter / pi, and 3 / 2.
  EXPECT_NEAR(sum / (20000 * N), N == 2 ? 1.2732 : 1.5, 0.01);
  EXPECT_NEAR(pairs_per_box(world), N == 2 ? 0.97 : 1.31, 0.05);
}

TYPED_TEST(WorldsTest, HeavyHasBoxesOfAllSizesWhoseVolumesAddUp) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const MovingBoxes<N, T> world(World::heavy, thousands, 1);
  double sum = 0;
  std::vector<double> sizes;
  for (const Aabb<N, T>& box : world.boxes()) {
    sum += volume(box);
    sizes.push_back(std::pow(volume(box), 1.0 / N));
  }
  const Vec<N, double> walls = wall_widths(world);
  double room = 1;
  for (Dim i = 0; i < N; ++i) room *= walls[i];
  EXPECT_NEAR(sum / room, 1, 1e-4);
  std::sort(sizes.begin(), sizes.end());
  EXPECT_GE(sizes.front(), 1 - 1e-3);
  EXPECT_LE(sizes.back(), 1000 * std::sqrt(static_cast<double>(N)));
  // One in s is s times as large as its cube would be otherwise: the mean width is 1.27 in 2D, 1.5 in 3D.
  const double one = N == 2 ? 1.27 : 1.5;
  EXPECT_NEAR(sizes[thousands / 2], 2 * one, 0.3 * one);
  EXPECT_NEAR(sizes[thousands - thousands / 10], 10 * one, 1.5 * one);
  EXPECT_NEAR(sizes[thousands - thousands / 100], 92 * one, 25 * one);
}

TYPED_TEST(WorldsTest, ClusterHasCloudsFarApart) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  struct Cloud {
    Aabb<N, T> box;
    std::size_t boxes;
  };
  for (const std::size_t count : {thousands, std::size_t{120000}}) {
    const MovingBoxes<N, T> world(World::cluster, count, 1);
    const double near = widths(world.bounds())[0] / (count == thousands ? 10 : 40);
    std::vector<Cloud> clouds;
    for (const Aabb<N, T>& box : world.boxes()) {
      const auto own = std::find_if(clouds.begin(), clouds.end(), [&](const Cloud& cloud) {
        return max_abs(wide<N, T>(cloud.box.center()) - wide<N, T>(box.center())) < near;
      });
      if (own == clouds.end()) {
        clouds.push_back({box, 1});
      } else {
        own->box.grow(box);
        ++own->boxes;
      }
    }
    EXPECT_EQ(clouds.size(), count == thousands ? 8U : 12U);
    const auto by_boxes = [](const Cloud& a, const Cloud& b) { return a.boxes < b.boxes; };
    const auto by_volume = [](const Cloud& a, const Cloud& b) { return volume(a.box) < volume(b.box); };
    const auto [fewest, most] = std::minmax_element(clouds.begin(), clouds.end(), by_boxes);
    const auto [least, greatest] = std::minmax_element(clouds.begin(), clouds.end(), by_volume);
    EXPECT_GT(most->boxes, 3 * fewest->boxes);
    EXPECT_GT(volume(greatest->box), 4 * volume(least->box));
    EXPECT_LT(max_abs(widths(greatest->box)), near);
  }
}

TYPED_TEST(WorldsTest, LinesPlanesAndPointsStayFlat) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const World world : {World::line, World::plane}) {
    MovingBoxes<N, T> boxes(world, 500, 1);
    const Dim extended = world == World::line || N == 2 ? 1 : N - 1;
    for (int frame = 0; frame < 20; ++frame, boxes.step()) {
      for (const Aabb<N, T>& box : boxes.boxes()) {
        for (Dim i = extended; i < N; ++i) EXPECT_EQ(box.min[i], -box.max[i]) << name_of(world);
      }
    }
    for (Dim i = 0; i < extended; ++i) EXPECT_GT(wall_widths(boxes)[i], 30) << name_of(world);
  }
  MovingBoxes<N, T> point(World::point, 60, 1);
  for (int frame = 0; frame < 20; ++frame, point.step()) EXPECT_EQ(pairs_per_box(point), 59.0 / 2);
}

TYPED_TEST(WorldsTest, LatticesTouchTheirNeighboursAndNoOthersForEver) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::size_t side = 12;
  constexpr std::size_t count = N == 2 ? side * side : side * side * side;
  // Touching positions are kings' moves: along each axis 3 side - 2 ordered pairs of numbers at most one apart; without
  // the positions themselves, and each pair once, (34^N - 12^N) / 2.
  constexpr std::size_t pairs = N == 2 ? 506 : 18788;
  MovingBoxes<N, T> world(World::lattice, count, 1);
  for (const Aabb<N, T>& box : world.boxes()) {
    for (Dim i = 0; i < N; ++i) EXPECT_EQ(box.min[i], std::floor(box.min[i]));
  }
  for (int frame = 0; frame < 100; ++frame, world.step()) {
    if (frame % 33 == 0) {
      EXPECT_EQ((overlapping_pairs<N, T>(world.boxes()).size()), pairs);
    }
    for (const Aabb<N, T>& box : world.boxes()) ASSERT_EQ(box.max, (Vec<N, T>(box.min + T(1))));
  }
  // One more box needs the next larger lattice and starts another row.
  const MovingBoxes<N, T> larger(World::lattice, count + 1, 1);
  EXPECT_EQ(larger.boxes()[side].max[0] - larger.boxes()[0].min[0], T(side + 1));
}

TYPED_TEST(WorldsTest, GiantsAreHalfAsWideAsTheWorld) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::map<std::size_t, int> giants_of = {{2, 2}, {thousands, 3}, {400000, 4}};
  for (const auto& [count, expected] : giants_of) {
    const MovingBoxes<N, T> world(World::giants, count, 1);
    const double expected_width = std::pow(static_cast<double>(count) / (N == 2 ? 0.3 : 0.1), 1.0 / N) / 2;
    int giants = 0;
    for (const Aabb<N, T>& box : world.boxes()) {
      if (std::fabs(widths(box)[0] - expected_width) < 1e-3) ++giants;
    }
    EXPECT_EQ(giants, expected);
  }
}

struct Golden {
  World world;
  std::uint64_t hash_2d;
  std::uint64_t hash_3d;
};

class WorldHashes : public testing::TestWithParam<Golden> {};

/// After some steps, with boxes in float and in double.
template <Dim N>
std::uint64_t moved_hash(World world) {
  MovingBoxes<N, float> narrow(world, 3000, 42);
  MovingBoxes<N, double> exact(world, 3000, 42);
  for (int frame = 0; frame < 5; ++frame) {
    narrow.step();
    exact.step();
  }
  return hash_of(narrow.boxes()) ^ hash_of(exact.boxes());
}

TEST_P(WorldHashes, AreTheSameOnEveryMachine) {
  EXPECT_EQ(moved_hash<2>(GetParam().world), GetParam().hash_2d);
  EXPECT_EQ(moved_hash<3>(GetParam().world), GetParam().hash_3d);
}

INSTANTIATE_TEST_SUITE_P(EveryWorld, WorldHashes,
                         testing::Values(Golden{World::brownian, 0x7e6accc79fa5106U, 0x3a073772271a64c7U},
                                         Golden{World::heavy, 0x5f03b495d2871a0aU, 0xfafa5704143a6f58U},
                                         Golden{World::cluster, 0x2311121dc22d9bfbU, 0x150550652924c585U},
                                         Golden{World::line, 0x8a511d2a50950e2bU, 0x7403f3890fa16376U},
                                         Golden{World::plane, 0x8a511d2a50950e2bU, 0x2aa958bc5d47ce63U},
                                         Golden{World::lattice, 0xa9f07cbf86fb3600U, 0xac87c5ebdaa14400U},
                                         Golden{World::giants, 0xc797e381059cbebfU, 0xcfc2dc1b2a1381caU},
                                         Golden{World::point, 0x19ddcbaa0a823e6dU, 0xdf326bbd461c36c9U}),
                         [](const testing::TestParamInfo<Golden>& test) {
                           return std::string(name_of(test.param.world));
                         });

}  // namespace
}  // namespace graze::worlds_test
