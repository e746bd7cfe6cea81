// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/segment_filter.hpp>

namespace graze::segment_filter_test {
namespace {

template <Dim N>
Vec<N, double> any_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-2, 2);
  Vec<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = coordinate(random);
  return result;
}

/// A decided answer equals that of the exact distance, at reaches from far to just beyond and just within.
template <Dim N>
void check_against_distance() {
  std::mt19937 random(20261121);
  int answers = 0;
  int cases = 0;
  for (int i = 0; i < 5000; ++i) {
    const Segment<N, double> a{any_vector<N>(random), any_vector<N>(random)};
    const Segment<N, double> b{any_vector<N>(random), any_vector<N>(random)};
    const double distance = std::sqrt(distance_squared(a, b));
    for (const double off : {-1.0, -1e-3, -1e-9, -1e-11, -1e-13, 0.0, 1e-13, 1e-11, 1e-9, 1e-3, 1.0}) {
      const double reach = distance + off;
      if (reach <= 0) continue;
      ++cases;
      const auto quick = detail::filter_of_segments(a, b, reach);
      if (!quick) continue;
      ++answers;
      EXPECT_EQ(*quick, off < 0 ? Relation::apart : Relation::overlapping) << "case " << i << ", off by " << off;
    }
  }
  EXPECT_GT(answers, cases / 2);
}

TEST(SegmentFilter, AgreesWithTheCarefulDistanceIn2D) { check_against_distance<2>(); }
TEST(SegmentFilter, AgreesWithTheCarefulDistanceIn3D) { check_against_distance<3>(); }

TEST(SegmentFilter, KnowsThatSegmentsOfThePlaneCross) {
  const Segment<2, double> flat{{0, 0}, {2, 0}};
  EXPECT_EQ(detail::filter_of_segments(flat, {{1, -1}, {1, 1}}, 0), Relation::overlapping);
  EXPECT_EQ(detail::filter_of_segments(flat, {{3, -1}, {3, 1}}, 0), Relation::apart);
}

TEST(SegmentFilter, LeavesTouchingParallelAndPointsToTheCarefulForm) {
  const Segment<2, double> flat{{0, 0}, {2, 0}};
  EXPECT_FALSE(detail::filter_of_segments(flat, {{1, 0}, {1, 1}}, 0));
  EXPECT_FALSE(detail::filter_of_segments(flat, {{2, -1}, {2, 1}}, 0));
  EXPECT_FALSE(detail::filter_of_segments(flat, {{0, 5}, {2, 5}}, 0));
  EXPECT_FALSE(detail::filter_of_segments(flat, {{0, 5}, {0, 5}}, 0));
}

TEST(SegmentFilter, CallsNothingOverlappingThatHoldsNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Segment<2, double> flat{{-1, 0}, {1, 0}};
  for (int field = 0; field < 4; ++field) {
    Segment<2, double> upright{{0, -1}, {0, 1}};
    (field < 2 ? upright.start : upright.end)[field % 2] = nan;
    EXPECT_NE(detail::filter_of_segments(flat, upright, 1), Relation::overlapping) << field;
    EXPECT_NE(detail::filter_of_segments(upright, flat, 1), Relation::overlapping) << field;
  }
}

}  // namespace
}  // namespace graze::segment_filter_test
