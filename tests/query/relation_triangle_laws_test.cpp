// SPDX-License-Identifier: MIT
// Laws of the closed forms of triangles: no order changes a verdict, and the generic answer is the same.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/orders_of.hpp"

namespace graze::test::relation_triangle_laws_test {
namespace {

using T3 = Triangle<3, double>;

/// b moved so that a corner is on one of a, up to a few rounding errors: verdicts depend on the last bit.
template <Dim N, class T>
Triangle<N, T> nudged_onto(const Triangle<N, T>& a, const Triangle<N, T>& b) {
  const Vec<N, T> offset = a.a - b.b;
  Triangle<N, T> moved{b.a + offset, b.b + offset, b.c + offset};
  for (Dim i = 0; i < N; ++i) {
    const auto steps = static_cast<T>(*rc::gen::inRange(-60, 61));
    moved.a[i] += steps * std::numeric_limits<T>::epsilon() * max_abs(b.b);
  }
  return moved;
}

template <class A, class B>
void check_all_orders(const A& a, const B& b) {
  const Relation expected = relation(a, b);
  RC_TAG(std::string(name_of(expected)));
  for (const A& same_a : orders_of(a)) {
    for (const B& same_b : orders_of(b)) {
      RC_ASSERT(relation(same_a, same_b) == expected);
      RC_ASSERT(relation(same_b, same_a) == expected);
    }
  }
}

TEST(RelationTriangleLaw, TheOrderOfCornersAndArgumentsChangesNothing) {
  check_property([] {
    const auto [a, b] = *any_pair<T3, T3>();
    check_all_orders(a, *rc::gen::arbitrary<bool>() ? b : nudged_onto(a, b));
  });
  check_property([] {
    const auto [a, b] = *any_pair<Triangle<2, double>, Triangle<2, double>>();
    check_all_orders(a, *rc::gen::arbitrary<bool>() ? b : nudged_onto(a, b));
  });
  check_property([] {
    const auto [a, b] = *any_pair<T3, Obb<3, double>>();
    check_all_orders(a, b);
  });
  check_property([] {
    const auto [a, b] = *any_pair<T3, Capsule<3, double>>();
    check_all_orders(a, b);
  });
}

/// The closed form and the generic answer differ only within rounding.
template <class A, class B>
void expect_generic_agrees() {
  check_property([] {
    const auto [a, b] = *any_pair<A, B>();
    const Relation closed = relation(a, b);
    const Relation generic = detail::relation_of_convex(a, b);
    if (closed == generic) return;
    const ExactVerdict truth = exact_verdict_of(a, b, Measure::depth);
    RC_LOG() << "closed: " << name_of(closed) << ", generic: " << name_of(generic) << ", gap " << truth.gap << "\n";
    RC_ASSERT(closed == Relation::touching || generic == Relation::touching || truth.relation == Relation::touching);
    RC_ASSERT(std::fabs(truth.gap) <= 128 * tolerance::epsilon * truth.largest);
  });
}

TEST(RelationTriangleLaw, IsAsTheGenericAnswerHasIt) {
  expect_generic_agrees<Obb<3, double>, T3>();
  expect_generic_agrees<T3, T3>();
  expect_generic_agrees<T3, Capsule<3, double>>();
}

}  // namespace
}  // namespace graze::test::relation_triangle_laws_test
