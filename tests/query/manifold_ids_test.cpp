// SPDX-License-Identifier: MIT
// Contact ids between frames: a resting object keeps them while it is nudged, slightly rotated, or moved together with
// its support. No corner is near a side of the other shape, so none crosses one.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/manifolds.hpp"

namespace graze::test::manifold_ids_test {
namespace {

template <Dim N, class T>
struct Resting {
  AnyShape<N, T> lower;
  AnyShape<N, T> upper;
};

template <Dim N>
Pose<N, double> turned_about(const Vec<N, double>& place, double degrees) {
  Mat<N, double> turn(1.0);
  if constexpr (N == 2) {
    turn = rotation_matrix(degrees);
  } else {
    turn = rotation_matrix(Vec<3, double>(0.3, -0.5, 0.8), degrees);
  }
  return {turn, place - turn * place};
}

/// Blocks of several kinds from the height `bottom` up to `top`, by 2 * `half` along the other axes.
template <Dim N, class T>
class Blocks {
 public:
  using V = Vec<N, T>;
  using Any = AnyShape<N, T>;

  Blocks(const Vec<2, double>& place, double half, double bottom, double top)
      : place_(place), half_(half), bottom_(bottom), top_(top) {}

  /// Shapes with only one flat side have it below, or above.
  std::vector<Any> all(bool is_flat_below) const {
    std::vector<Any> blocks = {box(), oriented(), capsule(), hull(), turned_hull(), drum()};
    blocks.push_back(triangle(is_flat_below));
    return blocks;
  }

  Any box() const { return Aabb<N, T>{at(-1, -1, bottom_), at(1, 1, top_)}; }

  Any oriented() const {
    Mat<N, T> axes(T(1));
    if constexpr (N == 3) axes = Mat<3, T>(rotation_matrix(Vec<3, double>(0, 0, 1), 20));
    const V middle = (at(-1, -1, bottom_) + at(1, 1, top_)) * T(0.5);
    return Obb<N, T>{middle, (at(1, 1, top_) - at(-1, -1, bottom_)) * T(0.5), axes};
  }

  Any capsule() const {
    const double radius = (top_ - bottom_) / 2;
    return Capsule<N, T>{at(-1, 0, bottom_ + radius), at(1, 0, bottom_ + radius), static_cast<T>(radius)};
  }

  /// All corners share coordinates with others.
  Polytope<N, T> hull() const {
    std::vector<V> corners;
    for (const double height : {bottom_, top_}) {
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) corners.push_back(at(x, y, height));
      }
    }
    return convex_hull<N, T>(corners);
  }

  /// Rotated by a quarter turn up to rounding: corners share coordinates up to rounding.
  Any turned_hull() const {
    if constexpr (N == 2) return hull();
    if constexpr (N == 3) {
      const Mat<3, double> turn = rotation_matrix(Vec<3, double>(0, 0, 1), 89.99999);
      const Vec<3, double> middle(place_.x, place_.y, 0);
      return transformed(hull(), Pose<3, T>{Mat<3, T>(turn), Vec<3, T>(middle - turn * middle)});
    }
  }

  /// With more corners than a patch has; in 2D with a blunt end.
  Any drum() const {
    std::vector<V> corners;
    for (int i = 0; i < 12; ++i) {
      const Vec<2, double> way = cosine_sine_of_degrees(30.0 * i + 7);
      corners.push_back(at(way.x, way.y, bottom_));
      corners.push_back(at(way.x, way.y, top_));
    }
    corners.push_back(at(1.25, 0, (bottom_ + top_) / 2));
    return convex_hull<N, T>(corners);
  }

  Any triangle(bool is_flat_below) const {
    const double height = is_flat_below ? bottom_ : top_;
    if constexpr (N == 2)
      return Triangle<2, T>{at(-1, 0, height), at(1, 0, height), at(0.1, 0, bottom_ + top_ - height)};
    if constexpr (N == 3) return Triangle<3, T>{at(-1, -0.9, height), at(1.1, -0.8, height), at(0.2, 0.9, height)};
  }

