// SPDX-License-Identifier: MIT
// The fast method for two hulls agrees with the one for all convex shapes, or is undecided, with any content of a
// cache.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/closest/hulls.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "query/every_pair.hpp"
#include "query/flush_prisms.hpp"

namespace graze::detail::closest_hulls_test {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  template <class T>
  Vec<3, T> vector(double size) {
    return Vec<3, T>(Vec<3, double>(number(-size, size), number(-size, size), number(-size, size)));
  }
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_); }

  template <class T>
  Pose<3, T> pose(double reach) {
    return {Mat<3, T>(rotation_matrix(vector<double>(1) + Vec<3, double>(0, 0, 1e-3), number(0, 360))),
            vector<T>(reach)};
  }

  /// One to sixty points in 3D, in a plane or on a line; on a lattice so coarse that much is parallel, or not.
  template <class T>
  Polytope<3, T> hull() {
    const Vec<3, double> flat[] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 0}, {1, 0, 0}};
    const Vec<3, double> spread = flat[below(4)];
    const double step = below(2) == 0 ? 0.25 : 0x1p-30;
    std::vector<Vec<3, T>> points(1 + below(below(2) == 0 ? 6 : 60));
    for (Vec<3, T>& point : points) {
      const Vec<3, double> place = vector<double>(1) * spread;
      point = Vec<3, T>(
          Vec<3, double>(std::round(place.x / step), std::round(place.y / step), std::round(place.z / step)) * step);
    }
    return convex_hull<3, T>(points);
  }

 private:
  std::mt19937 engine_;
};

template <class A, class B>
void expect_points_apart(const A& a, const B& b, const Proximity<3, double>& found) {
  const double slack = found.error + 1e-14;
  const Vec<3, double> way = found.point_b - found.point_a;
  EXPECT_NEAR(std::sqrt(dot(way, way)), found.distance, slack);
  EXPECT_NEAR(dot(found.normal, way), found.distance, slack);
  // Planes through the points, perpendicular to the normal, separate the hulls.
  EXPECT_LE(dot(found.normal, support(a, found.normal) - found.point_a), slack);
  EXPECT_GE(dot(found.normal, support(b, -found.normal) - found.point_b), -slack);
}

/// None if undecided.
template <class A, class B>
std::optional<Proximity<3, double>> proximity_of_hulls(const A& a, const B& b, SimplexCache<3>* cache) {
  Proximity<3, double> found;
  if (!find_proximity_of_hulls(a, b, {cache, false}, found)) return std::nullopt;
  return found;
}

struct Tally {
  std::size_t asked = 0;
  std::size_t apart = 0;
  std::size_t overlapping = 0;
};

template <class A, class B>
void compare(const A& a, const B& b, SimplexCache<3>* cache, Tally& tally) {
  ++tally.asked;
  const std::optional<Proximity<3, double>> found = proximity_of_hulls(a, b, cache);
  if (!found) return;
  const Relation relation = decide(a, b);
  ASSERT_EQ(found->relation, relation);
  const Proximity<3, double> right = proximity_in_order(a, b, relation);
  ASSERT_NEAR(found->distance, right.distance, found->error + right.error);
  EXPECT_EQ(found->status, Status::converged);
  if (relation == Relation::apart) {
    ++tally.apart;
    expect_points_apart(a, b, *found);
  } else {
    ++tally.overlapping;
    EXPECT_EQ(found->point_a, found->point_b);
    EXPECT_LE(closest_points(a, Vec<3, scalar_of<A>>(found->point_a)).distance, 1e-6);
    EXPECT_LE(closest_points(b, Vec<3, scalar_of<A>>(found->point_a)).distance, 1e-6);
  }
}

