// SPDX-License-Identifier: MIT
// The law of scale at the ends of the range: what is 2^400 times as large, or as small, has the same answers, as many
// times as large, within the errors that they come with. Products of three coordinates leave the range of double there.
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/visit.hpp>

#include "catalogue.hpp"
#include "query/case_maker.hpp"
#include "query/contacts.hpp"
#include "query/pairs.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::scale_laws_test {
namespace {

using V3 = Vec<3, double>;
using Any = AnyShape<3, double>;

/// Every length times a power of two; directions stay.
struct Scaler {
  double unit;

  Any operator()(const V3& point) const { return point * unit; }
  Any operator()(const Segment<3, double>& s) const { return Segment<3, double>{s.start * unit, s.end * unit}; }
  Any operator()(const Ray<3, double>& ray) const { return Ray<3, double>{ray.origin * unit, ray.direction}; }
  Any operator()(const Sphere<3, double>& s) const { return Sphere<3, double>{s.center * unit, s.radius * unit}; }
  Any operator()(const Aabb<3, double>& box) const { return Aabb<3, double>{box.min * unit, box.max * unit}; }
  Any operator()(const Obb<3, double>& box) const {
    return Obb<3, double>{box.center * unit, box.half_extents * unit, box.axes};
  }
  Any operator()(const Plane<3, double>& p) const { return Plane<3, double>{p.normal, p.offset * unit}; }
  Any operator()(const HalfSpace<3, double>& h) const { return HalfSpace<3, double>{h.normal, h.offset * unit}; }
  Any operator()(const Triangle<3, double>& t) const { return Triangle<3, double>{t.a * unit, t.b * unit, t.c * unit}; }
  Any operator()(const Capsule<3, double>& c) const {
    return Capsule<3, double>{c.a * unit, c.b * unit, c.radius * unit};
  }
  Any operator()(const Polytope<3, double>& polytope) const {
    std::vector<V3> points;
    for (const V3& vertex : polytope.vertices()) points.push_back(vertex * unit);
    return convex_hull<3, double>(points);
  }
  Any operator()(const Compound<3, double>& compound) const {
    std::vector<Any> parts;
    for (const Part<3, double>& part : compound.parts) parts.push_back(detail::visit(*this, part.shape));
    return compound_of<3, double>(std::move(parts));
  }
};

void expect_same_answers(const Any& a, const Any& b, double unit) {
  const Any large_a = detail::visit(Scaler{unit}, a);
  const Any large_b = detail::visit(Scaler{unit}, b);
  EXPECT_EQ((relation_of<3, double>(large_a, large_b)), (relation_of<3, double>(a, b)));
  const auto near = proximity_of<3, double>(a, b);
  const auto near_large = proximity_of<3, double>(large_a, large_b);
  if (std::isfinite(near.distance)) {
    EXPECT_NEAR(near_large.distance / unit, near.distance, near.error + near_large.error / unit);
  }
  const auto contact = penetration_of<3, double>(a, b);
  const auto contact_large = penetration_of<3, double>(large_a, large_b);
  EXPECT_EQ(contact.has_value(), contact_large.has_value());
  if (contact && contact_large && std::isfinite(contact->depth)) {
    EXPECT_NEAR(contact_large->depth / unit, contact->depth, contact->error + contact_large->error / unit);
  }
  const V3 motion(3, -2, 5);
  const auto impact = impact_of<3, double>(a, motion, b);
  const auto impact_large = impact_of<3, double>(large_a, motion * unit, large_b);
  EXPECT_EQ(impact.has_value(), impact_large.has_value());
  if (const auto* ray = std::get_if<Ray<3, double>>(&b)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto hit = hit_of<3, double>(a, *ray, infinity);
    const auto hit_large = hit_of<3, double>(large_a, std::get<Ray<3, double>>(large_b), infinity);
    EXPECT_EQ(hit.has_value(), hit_large.has_value());
  }
}

/// Every pair of types, as the numbers of `uniform` and `grid` make them, often with a point in common.
TEST(ScaleLaw, AnswersOfEveryPairAreTheSame2To400TimesLargerOrSmaller) {
  constexpr std::size_t types = std::variant_size_v<Any>;
  for (std::size_t i = 0; i < types; ++i) {
    for (std::size_t j = 0; j < types; ++j) {
      CaseMaker<3, double> maker(i, j, 17 * i + j);
      for (const CaseKind kind : {CaseKind::uniform, CaseKind::grid, CaseKind::uniform, CaseKind::grid}) {
        for (const auto& [a, b] : maker.make(kind)) {
          for (const double unit : {0x1p400, 0x1p-400}) {
            SCOPED_TRACE((to_source<3, double>(a) + ", " + to_source<3, double>(b)));
            expect_same_answers(a, b, unit);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace graze::test::scale_laws_test
