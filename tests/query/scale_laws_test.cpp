// SPDX-License-Identifier: MIT
// Scale invariance: shapes scaled by 2^k have answers scaled by 2^k, to the last bit, from the smallest subnormal
// numbers to the largest ones. Mixed sizes give finite answers that agree.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/random/linear_congruential.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/case_maker.hpp"
#include "query/contacts.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/point_answers.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/scaled_shapes.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::scale_laws_test {
namespace {

template <Dim N>
using Any = AnyShape<N, double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Equal, or both NaN, like the points at infinite distances.
bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

template <Dim N>
bool is_same(const Vec<N, double>& a, const Vec<N, double>& b) {
  for (Dim i = 0; i < N; ++i) {
    if (!is_same(a[i], b[i])) return false;
  }
  return true;
}

/// The distance of shapes that are apart is never zero.
double scaled_distance(double distance, int exponent) {
  const double result = scaled(distance, exponent);
  return distance > 0 && result == 0 ? std::numeric_limits<double>::denorm_min() : result;
}

template <Dim N>
void expect_same_pair(const Any<N>& a, const Any<N>& b, int exponent) {
  const Any<N> large_a = scaled<N, double>(a, exponent);
  const Any<N> large_b = scaled<N, double>(b, exponent);
  EXPECT_EQ((relation_of<N, double>(large_a, large_b)), (relation_of<N, double>(a, b)));
  const auto near = closest_points_of<N, double>(a, b);
  const auto near_large = closest_points_of<N, double>(large_a, large_b);
  EXPECT_EQ(near_large.relation, near.relation);
  EXPECT_EQ(near_large.distance, scaled_distance(near.distance, exponent));
  EXPECT_TRUE(is_same<N>(near_large.point_a, scaled<N, double>(near.point_a, exponent)));
  EXPECT_TRUE(is_same<N>(near_large.point_b, scaled<N, double>(near.point_b, exponent)));
  EXPECT_EQ(near_large.normal, near.normal);
  const auto contact = contact_of<N, double>(a, b);
  const auto contact_large = contact_of<N, double>(large_a, large_b);
  ASSERT_EQ(contact.has_value(), contact_large.has_value());
  if (contact) {
    EXPECT_EQ(contact_large->depth, scaled(contact->depth, exponent));
    EXPECT_TRUE(is_same<N>(contact_large->point_a, scaled<N, double>(contact->point_a, exponent)));
    EXPECT_TRUE(is_same<N>(contact_large->point_b, scaled<N, double>(contact->point_b, exponent)));
    EXPECT_EQ(contact_large->normal, contact->normal);
  }
  const auto manifold = manifold_of<N, double>(a, b);
  const auto manifold_large = manifold_of<N, double>(large_a, large_b);
  ASSERT_EQ(manifold.size, manifold_large.size);
  for (std::size_t i = 0; i < manifold.size; ++i) {
    EXPECT_TRUE(is_same<N>(manifold_large.points[i].point_a, scaled<N, double>(manifold.points[i].point_a, exponent)));
    EXPECT_EQ(manifold_large.points[i].id, manifold.points[i].id);
  }
}

template <Dim N, class Found>
void expect_same_hit(const Found& hit, const Found& large, int exponent) {
  ASSERT_EQ(hit.has_value(), large.has_value());
  if (!hit) return;
  EXPECT_EQ(large->t, hit->t);
  // Rounding of the midpoint of two points among the smallest numbers: half a step in each half, and one in their sum.
  const double steps = 2 * std::numeric_limits<double>::denorm_min();
  EXPECT_LE(max_abs(large->point - scaled<N, double>(hit->point, exponent)), exponent < -1000 ? steps : 0.0);
  EXPECT_EQ(large->normal, hit->normal);
}

template <Dim N>
void expect_same_way(const Any<N>& a, const Any<N>& b, int exponent) {
  Vec<N, double> motion(3.0);
  motion[0] = -2;
  const Any<N> large_a = scaled<N, double>(a, exponent);
  const Vec<N, double> large_motion = scaled<N, double>(motion, exponent);
  expect_same_hit<N>(impact_of<N, double>(a, motion, b),
                     impact_of<N, double>(large_a, large_motion, scaled<N, double>(b, exponent)), exponent);
  if (const auto* const ray = std::get_if<Ray<N, double>>(&b)) {
    const Ray<N, double> large{scaled<N, double>(ray->origin, exponent), scaled<N, double>(ray->direction, exponent)};
    for (const RaySide side : {RaySide::entry, RaySide::exit}) {
      expect_same_hit<N>(hit_of<N, double>(a, *ray, infinity, {side}),
                         hit_of<N, double>(large_a, large, infinity, {side}), exponent);
    }
  }
  if (const auto* const point = std::get_if<Vec<N, double>>(&b)) {
    const auto answer = answers<N, double>(a, *point);
    const auto large = answers<N, double>(large_a, scaled<N, double>(*point, exponent));
    EXPECT_EQ(large.contained, answer.contained);
    EXPECT_EQ(large.distance, scaled_distance(answer.distance, exponent));
    EXPECT_TRUE(is_same<N>(large.closest, scaled<N, double>(answer.closest, exponent)));
    EXPECT_TRUE(is_same<N>(large.boundary, scaled<N, double>(answer.boundary, exponent)));
  }
}

/// Every pair of types with small integers, which have few bits: most are still exact at 2^-1060. Rotated shapes, which
/// are not, use larger scales.
template <Dim N>
void expect_same_answers() {
  constexpr std::size_t types = std::variant_size_v<Any<N>>;
  std::size_t all = 0;
  std::size_t exact = 0;
  for (std::size_t i = 0; i < types; ++i) {
    for (std::size_t j = 0; j < types; ++j) {
      CaseMaker<N, double> maker(i, j, 17 * i + j);
      for (const auto& [a, b] : maker.make(CaseKind::grid)) {
        for (const int exponent : {-1060, -1022, -600, -480, -120, 120, 480, 600, 1015}) {
          ++all;
          if (!scales_exactly<N, double>(a, exponent) || !scales_exactly<N, double>(b, exponent)) continue;
          ++exact;
          SCOPED_TRACE(
              (to_source<N, double>(a) + ", " + to_source<N, double>(b) + " times 2^" + std::to_string(exponent)));
          expect_same_pair<N>(a, b, exponent);
          expect_same_way<N>(a, b, exponent);
        }
      }
    }
  }
  EXPECT_GT(exact * 10, all * 9);
}

TEST(ScaleLaw, AnswersInThePlaneAreTheSameAtEitherEndOfDouble) { expect_same_answers<2>(); }

TEST(ScaleLaw, AnswersInSpaceAreTheSameAtEitherEndOfDouble) { expect_same_answers<3>(); }

/// Numbers of all sizes, many of them zero, equal or powers of two.
class MixedNumbers {
 public:
  explicit MixedNumbers(std::uint64_t seed) : draws_(seed) {}

