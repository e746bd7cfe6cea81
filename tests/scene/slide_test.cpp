// SPDX-License-Identifier: MIT
// Shapes that slide along what they hit: known paths, and random walks in closed rooms that nothing may leave.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/distance.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/slide.hpp>

#include "number_of_cases.hpp"
#include "scene/slide_walks.hpp"

namespace graze::slide_test {
namespace {

using World = Scene<2, double>;
using Box = Aabb<2, double>;
using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

constexpr double degree = std::numbers::pi / 180;
constexpr double clearance = 0.001;

/// A box that stands on the ground of `scene` at x = 0.
constexpr Box walker{{-0.5, clearance}, {0.5, 1 + clearance}};

TEST(Slide, NothingInTheWayLeavesTheMotionAsItIs) {
  World scene;
  scene.add(Box{{5, -1}, {6, 1}});
  const Slide<2, double> moved = slide(scene, Sphere<2, double>{{0, 0}, 1}, {3.7, 0.3});
  EXPECT_EQ(moved.motion, V2(3.7, 0.3));
  EXPECT_TRUE(moved.touches.empty());
  EXPECT_EQ(slide(scene, Sphere<2, double>{{0, 0}, 1}, {0, 0}).motion, V2(0, 0));
}

TEST(Slide, AlongAWallGoesWhatIsLeftOfTheMotionAlongIt) {
  World scene;
  const ObjectId wall = scene.add(Box{{2, -50}, {3, 50}});
  const Slide<2, double> moved = slide(scene, Sphere<2, double>{{0, 0}, 1}, {4, 8});
  EXPECT_NEAR(moved.motion.x, 1 - clearance, 1e-12);
  EXPECT_NEAR(moved.motion.y, 8, 1e-12);
  ASSERT_EQ(moved.touches.size(), 1U);
  EXPECT_EQ(moved.touches[0].id, wall);
  EXPECT_NEAR(moved.touches[0].impact.t, (1 - clearance) / 4, 1e-12);
  EXPECT_EQ(moved.touches[0].impact.normal, V2(1, 0));
}

TEST(Slide, LeavesAWallAtWhichItHasStopped) {
  World scene;
  scene.add(HalfSpace<2, double>{{0, 1}, 0});
  scene.add(Box{{1, 0}, {2, 3}});
  // Its distance from the wall exceeds the clearance by rounding.
  const Capsule<2, double> capsule{{0.69, 0.31}, {0.69, 0.91}, 0.3};
  const Slide<2, double> moved = slide(scene, capsule, {-0.0625, 0}, {.clearance = 0.01});
  EXPECT_EQ(moved.motion, V2(-0.0625, 0));
  EXPECT_TRUE(moved.touches.empty());
}

TEST(Slide, EndsInACorner) {
  World scene;
  const ObjectId wall = scene.add(Box{{2, -50}, {3, 50}});
  const ObjectId ceiling = scene.add(Box{{-50, 5}, {50, 6}});
  const Slide<2, double> moved = slide(scene, Sphere<2, double>{{0, 0}, 1}, {40, 80});
  EXPECT_NEAR(moved.motion.x, 1 - clearance, 1e-9);
  EXPECT_NEAR(moved.motion.y, 4 - clearance, 1e-9);
  ASSERT_GE(moved.touches.size(), 2U);
  EXPECT_EQ(moved.touches[0].id, wall);
  EXPECT_EQ(moved.touches[1].id, ceiling);
}

TEST(Slide, AlongTheEdgeOfTwoWallsIn3d) {
  Scene<3, double> scene;
  scene.add(HalfSpace<3, double>{{0, 1, 0}, 0});
  scene.add(HalfSpace<3, double>{{-1, 0, 0}, -5});
  const Slide<3, double> moved = slide(scene, Sphere<3, double>{{0, 2, 0}, 1}, {10, -10, 7});
  EXPECT_NEAR(moved.motion.x, 4 - clearance, 1e-9);
  EXPECT_NEAR(moved.motion.y, -1 + clearance, 1e-9);
  EXPECT_NEAR(moved.motion.z, 7, 1e-9);
}

TEST(Slide, AFloorOfTilesIsAFloor) {
  World scene;
  for (int x = -3; x < 20; ++x) scene.add(Box{{x, -1}, {x + 1, 0}});
  const Slide<2, double> moved = slide(scene, walker, {12.3, -0.5});
  EXPECT_NEAR(moved.motion.x, 12.3, 1e-9);
  EXPECT_NEAR(moved.motion.y, 0, 1e-9);
}

TEST(Slide, AroundTheEndOfAWall) {
  World scene;
  scene.add(Box{{2, -1}, {3, 3}});
  const Slide<2, double> moved = slide(scene, Box{{0, 0}, {1, 1}}, {4, 8});
  EXPECT_GT(moved.motion.y, 7.9);
  EXPECT_NEAR(moved.motion.x, 1 - clearance, 1e-9);  // the turn at the wall holds until the next touch
}

TEST(Slide, ASlopeIsClimbedIfItIsNotTooSteep) {
  for (const double angle : {20.0, 44.0, 46.0, 70.0}) {
    World scene;
    scene.add(HalfSpace<2, double>{{0, 1}, 0});
    const double a = angle * degree;
    scene.add(HalfSpace<2, double>{{-std::sin(a), std::cos(a)}, -2 * std::sin(a)});  // rises to the right from x = 2
    const Slide<2, double> moved = slide(scene, walker, {10, 0}, {.max_slope = 45 * degree});
    if (angle < 45) {
      EXPECT_GT(moved.motion.x, 2) << angle;
      EXPECT_GT(moved.motion.y, 0.5) << angle;
    } else {
      EXPECT_NEAR(moved.motion.x, 1.5, 0.01) << angle;
      EXPECT_NEAR(moved.motion.y, 0, 1e-9) << angle;
    }
  }
}

TEST(Slide, DownASlopeThatIsTooSteepToClimb) {
  World scene;
  const double a = 60 * degree;
  scene.add(HalfSpace<2, double>{{-std::sin(a), std::cos(a)}, 0});
  const Slide<2, double> moved = slide(scene, Sphere<2, double>{{0, 3}, 1}, {0, -5}, {.max_slope = 45 * degree});
  EXPECT_LT(moved.motion.x, -1);
  EXPECT_LT(moved.motion.y, -2.5);
}

TEST(Slide, ClimbsStepsUpToTheirHeight) {
  for (const double height : {0.1, 0.29, 0.31, 1.0}) {
    World scene;
    scene.add(Box{{-20, -1}, {20, 0}});
    scene.add(Box{{2, 0}, {20, height}});
    const Slide<2, double> moved = slide(scene, walker, {6, 0}, {.step_height = 0.3});
    if (height < 0.3) {
      EXPECT_NEAR(moved.motion.x, 6, 1e-6) << height;
      EXPECT_NEAR(moved.motion.y, height, 1e-6) << height;
    } else {
      EXPECT_NEAR(moved.motion.x, 1.5 - clearance, 1e-6) << height;
      EXPECT_NEAR(moved.motion.y, 0, 1e-9) << height;
    }
  }
}

TEST(Slide, ClimbsStairsWhoseTreadsAreAsWideAsItIs) {
  World scene;
  scene.add(HalfSpace<2, double>{{0, 1}, 0});
  for (int i = 0; i < 5; ++i) scene.add(Box{{1 + 0.6 * i, 0}, {1.6 + 0.6 * i, 0.3 * (i + 1)}});
  V2 place{0, clearance};
  for (int frame = 0; frame < 120; ++frame) {
    const Capsule<2, double> capsule{{place.x, place.y + 0.3}, {place.x, place.y + 0.9}, 0.3};
    place += slide(scene, capsule, {0.03125, 0}, {.max_slope = 50 * degree, .step_height = 0.35}).motion;
  }
  EXPECT_GT(place.x, 3.4) << "it is above the last of them";
  EXPECT_NEAR(place.y, 1.5, 0.01);
}

TEST(Slide, MovesOutOfWhatItOverlapsAtTheStart) {
  World scene;
  scene.add(Box{{-20, -1}, {20, 0}});
  const Box sunk{{-0.5, -0.2}, {0.5, 0.8}};
  const Slide<2, double> moved = slide(scene, sunk, {3, 0});
  EXPECT_NEAR(moved.motion.x, 3, 1e-9);
  EXPECT_NEAR(moved.motion.y, 0.2 + clearance, 1e-9);
}

TEST(Slide, PassesThroughWhatTheQueryExcepts) {
  World scene;
  const ObjectId door = scene.add(Box{{2, -5}, {3, 5}}, {.layer = 4});
  const Sphere<2, double> ball{{0, 0}, 1};
  EXPECT_EQ(slide(scene, ball, {9, 0}, {.query = {.layers = ~only_layer(4)}}).motion, V2(9, 0));
  EXPECT_EQ(slide(scene, ball, {9, 0}, {.query = {.except = {&door, 1}}}).motion, V2(9, 0));
  EXPECT_LT(slide(scene, ball, {9, 0}).motion.x, 1);
}

TEST(Slide, RefusesWhatHasNoMeaning) {
  World scene;
  const Sphere<2, double> ball{{0, 0}, 1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(slide(scene, Sphere<2, double>{{0, 0}, -1}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {nan, 0}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {inf, 0}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {1, 0}, {.up = {0, 0, 1}}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {1, 0}, {.max_slope = -0.1}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {1, 0}, {.max_slope = 2}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {1, 0}, {.step_height = nan}), std::invalid_argument);
  EXPECT_THROW(slide(scene, ball, {1, 0}, {.clearance = -1}), std::invalid_argument);
}

/// A closed room with pillars, balls, ramps and a compound, of 20 to a side around zero.
template <Dim N, class T>
class Room {
 public:
  using V = Vec<N, T>;

  explicit Room(std::uint32_t seed) : random_(seed) {
    for (Dim axis = 0; axis < N; ++axis) {
      for (const T side : {T(-1), T(1)}) {
        V low = V(T(-11));
        V high = V(T(11));
        (side < 0 ? high : low)[axis] = side * T(10);
        scene_.add(Aabb<N, T>{low, high});
      }
    }
    for (int i = 0; i < 30; ++i) {
      const V center = vector(T(9));
      if (max_abs(center) < T(3)) continue;  // where the walkers start
      switch (i % 4) {
        case 0:
          scene_.add(Aabb<N, T>{center - V(T(0.7)), center + V(T(0.7))});
          break;
        case 1:
          scene_.add(Sphere<N, T>{center, T(0.9)});
          break;
        case 2:
          scene_.add(Capsule<N, T>{center, center + vector(T(2)), T(0.4)});
          break;
        default: {
          std::vector<V> corners;
          for (int corner = 0; corner < 9; ++corner) corners.push_back(center + vector(T(1.2)));
          scene_.add(convex_hull<N, T>(corners));
        }
      }
    }
  }

  V vector(T size) {
    std::uniform_real_distribution<T> coordinate(-size, size);
    V result;
    for (Dim axis = 0; axis < N; ++axis) result[axis] = coordinate(random_);
    return result;
  }

  const Scene<N, T>& scene() const { return scene_; }

 private:
  std::mt19937 random_;
  Scene<N, T> scene_;
};

template <Dim N, class T>
void expect_a_walk_that_overlaps_nothing(const AnyShape<N, T>& start, std::uint32_t seed, const SlideOptions& options) {
  Room<N, T> room(seed);
  const auto steps = test::number_of_cases(17'000);
  const auto walk = test::expect_a_walk_without_overlap<N, T>(
      room.scene(), start, steps, options,
      [&room](std::size_t step) { return room.vector(step % 10 == 0 ? T(15) : T(1.5)); });
  const Aabb<N, T> box = bounds(walk.end);
  EXPECT_TRUE(max_abs(box.min) <= T(10) && max_abs(box.max) <= T(10)) << "outside of the room";
  EXPECT_GT(walk.touches, steps / 4);
  EXPECT_GT(walk.way, 0.2 * static_cast<double>(steps)) << "it is stuck";
}

template <Dim N, class T>
void expect_walks_that_overlap_nothing() {
  using V = Vec<N, T>;
  V up(T(0));
  up[1] = T(1);
  const SlideOptions steps{.max_slope = 50 * degree, .step_height = 0.4};
  for (const SlideOptions& options : {SlideOptions{}, steps, SlideOptions{.clearance = 0.02}}) {
    expect_a_walk_that_overlaps_nothing<N, T>(Sphere<N, T>{V(T(0)), T(0.5)}, 1, options);
    expect_a_walk_that_overlaps_nothing<N, T>(Capsule<N, T>{V(T(0)), up, T(0.4)}, 2, options);
    expect_a_walk_that_overlaps_nothing<N, T>(Aabb<N, T>{V(T(-0.5)), V(T(0.5))}, 3, options);
  }
}

TEST(SlideWalks, OverlapNothing2dDouble) { expect_walks_that_overlap_nothing<2, double>(); }
TEST(SlideWalks, OverlapNothing3dDouble) { expect_walks_that_overlap_nothing<3, double>(); }
TEST(SlideWalks, OverlapNothing2dFloat) { expect_walks_that_overlap_nothing<2, float>(); }
TEST(SlideWalks, OverlapNothing3dFloat) { expect_walks_that_overlap_nothing<3, float>(); }

}  // namespace
}  // namespace graze::slide_test
