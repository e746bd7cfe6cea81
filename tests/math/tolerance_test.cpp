// SPDX-License-Identifier: MIT
// Every tolerance has a reason; these tests verify it.
#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/shape/obb.hpp>

#include "../catalogue.hpp"

namespace graze::tolerance_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

TEST(Tolerance, EpsilonIsTheSpacingAboveOne) { EXPECT_EQ(1 + tolerance::epsilon, std::nextafter(1.0, 2.0)); }

RC_GTEST_PROP(Tolerance, RoundingCoversATripleProductOfDifferences, ()) {
  const auto from = test::draw_source<3, double>();
  const Vec<3, double> a = *from.point;
  const Vec<3, double> b = *from.point;
  const Vec<3, double> e = *from.direction;
  const Vec<3, double> f = *from.direction;
  Rational exact = 0;
  double magnitude = 0;
  for (Dim i = 0; i < 3; ++i) {
    const Dim j = (i + 1) % 3;
    const Dim k = (i + 2) % 3;
    const Rational minor = Rational(e[j]) * Rational(f[k]) - Rational(e[k]) * Rational(f[j]);
    exact += (Rational(b[i]) - Rational(a[i])) * minor;
    magnitude += std::fabs(b[i] - a[i]) * (std::fabs(e[j] * f[k]) + std::fabs(e[k] * f[j]));
  }
  const Rational error = Rational(dot(b - a, cross(e, f))) - exact;
  RC_ASSERT(abs(error) <= Rational(tolerance::rounding) * Rational(magnitude));
}

TEST(Tolerance, OrthonormalAcceptsAThousandFloatRotationsMultiplied) {
  // The same rotation each time, so that its own error accumulates.
  const Mat<3, float> step = Mat<3, float>(rotation_matrix(Vec<3, double>(1, 2, 3), 37));
  Mat<3, float> turned(1.0F);
  for (int i = 0; i < 1000; ++i) turned = step * turned;
  EXPECT_GT((orthonormal_error<3, float>(turned)), 0);
  EXPECT_LT((orthonormal_error<3, float>(turned)), tolerance::orthonormal);
}

TEST(Tolerance, OrthonormalRefusesScaleAndShear) {
  const Mat<2, double> turn = rotation_matrix(20);
  EXPECT_LT((orthonormal_error<2, double>(turn)), tolerance::orthonormal);
  EXPECT_GT((orthonormal_error<2, double>(turn * 1.001)), tolerance::orthonormal);
  EXPECT_GT((orthonormal_error<2, double>(Mat<2, double>({1, 0}, {0.001, 1}))), tolerance::orthonormal);
}

TEST(Tolerance, GjkCanReachItsGapAboveTheNoiseOfSupports) {
  EXPECT_GT(tolerance::gjk_relative_gap, tolerance::convex);
  EXPECT_GT(tolerance::convex, tolerance::rounding);
}

TEST(Tolerance, BoxSlackExceedsTheBandOfEveryVerdict) {
  EXPECT_GT(tolerance::box_slack, 2 * tolerance::convex);
  EXPECT_GT(tolerance::box_slack, 2 * tolerance::rounding);
}

RC_GTEST_PROP(Tolerance, SurfaceCoversAPointOfASegmentCalculatedInFloat, ()) {
  const auto from = test::draw_source<3, float>();
  const Vec<3, float> start = *from.point;
  const Vec<3, float> end = *from.point;
  const float share = static_cast<float>(*rc::gen::inRange(0, 101)) / 100;
  const Vec<3, float> middle = start * (1 - share) + end * share;
  const double part = static_cast<double>(share);
  const Vec<3, double> exact = wide<3, float>(start) + (wide<3, float>(end) - wide<3, float>(start)) * part;
  const Vec<3, double> off = wide<3, float>(middle) - exact;
  const auto largest = static_cast<double>(std::max(max_abs(start), max_abs(end)));
  RC_ASSERT(std::sqrt(dot(off, off)) <= tolerance::surface<float> * largest);
}

TEST(Tolerance, SurfaceIsWiderThanTheBandsInDouble) {
  EXPECT_GE(tolerance::surface<double>, tolerance::rounding);
  EXPECT_EQ(tolerance::surface<float>, 8 * 0x1p-23);
}

TEST(Tolerance, UsersShapesGetTheBandOfTheirOwnNumbers) {
  EXPECT_EQ(tolerance::convex_in<double>, tolerance::convex);
  EXPECT_EQ(tolerance::convex_in<float>, 32.0 * 0x1p-23);
}

}  // namespace
}  // namespace graze::tolerance_test
