// SPDX-License-Identifier: MIT
// Laws of manifold(a, b): on random pairs of every type, on boxes that rest on each other against a dense sampling, and
// between frames.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/contacts.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/proximities.hpp"

namespace graze::test::manifold_laws_test {
namespace {

template <class SpaceType>
class ManifoldLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  static constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

  /// Two shapes, usually placed together.
  static Pair draw_two() {
    const Pair pair = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    return seed % 4 == 0 ? pair : placed_together<N, T>(pair, random);
  }

  static Manifold<N, T> found(const Pair& pair) { return manifold_of<N, T>(pair.first, pair.second); }

  /// Logs a pair as C++ source.
  static void log(const Pair& pair) {
    RC_LOG() << to_source<N, T>(pair.first) << ", " << to_source<N, T>(pair.second) << "\n";
  }

  static double off(const Vec<N, T>& point, const Any& shape) {
    return static_cast<double>(distance_of<N, T>(Any(point), shape));
  }
};

TYPED_TEST_SUITE(ManifoldLaw, test::Spaces);

TYPED_TEST(ManifoldLaw, ItIsThatOfTheContact) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto contact = contact_of<dimension, Number>(pair.first, pair.second);
    const auto manifold = TestFixture::found(pair);
    TestFixture::log(pair);
    RC_ASSERT(contact.has_value() == (manifold.size > 0U));
    RC_PRE(contact.has_value() && std::isfinite(contact->depth));
    RC_ASSERT(manifold.normal == contact->normal);
    RC_ASSERT(manifold.error == contact->error);
    double deepest = 0;
    for (const auto& point : manifold.contacts()) deepest = std::max(deepest, static_cast<double>(point.depth));
    const double size = size_of<dimension, Number>(pair) + static_cast<double>(contact->depth);
    const double allowed = 4 * contact->error + (16 * TestFixture::epsilon + 4 * tolerance::aligned) * size;
    RC_ASSERT(std::fabs(deepest - static_cast<double>(contact->depth)) <= allowed);
  });
}

TYPED_TEST(ManifoldLaw, EveryPointIsOfBothShapesAndAsDeepAsItSays) {
  check_property([] {
    const auto pair = TestFixture::draw_two();
    const auto manifold = TestFixture::found(pair);
    TestFixture::log(pair);
    for (const auto& point : manifold.contacts()) {
      if (!std::isfinite(point.depth)) continue;
      const double size = std::max({size_of<TestFixture::N, typename TestFixture::T>(pair),
                                    static_cast<double>(max_abs(point.point_a)), static_cast<double>(point.depth)});
      const double allowed = 4 * manifold.error + (16 * TestFixture::epsilon + 4 * tolerance::aligned) * size;
      RC_ASSERT(point.depth >= 0);
      RC_ASSERT(TestFixture::off(point.point_a, pair.first) <= allowed);
      RC_ASSERT(TestFixture::off(point.point_b, pair.second) <= allowed);
      const auto rest = (point.point_a - point.point_b) - manifold.normal * point.depth;
      RC_ASSERT(static_cast<double>(max_abs(rest)) <= allowed);
    }
  });
}

TYPED_TEST(ManifoldLaw, SwappingTheShapesExchangesThePoints) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    TestFixture::log({a, b});
    RC_PRE((to_source<dimension, Number>(a) != to_source<dimension, Number>(b)));
    const auto manifold = TestFixture::found({a, b});
    const auto swapped = TestFixture::found({b, a});
    RC_ASSERT(manifold.size == swapped.size);
    RC_ASSERT(swapped.normal == -manifold.normal);
    for (std::size_t i = 0; i < manifold.size; ++i) {
      RC_ASSERT(swapped.points[i].point_a == manifold.points[i].point_b);
      RC_ASSERT(swapped.points[i].depth == manifold.points[i].depth);
      RC_ASSERT(swapped.points[i].id.a == manifold.points[i].id.b);
      RC_ASSERT(swapped.points[i].id.part_a == manifold.points[i].id.part_b);
    }
  });
}

TYPED_TEST(ManifoldLaw, NoIdIsThereTwice) {
  check_property([] {
    const auto pair = TestFixture::draw_two();
    const auto manifold = TestFixture::found(pair);
    TestFixture::log(pair);
    for (std::size_t i = 0; i < manifold.size; ++i) {
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!(manifold.points[i].id == manifold.points[j].id));
    }
  });
}

// ---- Boxes that rest on each other

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Box = Obb<3, double>;

/// A box on a table, at any position and rotation.
Box box_on_table(double degrees, const V2& place, double depth) {
  return {{place.x, place.y, 1.5 - depth}, {0.8, 0.6, 0.5}, rotation_matrix(V3(0, 0, 1), degrees)};
}