template <class T>
Tally compare_random_hulls(double reach, bool with_cache) {
  Random random(static_cast<unsigned>(reach) + (with_cache ? 100 : 0));
  Tally tally;
  SimplexCache<3> kept;  // of a different pair each time
  SimplexCache<3>* const cache = with_cache ? &kept : nullptr;
  for (std::size_t i = test::number_of_cases(2000); i > 0 && !testing::Test::HasFailure(); --i) {
    const Polytope<3, T> a = random.hull<T>();
    const Polytope<3, T> b = random.hull<T>();
    const Posed<Polytope<3, T>> posed_a{a, random.pose<T>(reach)};
    const Posed<Polytope<3, T>> posed_b{b, random.pose<T>(reach)};
    compare(posed_a, posed_b, cache, tally);
    compare(transformed(a, posed_a.pose), transformed(b, posed_b.pose), cache, tally);
    compare(transformed(a, posed_a.pose), posed_b, cache, tally);
    compare(a, b, cache, tally);
  }
  return tally;
}

TEST(ClosestHulls, AreAsThoseOfAllConvexShapes) {
  for (const bool with_cache : {false, true}) {
    for (const double reach : {1.0, 3.0}) {
      for (const Tally& tally :
           {compare_random_hulls<double>(reach, with_cache), compare_random_hulls<float>(reach, with_cache)}) {
        EXPECT_GT(tally.apart, tally.asked / 4);
        EXPECT_GT(tally.overlapping, tally.asked / 40);
      }
    }
  }
}

/// Round hulls in general position.
Polytope<3, double> sphere(Random& random, std::size_t corners) {
  std::vector<Vec<3, double>> points(corners);
  for (auto& point : points) {
    point = random.vector<double>(1);
    point /= std::sqrt(dot(point, point));
  }
  return convex_hull(points);
}

TEST(ClosestHulls, AreFoundForAllThatAreClearlyApart) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Posed<Polytope<3, double>> a{sphere(random, 4 + random.below(60)), random.pose<double>(1)};
    const Posed<Polytope<3, double>> b{sphere(random, 4 + random.below(60)), random.pose<double>(1)};
    const auto right = closest_points(a, b);
    const auto found = proximity_of_hulls(a, b, nullptr);
    if (right.relation == Relation::apart && right.distance > 1e-9) {
      EXPECT_TRUE(found.has_value()) << right.distance;
    }
  }
}

template <class T>
void expect_flush_ones() {
  std::size_t open = 0;
  for (unsigned turn = 0; turn < 3000 && !testing::Test::HasFailure(); ++turn) {
    const auto [a, b, normal] = test::flush_prisms<T>(turn, test::flush_gap(turn));
    SimplexCache<3> cache;
    for (const bool with_cache : {false, true, true}) {
      const auto found = proximity_of_hulls(a, b, with_cache ? &cache : nullptr);
      const auto right = proximity_in_order(a, b, decide(a, b));
      if (right.relation != Relation::apart) continue;
      const double size = std::max(rows_of(a).largest(), rows_of(b).largest());
      const double few = 256 * tolerance::epsilon * size + tolerance::gjk_relative_gap * right.distance;
      EXPECT_EQ(right.status, Status::converged) << turn;
      EXPECT_LE(right.error, few) << turn;
      expect_points_apart(a, b, right);
      if (!found) {
        ++open;
        continue;
      }
      EXPECT_LE(found->error, few) << turn;
      EXPECT_NEAR(found->distance, right.distance, found->error + right.error) << turn;
      EXPECT_LE(max_abs(found->point_b - found->point_a - found->normal * found->distance), few) << turn;
      expect_points_apart(a, b, *found);
    }
  }
  EXPECT_LE(open, 9U) << "of thousands";
}

// The nearest face is determined by the planes of faces alone: all distances close to it are equal.
TEST(ClosestHulls, AreFoundWhereFacesAreNearlyParallel) {
  expect_flush_ones<double>();
  expect_flush_ones<float>();
}