 private:
  V at(double x, double y, double height) const {
    if constexpr (N == 2) return {static_cast<T>(place_.x + half_ * x), static_cast<T>(height)};
    if constexpr (N == 3) {
      return {static_cast<T>(place_.x + half_ * x), static_cast<T>(place_.y + half_ * y), static_cast<T>(height)};
    }
  }

  Vec<2, double> place_;
  double half_;
  double bottom_;
  double top_;
};

template <class SpaceType>
class ContactIds : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Pair = Resting<N, T>;
  using Found = Manifold<N, T>;

  /// Everything on everything, and on a half-space.
  static std::vector<Pair> resting() {
    std::vector<Any> below = Blocks<N, T>({0, 0}, 2, -1, 0).all(false);
    below.push_back(HalfSpace<N, T>{unit_axis<N, T>(N - 1), T(0)});
    std::vector<Pair> pairs;
    for (const Any& lower : below) {
      for (const Any& upper : Blocks<N, T>({0.3, 0}, 0.7, -0.01, 0.75).all(true)) {
        // Two 3D triangles that lie on each other have no depth.
        const bool are_flat = N == 3 && is<Triangle<N, T>>(lower) && is<Triangle<N, T>>(upper);
        if (!are_flat) pairs.push_back({lower, upper});
      }
    }
    return pairs;
  }

  template <class S>
  static bool is(const Any& shape) {
    return std::holds_alternative<S>(shape);
  }

  static bool turns(const Pair& pair) { return !is<Aabb<N, T>>(pair.lower) && !is<Aabb<N, T>>(pair.upper); }

  static Found found(const Pair& pair) { return manifold_of<N, T>(pair.lower, pair.upper); }

  static Any moved(const Any& shape, const Pose<N, double>& pose) {
    return transformed(shape, Pose<N, T>{Mat<N, T>(pose.rotation), Vec<N, T>(pose.position)});
  }

  static Vec<N, double> upper_middle() {
    Vec<N, double> middle = unit_axis<N>(0) * 0.3;
    middle[N - 1] = 0.37;
    return middle;
  }

  /// The upper shape after translations and rotations as from a solver step.
  static std::vector<Pair> next_frames(const Pair& pair) {
    constexpr auto ulp = static_cast<double>(std::numeric_limits<T>::epsilon());
    std::vector<Pair> frames;
    for (const double way : {ulp, -ulp, 1e-6, -1e-6}) {
      for (Dim i = 0; i < N; ++i) {
        frames.push_back({pair.lower, translated<N, T>(pair.upper, unit_axis<N, T>(i) * static_cast<T>(way))});
        if (!turns(pair)) continue;
        const double degrees = way * 50;
        frames.push_back({pair.lower, moved(pair.upper, turned_about<N>(upper_middle(), degrees))});
        frames.push_back({moved(pair.lower, turned_about<N>(Vec<N, double>(0.0), degrees)), pair.upper});
      }
    }
    return frames;
  }

  /// Both shapes moved elsewhere.
  static std::vector<Pair> elsewhere(const Pair& pair) {
    std::vector<Pair> places;
    for (const double way : {0.37, -3.3}) {
      const Vec<N, T> offset = Vec<N, T>(static_cast<T>(way)) + unit_axis<N, T>(0);
      places.push_back({translated<N, T>(pair.lower, offset), translated<N, T>(pair.upper, offset)});
    }
    for (const double degrees : {1e-5, 11.0, 37.0, 90.0, 123.0, 180.0}) {
      if (!turns(pair)) continue;
      const Pose<N, double> pose = turned_about<N>(unit_axis<N>(1) * 1.5, degrees);
      places.push_back({moved(pair.lower, pose), moved(pair.upper, pose)});
    }
    return places;
  }

  static std::string text(const Pair& pair) { return to_source<N, T>(pair.lower) + ", " + to_source<N, T>(pair.upper); }

  static void expect_distinct(const Found& manifold, const std::string& pair) {
    for (std::size_t i = 0; i < manifold.size; ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(manifold.points[i].id == manifold.points[j].id) << pair;
    }
  }

  /// The point of an id.
  static std::optional<Vec<N, T>> point_of(const Found& manifold, const ContactId& id) {
    for (const auto& point : manifold.contacts()) {
      if (point.id == id) return point.point;
    }
    return std::nullopt;
  }

  /// The same ids in any order.
  static bool same_ids(const Found& a, const Found& b) {
    const auto has = [&](const auto& point) { return point_of(b, point.id).has_value(); };
    return a.size == b.size && std::all_of(a.contacts().begin(), a.contacts().end(), has);
  }

  /// Each id names the same point, which has not moved far.
  static void expect_same(const Pair& before, const Pair& after, double way) {
    const Found old_points = found(before);
    const Found new_points = found(after);
    EXPECT_TRUE(same_ids(old_points, new_points)) << text(before) << " became " << text(after);
    if (!same_ids(old_points, new_points)) return;
    for (const auto& point : old_points.contacts()) {
      const auto gone = static_cast<double>(length(*point_of(new_points, point.id) - point.point));
      EXPECT_LE(gone, way) << text(before) << " became " << text(after);
    }
  }
};

