// SPDX-License-Identifier: MIT
// The closed form of casts of boxes, capsules and spheres: hits calculated by hand, and against GJK, which decides what
// the closed form leaves open.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/shape_cast.hpp>

#include "catalogue.hpp"
#include "query/case_maker.hpp"
#include "query/placement.hpp"

namespace graze::test::zonotope_cast_test {
namespace {

using detail::RayVerdict;

/// Two shapes that are apart, in the form of the closed form.
template <class A, class B>
struct Flight {
  static constexpr Dim dimension = dimension_of<A>;
  using Vector = Vec<dimension, double>;

  Flight(const A& a, const Vec<dimension, scalar_of<A>>& way, const B& b)
      : origin(detail::reference(detail::core(a))),
        core_a(detail::relative_to(origin, detail::core(a))),
        core_b(detail::relative_to(origin, detail::core(b))),
        motion(wide<dimension, scalar_of<A>>(way)),
        radii{detail::core_radius(a), detail::core_radius(b)} {}

  detail::CastHitOfZonotopes<dimension> closed() const {
    return detail::cast_hit_of_zonotopes(core_a, motion, core_b, radii);
  }
  auto by_gjk() const { return detail::cast_hit_of_cores(core_a, motion, core_b, radii); }

  auto a_at(double t) const { return detail::relative_to(motion * -t, core_a); }
  double size() const {
    return detail::size_around_zero(core_a) + detail::size_around_zero(core_b) + radii.a + radii.b + sum_abs(motion);
  }

  /// The error of a contact between two cores, or a point and one, that are inflated.
  template <class C, class D>
  double gap(const C& c, const D& d, double radius) const {
    return std::sqrt(detail::closest_of_touching(c, d, size()).squared) - radius;
  }