TEST(ClosestHulls, LeaveTouchingOnesOpen) {
  const auto cube = convex_hull(std::vector<Vec<3, double>>{
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
  const Pose<3, double> beside{Mat<3, double>(1.0), {1, 0.25, 0.5}};
  EXPECT_FALSE(proximity_of_hulls(cube, transformed(cube, beside), nullptr).has_value());
  EXPECT_EQ(closest_points(cube, transformed(cube, beside)).relation, Relation::touching);
  EXPECT_EQ(closest_points(cube, cube).relation, Relation::overlapping);
}

TEST(ClosestHulls, SayNothingWhereNumbersOverflow) {
  for (const double scale : {1e-140, 1e-100, 1e100, 1e140}) {
    const auto cube =
        convex_hull(std::vector<Vec<3, double>>{Vec<3, double>(0, 0, 0), Vec<3, double>(scale, 0, 0),
                                                Vec<3, double>(0, scale, 0), Vec<3, double>(0, 0, scale)});
    const Pose<3, double> beside{Mat<3, double>(1.0), Vec<3, double>(3, 0.5, 0.25) * scale};
    const auto found = closest_points(cube, transformed(cube, beside));
    EXPECT_EQ(found.relation, Relation::apart);
    EXPECT_NEAR(found.distance / scale, closest_points(transformed(cube, beside), cube).distance / scale, 0);
    EXPECT_GT(found.distance / scale, 2);
    EXPECT_LT(found.distance / scale, 3);
  }
}

template <class Hull>
void expect_same_by_all_widths(Hull& a, Hull& b, SimplexCache<3> known) {
  struct Found {
    bool is_apart;
    double distance;
    Vec<3, double> on_a;
    SimplexCache<3> cache;
  };
  const auto walked = [&](auto run) {
    SimplexCache<3> cache = known;
    HullWalk<Hull, Hull> walk(a, b, 0);
    run(walk, KnownCorners{&cache, false});
    return Found{walk.is_apart(), walk.distance(), walk.points().on_a, cache};
  };
  const Found right = walked([](auto& walk, const KnownCorners& corners) { walk.run_by_two(corners); });
  const auto expect_right = [&](const Found& found) {
    ASSERT_EQ(found.is_apart, right.is_apart);
    if (!right.is_apart) return;
    ASSERT_EQ(found.distance, right.distance);
    ASSERT_EQ(found.on_a, right.on_a);
    ASSERT_EQ(found.cache.corners_a, right.cache.corners_a);
    ASSERT_EQ(found.cache.corners_b, right.cache.corners_b);
  };
  expect_right(walked([](auto& walk, const KnownCorners& corners) { walk.run(corners); }));
#ifdef GRAZE_HAS_WIDER_LANES
  if (__builtin_cpu_supports("avx2")) {
    expect_right(walked([](auto& walk, const KnownCorners& corners) { walk.run_by_four(corners); }));
  }
  if (__builtin_cpu_supports("avx512f")) {
    expect_right(walked([](auto& walk, const KnownCorners& corners) { walk.run_by_eight(corners); }));
  }
#endif
}

TEST(ClosestHulls, AreTheSameByVectorsOfAnyWidth) {
  Random random(13);
  for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
    const bool are_few = i % 2 == 0;
    const auto draw = [&] { return are_few ? random.hull<double>() : sphere(random, 33 + random.below(60)); };
    const Posed<Polytope<3, double>> posed_a{draw(), random.pose<double>(2)};
    const Posed<Polytope<3, double>> posed_b{draw(), random.pose<double>(2)};
    const Vec<3, double> origin = posed_a.pose.position;
    PosedHull<double> a(posed_a, origin);
    PosedHull<double> b(posed_b, origin);
    expect_same_by_all_widths(a, b, {});
    expect_same_by_all_widths(a, b, {{0, 0, 0, 0}, {0, 0, 0, 0}, 1});
#ifdef GRAZE_HAS_LANES
    if (std::max(a.size(), b.size()) > FewCorners::room) continue;
    FewHull few_a(a);
    FewHull few_b(b);
    expect_same_by_all_widths(few_a, few_b, {});
    expect_same_by_all_widths(few_a, few_b, {{0, 0, 0, 0}, {0, 0, 0, 0}, 1});
#endif
  }
}

TEST(SimplexCache, ServesAPairThatMoves) {
  Random random(5);
  for (int pair = 0; pair < 50; ++pair) {
    const auto a = sphere(random, 30);
    const auto b = sphere(random, 30);
    SimplexCache<3> cache;
    SimplexCache<3> back;
    for (int frame = 0; frame < 40; ++frame) {
      const double t = frame / 40.0;
      const Posed<Polytope<3, double>> at{a, {rotation_matrix(Vec<3, double>(1, 2, 3), 90 * t), {-2 + 3 * t, t, 0}}};
      const Posed<Polytope<3, double>> to{b, {rotation_matrix(Vec<3, double>(3, 0, 1), -60 * t), {1, -t, 0.5 * t}}};
      const auto right = closest_points(at, to);
      const auto found = closest_points(at, to, cache);
      EXPECT_NEAR(found.distance, right.distance, found.error + right.error);
      EXPECT_EQ(found.relation, right.relation);
      EXPECT_EQ(distance(at, to, cache) == 0, right.relation != Relation::apart);
      // Swapped arguments have a cache of their own, and the same answers.
      const auto swapped = closest_points(to, at, back);
      EXPECT_EQ(swapped, exchanged(found));
      EXPECT_NEAR(distance(to, at, back), found.distance, found.error);
    }
    EXPECT_GT(cache.size, 0U);
    EXPECT_EQ(cache.size, back.size);
    EXPECT_EQ(cache.corners_a, back.corners_b);
  }
}

TEST(SimplexCache, OfAnythingDoesNoHarm) {
  Random random(9);
  for (int i = 0; i < 1000; ++i) {
    const Posed<Polytope<3, double>> a{sphere(random, 4 + random.below(20)), random.pose<double>(2)};
    const Posed<Polytope<3, double>> b{sphere(random, 4 + random.below(20)), random.pose<double>(2)};
    SimplexCache<3> cache;
    cache.size = static_cast<std::uint32_t>(random.below(7));
    for (auto* const corners : {&cache.corners_a, &cache.corners_b}) {
      for (auto& corner : *corners) corner = static_cast<std::uint32_t>(random.below(8) == 0 ? ~0U : random.below(12));
    }
    const auto right = closest_points(a, b);
    const auto found = closest_points(a, b, cache);
    EXPECT_NEAR(found.distance, right.distance, found.error + right.error);
    EXPECT_EQ(found.relation, right.relation);
  }
}

TEST(SimplexCache, IsPassedThroughAnyShapeAndLeftAloneByOthers) {
  Random random(1);
  const AnyShape<3, double> a = sphere(random, 12);
  const AnyShape<3, double> b = transformed(sphere(random, 12), {Mat<3, double>(1.0), {3, 1, 0}});
  SimplexCache<3> cache;
  EXPECT_EQ(closest_points(a, b, cache), closest_points(a, b));
  EXPECT_GT(cache.size, 0U);
  SimplexCache<3> unused;
  const AnyShape<3, double> sphere = Sphere<3, double>{{3, 0, 0}, 1};
  EXPECT_EQ(closest_points(a, sphere, unused), closest_points(a, sphere));
  EXPECT_EQ(unused.size, 0U);
  SimplexCache<2> in_plane;
  const Polytope<2, double> square = convex_hull(std::vector<Vec<2, double>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(distance(square, Vec<2, double>(3, 0.5), in_plane), 2);
  EXPECT_EQ(in_plane.size, 0U);
}

}  // namespace
}  // namespace graze::detail::closest_hulls_test
