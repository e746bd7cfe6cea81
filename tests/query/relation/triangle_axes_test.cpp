// SPDX-License-Identifier: MIT
// relation_triangle_test.cpp tests whole verdicts; this tests the contract of each test of axes.
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/relation/triangle_axes.hpp>

#include "catalogue.hpp"
#include "exact.hpp"

namespace graze::test::triangle_axes_test {
namespace {

using V3 = Vec<3, double>;
using T3 = Triangle<3, double>;

TEST(Projection, IsWhatAShapeCoversOfAnAxis) {
  const auto expect = [](const detail::Projection& shadow, double low, double high) {
    EXPECT_EQ(shadow.low, low);
    EXPECT_EQ(shadow.high, high);
  };
  const V3 axis(1, -2, 0);
  expect(detail::projection_on(axis, V3(3, 1, 9)), 1, 1);
  expect(detail::projection_on(axis, Segment<3, double>{{-1, -1, 0}, {1, 1, 0}}), -1, 1);
  expect(detail::projection_on(axis, Aabb<3, double>{{-1, -2, -3}, {1, 2, 3}}), -5, 5);
  expect(detail::projection_on(axis, Obb<3, double>{{0, 0, 0}, {1, 2, 3}, Mat<3, double>(0, 1, 0, 1, 0, 0, 0, 0, 1)}),
         -4, 4);
  expect(detail::projection_on(axis, T3{{0, 0, 5}, {3, 0, 0}, {0, 3, 0}}), -6, 3);
  EXPECT_EQ(detail::gap_between({-6, 3}, {5, 7}), 2);
  EXPECT_EQ(detail::gap_between({5, 7}, {-6, 3}), 2);
  EXPECT_EQ(detail::gap_between({-6, 3}, {1, 7}), -2);
}

TEST(AccurateAxes, CannotTellPointsAndLinesApart) {
  // All edges are parallel: only the distance decides.
  const Segment<3, double> along{{-1, 0, 0}, {1, 0, 0}};
  const T3 beyond{{5, 0, 0}, {6, 0, 0}, {7, 0, 0}};
  EXPECT_EQ((detail::AccurateAxes<3, Segment<3, double>>(along, beyond, 1e-14).verdict()), Relation::touching);
}

TEST(AccurateAxes, PartShapesOfOnePlane) {
  const T3 a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const T3 b{{3, 3, 0}, {9, 9, 0}, {9, 8, 0}};
  EXPECT_EQ((detail::AccurateAxes<3, T3>(a, b, 1e-13).verdict()), Relation::apart);
  EXPECT_EQ((detail::AccurateAxes<3, T3>(a, a, 1e-13).verdict()), Relation::touching);
}

template <class S>
void expect_quick_verdicts_are_true(const rc::Gen<S>& any_other) {
  check_property([&] {
    const Source<3, double> source = source_of<3, double>(*rc::gen::elementOf(kinds));
    const T3 triangle = *Entry<T3>::any(source);
    const S other = *any_other;
    const double extent = std::max(detail::extent_around_zero(other), detail::extent_around_zero(triangle));
    const std::optional<Relation> quick = detail::QuickAxes<S>(other, triangle, tolerance::coarse * extent).verdict();
    if (!quick) return;
    RC_ASSERT(*quick == exact_verdict_of(other, triangle, Measure::distance).relation);
  });
}

TEST(QuickAxes, HardlyEverLeavePlainNumbersOpen) {
  std::mt19937 random(20261121);
  const auto number = [&random] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  const auto corner = [&number] {
    const double x = number();
    const double y = number();
    return V3(x, y, number());
  };
  constexpr int cases = 1000;
  int answers = 0;
  for (int k = 0; k < cases; ++k) {
    const Segment<3, double> segment{corner(), corner()};
    const T3 triangle{corner(), corner(), corner()};
    answers += detail::QuickAxes<Segment<3, double>>(segment, triangle, tolerance::coarse).verdict() ? 1 : 0;
  }
  EXPECT_GT(answers, cases * 9 / 10);
}

TEST(QuickAxes, AreRightOrSilent) {
  const Source<3, double> source = source_of<3, double>(Kind::uniform);
  expect_quick_verdicts_are_true(rc::gen::map(source.point, [](const V3& end) {
    return Segment<3, double>{-end, end};
  }));
  expect_quick_verdicts_are_true(rc::gen::map(source.point, [](const V3& half) {
    return Aabb<3, double>{-abs(half), abs(half)};
  }));
  expect_quick_verdicts_are_true(rc::gen::map(Entry<Obb<3, double>>::any(source), [](Obb<3, double> box) {
    box.center = V3(0.0);
    return box;
  }));
  expect_quick_verdicts_are_true(Entry<T3>::any(source));
}

}  // namespace
}  // namespace graze::test::triangle_axes_test