  Vector origin;
  decltype(detail::relative_to(origin, detail::core(std::declval<const A&>()))) core_a;
  decltype(detail::relative_to(origin, detail::core(std::declval<const B&>()))) core_b;
  Vector motion;
  detail::Radii radii;
};

// ---- By hand

template <class A, class B>
void expect_hit(const A& a, const Vec<3, double>& motion, const B& b, double t, const Vec<3, double>& point,
                const Vec<3, double>& normal) {
  const Flight<A, B> flight(a, motion, b);
  const auto found = flight.closed();
  ASSERT_EQ(found.verdict, RayVerdict::hits);
  EXPECT_NEAR(found.cast_hit.t, t, 1e-14);
  EXPECT_LE(max_abs(found.cast_hit.point + flight.origin - point), 1e-14);
  EXPECT_LE(max_abs(found.cast_hit.normal - normal), 1e-14);
  EXPECT_LE(found.cast_hit.error, 1e-12);
}

template <class A, class B>
RayVerdict sight_of_cast(const A& a, const Vec<3, double>& motion, const B& b) {
  return Flight<A, B>(a, motion, b).closed().verdict;
}

const double root = std::sqrt(0.5);
/// An edge along z is foremost towards -x, at a distance of sqrt 2 from the center, and one along y of the other.
const Obb<3, double> upright{{0, 0, 0}, {1, 1, 4}, {{root, root, 0}, {-root, root, 0}, {0, 0, 1}}};
const Obb<3, double> lying{{-8, 0.25, 0}, {1, 4, 1}, {{root, 0, root}, {0, 1, 0}, {-root, 0, root}}};

TEST(ZonotopeCast, FindsWhereTwoEdgesOfBoxesCross) {
  const double gap = 8 - 2 * std::sqrt(2.0);
  expect_hit(lying, {10, 0.5, -0.75}, upright, gap / 10, {-std::sqrt(2.0), 0, -0.075 * gap}, {1, 0, 0});
}

TEST(ZonotopeCast, FindsWhereABallMeetsAFaceAnEdgeAndACornerOfATurnedBox) {
  const double side = std::sqrt(2.0);
  expect_hit(Sphere<3, double>{{-8, 0, 1}, 0.5}, {10, 0, 0}, upright, (7.5 - side) / 10, {-side, 0, 1}, {1, 0, 0});
  expect_hit(Sphere<3, double>{{-root * 5, root * 5, 1}, 0.5}, {root * 8, -root * 8, 0}, upright, 3.5 / 8,
             {-root, root, 1}, {root, -root, 0});
  const double third = std::sqrt(1.0 / 3);
  const Vec<3, double> corner(-side, 0, 4);
  const Vec<3, double> out(-third, 0, std::sqrt(2.0 / 3));
  expect_hit(Sphere<3, double>{corner + out * 5.0, 1}, out * -8.0, upright, 0.5, corner, -out);
}

TEST(ZonotopeCast, FindsWhereCapsulesMeetCrossedInLineAndSideBySide) {
  const Capsule<3, double> standing{{0, 0, -3}, {0, 0, 3}, 1};
  expect_hit(Capsule<3, double>{{-6, -2, 0}, {-6, 4, 1}, 1}, {8, 0, 0}, standing, 0.5, {-1, 0, 1.0 / 3}, {1, 0, 0});
  expect_hit(Capsule<3, double>{{0, 0, 9}, {0, 0, 12}, 1}, {0, 0, -8}, standing, 0.5, {0, 0, 4}, {0, 0, -1});
  const Flight side_by_side(Capsule<3, double>{{-6, 0, 1}, {-6, 0, 9}, 1}, Vec<3, double>(8, 0, 0), standing);
  const auto found = side_by_side.closed();
  ASSERT_EQ(found.verdict, RayVerdict::hits);
  EXPECT_NEAR(found.cast_hit.t, 0.5, 1e-15);
  EXPECT_NEAR(found.cast_hit.point.x + side_by_side.origin.x, -1, 1e-14);
  const double height = found.cast_hit.point.z + side_by_side.origin.z;
  EXPECT_TRUE(height >= 1 && height <= 3) << "anywhere along what both share";
}

/// A box that lands flat on another rotated about the vertical, and a capsule parallel to no edge.
TEST(ZonotopeCast, FindsAPointWhereShapesLieFlatOnEachOther) {
  const Obb<3, double> falling{{0.5, 0, 9}, {1, 1, 1}};
  const Capsule<3, double> log{{-2, -1, 9}, {2, 0.5, 9}, 1};
  for (const auto& found : {Flight(falling, Vec<3, double>(0, 0, -8), upright).closed(),
                            Flight(log, Vec<3, double>(0, 0, -8), upright).closed()}) {
    ASSERT_EQ(found.verdict, RayVerdict::hits);
    EXPECT_NEAR(found.cast_hit.t, 0.5, 1e-15);
    EXPECT_EQ(found.cast_hit.normal, (Vec<3, double>(0, 0, -1)));
  }
}

TEST(ZonotopeCast, LeavesOpenWhatNearlyTouches) {
  const Obb<3, double> cube{{0, 0, 0}, {1, 1, 1}};
  const Capsule<3, double> pole{{-6, 0, -1}, {-6, 0, 1}, 1};
  for (const double off : {-1e-14, 0.0, 1e-14}) {
    EXPECT_EQ(sight_of_cast(Obb<3, double>{{-6, 2 + off, 0}, {1, 1, 1}}, {8, 0, 0}, cube), RayVerdict::unclear) << off;
    EXPECT_EQ(sight_of_cast(cube, {4 + off, 0, 0}, Obb<3, double>{{6, 0, 0}, {1, 1, 1}}), RayVerdict::unclear) << off;
    EXPECT_EQ(sight_of_cast(pole, {8, 0, 0}, Capsule<3, double>{{0, 2 + off, 0}, {0, 2, 0}, 1}), RayVerdict::unclear)
        << off;
  }
  for (const double off : {1e-9, 1e-3}) {
    EXPECT_EQ(sight_of_cast(Obb<3, double>{{-6, 2 + off, 0}, {1, 1, 1}}, {8, 0, 0}, cube), RayVerdict::misses) << off;
    EXPECT_EQ(sight_of_cast(Obb<3, double>{{-6, 2 - off, 0}, {1, 1, 1}}, {8, 0, 0}, cube), RayVerdict::hits) << off;
  }
}

TEST(ZonotopeCast, LeavesOpenWhatItHasNoNumbersFor) {
  const Obb<3, double> cube{{0, 0, 0}, {1, 1, 1}};
  const Obb<3, double> other{{6, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(sight_of_cast(cube, {1e-40, 0, 0}, other), RayVerdict::unclear);
  EXPECT_EQ(sight_of_cast(cube, {1e40, 0, 0}, other), RayVerdict::unclear);
  EXPECT_EQ(sight_of_cast(cube, {8, 0, 0}, Obb<3, double>{{6e40, 0, 0}, {1e40, 1e40, 1e40}}), RayVerdict::unclear);
}

// ---- Against GJK

struct Tally {
  std::size_t settled = 0;
  std::size_t open = 0;
};

template <Dim N>
void expect_same_strike(const detail::CastHit<N>& closed, const detail::CastHit<N>& by_gjk,
                        const Vec<N, double>& motion) {
  if (by_gjk.status != Status::converged) return;
  // Along the normal they are as close as their errors say; t is less accurate at a grazing angle.
  const double steepness = std::min(dot(closed.normal, motion), dot(by_gjk.normal, motion));
  EXPECT_LE(std::fabs(closed.t - by_gjk.t) * steepness, 2 * (closed.error + by_gjk.error));
}

/// Checks the contract of a hit, as far as nearest points tell.
template <class A, class B>
void expect_touch(const Flight<A, B>& flight, const detail::CastHit<dimension_of<A>>& cast_hit) {
  const auto a = flight.a_at(cast_hit.t);
  EXPECT_TRUE(cast_hit.t > 0 && cast_hit.t <= 1);
  EXPECT_LE(std::fabs(flight.gap(a, flight.core_b, flight.radii.a + flight.radii.b)), cast_hit.error);
  EXPECT_LE(flight.gap(cast_hit.point, flight.core_b, flight.radii.b), 2 * cast_hit.error);
  EXPECT_LE(flight.gap(cast_hit.point, a, flight.radii.a), 2 * cast_hit.error);
  EXPECT_LE(std::fabs(length(cast_hit.normal) - 1), 4 * tolerance::epsilon);
  EXPECT_GT(dot(cast_hit.normal, flight.motion), 0);
  EXPECT_LE(cast_hit.error, tolerance::coarse * flight.size());
}

template <class A, class B>
void expect_agreement(const A& a, const Vec<dimension_of<A>, scalar_of<A>>& motion, const B& b, Tally& tally) {
  if (max_abs(motion) == 0 || detail::penetration(a, b)) return;
  SCOPED_TRACE(to_source(a) + ", " + to_source(motion) + ", " + to_source(b));
  const Flight<A, B> flight(a, motion, b);
  const auto closed = flight.closed();
  (closed.verdict == RayVerdict::unclear ? tally.open : tally.settled) += 1;
  if (closed.verdict == RayVerdict::unclear) return;
  const auto by_gjk = flight.by_gjk();
  EXPECT_EQ(closed.verdict == RayVerdict::hits, by_gjk.has_value());
  if (closed.verdict != RayVerdict::hits) return;
  expect_touch(flight, closed.cast_hit);
  if (by_gjk) expect_same_strike(closed.cast_hit, *by_gjk, flight.motion);
}

/// The first shape is moved away, by up to a few times the size of both, and comes back: to its position and beyond,
/// past it at some distance, or in one case of four to its position and no farther.
template <Dim N, class T>
struct Approach {
  Approach(const AnyPair<N, T>& pair, rc::Random& random) {
    const double size = reach(pair.first) + reach(pair.second);
    const Vec<N, double> way = any_way<N>(random) * (size * between(random, 0.1, 3));
    start = moved<N, T>(pair.first, Vec<N, T>(-way));
    ends_there = whole(random, 0, 3) == 0;
    motion = Vec<N, T>(way);
    if (ends_there) return;
    motion = Vec<N, T>((way + any_way<N>(random) * (size * between(random, 0, 0.3))) * between(random, 1.2, 3));
  }

  static double reach(const AnyShape<N, T>& shape) {
    const auto box = bounds(shape);
    return sum_abs(wide<N, T>(box.max) - wide<N, T>(box.min));
  }

  AnyShape<N, T> start;
  Vec<N, T> motion;
  bool ends_there;
};

template <class A, class B>
void expect_agreement_of_kind(CaseKind kind, int rounds) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  CaseMaker<N, T> maker(shape_index<A>, shape_index<B>, 20261126);
  rc::Random random(7);
  Tally passing;
  Tally ending;
  for (int round = 0; round < rounds; ++round) {
    for (const AnyPair<N, T>& pair : maker.make(kind)) {
      const Approach<N, T> approach(pair, random);
      expect_agreement(std::get<A>(approach.start), approach.motion, std::get<B>(pair.second),
                       approach.ends_there ? ending : passing);
    }
  }
  EXPECT_GT(passing.settled, static_cast<std::size_t>(rounds) / 4);
  // For shapes in general position, nearly all are decided.
  if (kind == CaseKind::uniform) {
    EXPECT_LE(passing.open, (passing.open + passing.settled) / 20);
  }
}

template <class A, class B>
void expect_agreement_of_pair() {
  for (std::size_t i = 0; i < case_kind_count; ++i) {
    const auto kind = static_cast<CaseKind>(i);
    SCOPED_TRACE(case_kind_names[i]);
    expect_agreement_of_kind<A, B>(kind, 400);
  }
}

template <class SpaceType>
class ZonotopeCastOf : public ::testing::Test {};

TYPED_TEST_SUITE(ZonotopeCastOf, test::Spaces);

TYPED_TEST(ZonotopeCastOf, BoxesAgreesWithGjk) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  expect_agreement_of_pair<Aabb<N, T>, Obb<N, T>>();
  expect_agreement_of_pair<Obb<N, T>, Obb<N, T>>();
}

TYPED_TEST(ZonotopeCastOf, ASphereAndABoxAgreesWithGjk) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  expect_agreement_of_pair<Sphere<N, T>, Obb<N, T>>();
}

TYPED_TEST(ZonotopeCastOf, CapsulesAgreesWithGjk) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  expect_agreement_of_pair<Capsule<N, T>, Capsule<N, T>>();
}

TYPED_TEST(ZonotopeCastOf, ABoxAndACapsuleAgreesWithGjk) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  expect_agreement_of_pair<Aabb<N, T>, Capsule<N, T>>();
  expect_agreement_of_pair<Obb<N, T>, Capsule<N, T>>();
}

}  // namespace
}  // namespace graze::test::zonotope_cast_test