TYPED_TEST_SUITE(ContactIds, test::Spaces);

TYPED_TEST(ContactIds, AreDistinctAndThere) {
  for (const auto& pair : TestFixture::resting()) {
    const auto manifold = TestFixture::found(pair);
    EXPECT_GE(manifold.size, 2U) << TestFixture::text(pair);
    TestFixture::expect_distinct(manifold, TestFixture::text(pair));
  }
}

TYPED_TEST(ContactIds, StayWhileTheUpperShapeIsNudgedOrHardlyTurned) {
  for (const auto& pair : TestFixture::resting()) {
    for (const auto& next : TestFixture::next_frames(pair)) TestFixture::expect_same(pair, next, 1e-4);
  }
}

TYPED_TEST(ContactIds, StayWhereBothShapesAreMovedTogether) {
  for (const auto& pair : TestFixture::resting()) {
    for (const auto& place : TestFixture::elsewhere(pair)) {
      TestFixture::expect_same(pair, place, std::numeric_limits<double>::infinity());
    }
  }
}

TYPED_TEST(ContactIds, StayWhileShapesThatWereMovedAreNudged) {
  for (const auto& pair : TestFixture::resting()) {
    if (!TestFixture::turns(pair)) continue;
    for (const auto& next : TestFixture::next_frames(pair)) {
      const Pose<TestFixture::N, double> pose = turned_about<TestFixture::N>(Vec<TestFixture::N, double>(2.0), 77);
      const typename TestFixture::Pair place{TestFixture::moved(next.lower, pose),
                                             TestFixture::moved(next.upper, pose)};
      TestFixture::expect_same(pair, place, std::numeric_limits<double>::infinity());
    }
  }
}

// Boxes of one size, each exactly above the other, rotated by 45 degrees: eight equally good points.
TEST(ContactIdsOfAStack, StayWhicheverIsFartherAlongAnAxis) {
  const Mat<3, double> eighth = rotation_matrix(Vec<3, double>(0, 0, 1), 45);
  const Polytope<3, double> hull = Blocks<3, double>({0, 0}, 1, -1, 1).hull();
  const AnyShape<3, double> box = Obb<3, double>{};
  for (const AnyShape<3, double>& lower : {AnyShape<3, double>(hull), box}) {
    const auto upper_at = [&](const Vec<3, double>& offset) {
      return transformed(lower, Pose<3, double>{eighth, Vec<3, double>(0, 0, 1.99) + offset});
    };
    const auto before = manifold_of<3, double>(lower, upper_at(Vec<3, double>(0.0)));
    ASSERT_EQ(before.size, 4U);
    for (const double way : {1e-12, -1e-12, 1e-7, -1e-7}) {
      for (Dim i = 0; i < 3; ++i) {
        const auto after = manifold_of<3, double>(lower, upper_at(unit_axis<3>(i) * way));
        EXPECT_TRUE((ContactIds<Space<3, double>>::same_ids(before, after))) << way << " along " << i;
      }
    }
  }
}

}  // namespace
}  // namespace graze::test::manifold_ids_test