  double size() {
    return draws_.below(6) == 0 ? 0.0 : scaled(1.0 + 0.25 * static_cast<double>(draws_.below(4)), exponent());
  }
  double number() { return draws_.below(2) == 0 ? size() : -size(); }
  template <Dim N>
  Vec<N, double> vec() {
    Vec<N, double> v;
    for (Dim i = 0; i < N; ++i) v[i] = number();
    return v;
  }
  template <Dim N>
  Vec<N, double> direction() {
    Vec<N, double> v = vec<N>();
    if (max_abs(v) == 0) v[0] = 1;
    return v;
  }

 private:
  int exponent() { return static_cast<int>(draws_.below(2090)) - 1072; }

  detail::LinearCongruential draws_;
};

template <Dim N>
std::vector<Any<N>> mixed_shapes(MixedNumbers& numbers) {
  const auto vec = [&] { return numbers.vec<N>(); };
  std::vector<Any<N>> shapes;
  shapes.push_back(vec());
  shapes.push_back(Segment<N, double>{vec(), vec()});
  shapes.push_back(Ray<N, double>{vec(), numbers.direction<N>()});
  shapes.push_back(Sphere<N, double>{vec(), numbers.size()});
  shapes.push_back(Aabb<N, double>::from_corners(vec(), vec()));
  shapes.push_back(Obb<N, double>{vec(), abs(vec()), Mat<N, double>(1.0)});
  shapes.push_back(Plane<N, double>{numbers.direction<N>(), numbers.number()});
  shapes.push_back(HalfSpace<N, double>{numbers.direction<N>(), numbers.number()});
  shapes.push_back(Triangle<N, double>{vec(), vec(), vec()});
  shapes.push_back(Capsule<N, double>{vec(), vec(), numbers.size()});
  shapes.push_back(convex_hull<N, double>(std::vector<Vec<N, double>>{vec(), vec(), vec(), vec()}));
  return shapes;
}

template <Dim N>
bool is_number(const Vec<N, double>& v) {
  for (Dim i = 0; i < N; ++i) {
    if (std::isnan(v[i])) return false;
  }
  return true;
}

template <Dim N>
void expect_numbers_that_agree(const Any<N>& a, const Any<N>& b) {
  const Relation verdict = relation_of<N, double>(a, b);
  EXPECT_EQ((relation_of<N, double>(b, a)), verdict);
  const auto near = closest_points_of<N, double>(a, b);
  EXPECT_EQ(near.relation, verdict);
  EXPECT_FALSE(std::isnan(near.distance));
  EXPECT_TRUE(is_number<N>(near.normal) && is_number<N>(near.point_a) && is_number<N>(near.point_b));
  const auto contact = contact_of<N, double>(a, b);
  EXPECT_EQ(contact.has_value(), verdict != Relation::apart);
  if (contact) {
    EXPECT_FALSE(std::isnan(contact->depth));
    EXPECT_TRUE(is_number<N>(contact->normal) && is_number<N>(contact->point_a) && is_number<N>(contact->point_b));
  }
  if (const auto* const ray = std::get_if<Ray<N, double>>(&b)) {
    const auto hit = hit_of<N, double>(a, *ray, infinity);
    EXPECT_TRUE(!hit || (!std::isnan(hit->t) && is_number<N>(hit->point) && is_number<N>(hit->normal)));
  }
  if (const auto* const point = std::get_if<Vec<N, double>>(&b)) {
    const auto answer = answers<N, double>(a, *point);
    EXPECT_TRUE(!std::isnan(answer.distance) && is_number<N>(answer.closest) && is_number<N>(answer.boundary));
  }
  if (const auto impact = impact_of<N, double>(a, Vec<N, double>(0x1p200), b)) {
    EXPECT_TRUE(impact->t >= 0 && impact->t <= 1 && is_number<N>(impact->point) && is_number<N>(impact->normal));
  }
}

template <Dim N>
void expect_numbers_of_mixed_shapes() {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    MixedNumbers numbers(seed);
    const std::vector<Any<N>> first = mixed_shapes<N>(numbers);
    const std::vector<Any<N>> second = mixed_shapes<N>(numbers);
    for (const Any<N>& a : first) {
      for (const Any<N>& b : second) {
        SCOPED_TRACE((to_source<N, double>(a) + ", " + to_source<N, double>(b)));
        expect_numbers_that_agree<N>(a, b);
      }
    }
  }
}

TEST(ScaleLaw, ShapesOfMixedSizesInThePlaneHaveAnswersThatAgree) { expect_numbers_of_mixed_shapes<2>(); }

TEST(ScaleLaw, ShapesOfMixedSizesInSpaceHaveAnswersThatAgree) { expect_numbers_of_mixed_shapes<3>(); }

}  // namespace
}  // namespace graze::test::scale_laws_test