const Box table{{0, 0, 0}, {2, 1, 1}};

double area_of(const Manifold<3, double>& manifold) {
  V3 sum(0.0);
  V3 middle(0.0);
  for (const auto& point : manifold.contacts()) middle += point.point_a / static_cast<double>(manifold.size);
  std::vector<V3> around;
  for (const auto& point : manifold.contacts()) around.push_back(point.point_a - middle);
  std::sort(around.begin(), around.end(),
            [](const V3& p, const V3& q) { return std::atan2(p.y, p.x) < std::atan2(q.y, q.x); });
  for (std::size_t i = 0; i < around.size(); ++i) sum += cross(around[i], around[(i + 1) % around.size()]);
  return 0.5 * std::fabs(sum.z);
}

/// The area of the table under the box, counted in small squares.
double sampled_area(const Box& box) {
  constexpr int steps = 400;
  int inside = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const V3 point((i + 0.5) * 4 / steps - 2, (j + 0.5) * 2 / steps - 1, box.center.z);
      const V3 off = point - box.center;
      if (std::fabs(dot(off, box.axes[0])) <= box.half_extents.x &&
          std::fabs(dot(off, box.axes[1])) <= box.half_extents.y) {
        ++inside;
      }
    }
  }
  return 8.0 * inside / (steps * steps);
}

TEST(ManifoldOfBoxes, SpansMostOfThePatchThatASamplingFinds) {
  for (const double degrees : {0.0, 10.0, 30.0, 45.0, 77.0}) {
    for (const V2 place : {V2(0, 0), V2(1.2, 0.3), V2(1.9, -0.8), V2(-2.2, 1.1)}) {
      const Box box = box_on_table(degrees, place, 0.1);
      const auto manifold = manifold_of<3, double>(table, box);
      ASSERT_GE(manifold.size, 3U) << degrees << " at " << to_source(place);
      const double sampled = sampled_area(box);
      EXPECT_GE(area_of(manifold), 0.6 * sampled) << degrees << " at " << to_source(place);
      EXPECT_LE(area_of(manifold), 1.05 * sampled + 1e-3) << degrees << " at " << to_source(place);
      for (const auto& point : manifold.contacts()) EXPECT_NEAR(point.depth, 0.1, 1e-14);
    }
  }
}

/// The ids, in order.
std::vector<ContactId> ids_of(const Manifold<3, double>& manifold) {
  std::vector<ContactId> ids;
  for (const auto& point : manifold.contacts()) ids.push_back(point.id);
  return ids;
}

/// The same motion for one frame, some translation and rotation.
Box nudged(const Box& box, double size) {
  const Mat<3, double> turn = rotation_matrix(V3(0.3, -0.5, 0.8), 40 * size);
  return {box.center + V3(0.7, -0.4, -0.3) * size, box.half_extents, turn * box.axes};
}

// Positions and rotations at which no corner is near a side, so that small motions do not change the features.
TEST(ManifoldOfBoxes, KeepsItsIdsFromFrameToFrame) {
  for (const double degrees : {0.0, 12.0, 30.0, 45.0, 77.0}) {
    for (const V2 place : {V2(0, 0), V2(1.3, 0.1), V2(1.6, -0.7)}) {
      const Box box = box_on_table(degrees, place, 0.05);
      const std::vector<ContactId> before = ids_of(manifold_of<3, double>(table, box));
      for (const double size : {1e-12, 1e-9, -1e-9, 1e-6, -1e-6}) {
        EXPECT_EQ(ids_of(manifold_of<3, double>(table, nudged(box, size))), before)
            << degrees << " at " << to_source(place) << " by " << size;
        EXPECT_EQ(ids_of(manifold_of<3, double>(nudged(table, size), nudged(box, -size))), before);
      }
    }
  }
}

// Sliding and sinking: the features in contact stay the same, although the points move.
TEST(ManifoldOfBoxes, KeepsItsIdsWhileItSlides) {
  const std::vector<ContactId> before = ids_of(manifold_of<3, double>(table, box_on_table(20, V2(0.5, 0), 0.01)));
  ASSERT_EQ(before.size(), 4U);
  for (int step = 1; step <= 20; ++step) {
    const Box box = box_on_table(20 + 0.1 * step, V2(0.5 - 0.02 * step, 0), 0.01 + 0.002 * step);
    EXPECT_EQ(ids_of(manifold_of<3, double>(table, box)), before) << step;
  }
}

}  // namespace
}  // namespace graze::test::manifold_laws_test
