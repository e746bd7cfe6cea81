// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/relation/bounded.hpp>
#include <graze/query/relation/box_filter.hpp>
#include <graze/query/relation/obb_filter.hpp>

#ifdef GRAZE_HAS_LANES
namespace graze::obb_filter_test {
namespace {

using Box = Obb<3, float>;

/// Pairs of boxes with arbitrary, equal, almost equal or no rotation, with axes that are orthonormal or as skew as is
/// valid, solid or flat.
class PairMaker {
 public:
  struct Two {
    Box a, b;
  };

  Two make() {
    Two two{box(), box()};
    const int kind = whole(0, 3);
    if (kind == 1) two.b.axes = two.a.axes;
    if (kind == 2) {
      two.b.axes = two.a.axes;
      two.b.axes[0] += Vec<3, float>(vector(1e-5));
    }
    if (kind == 3) two.a.axes = two.b.axes = Mat<3, float>(1);
    return two;
  }

  Vec<3, double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private:
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Box box() {
    Vec<3, double> axis = vector(1);
    while (length_squared(axis) < 0.01) axis = vector(1);
    const Mat<3, double> turn = rotation_matrix(axis / std::sqrt(length_squared(axis)), number(0, 360));
    Box result{Vec<3, float>(vector(1.5)), Vec<3, float>(abs(vector(1))), Mat<3, float>(1)};
    for (Dim i = 0; i < 3; ++i) result.axes[i] = Vec<3, float>(turn[i]);
    if (whole(0, 2) == 0) {
      for (Dim i = 0; i < 3; ++i) result.axes[i] += Vec<3, float>(vector(2e-5));
    }
    if (whole(0, 3) == 0) result.half_extents[whole(0, 2)] = 0;
    return result;
  }

  std::mt19937 random_{20261122};
};

Relation careful(const Box& a, const Box& b) {
  return detail::relation_of_zonotopes(detail::zonotope(a), detail::zonotope(b));
}

/// How often the filter decided; it must not be wrong.
struct Tally {
  int cases = 0;
  int answers = 0;

  void put(const Box& a, const Box& b) {
    ++cases;
    const std::optional<Relation> quick = detail::filter_of_obbs(a, b);
    if (!quick) return;
    ++answers;
    EXPECT_EQ(*quick, careful(a, b)) << "case " << cases;
  }
};

TEST(ObbFilter, AgreesWithTheCarefulFormWheneverItAnswers) {
  PairMaker maker;
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    const auto [a, b] = maker.make();
    tally.put(a, b);
    tally.put(b, a);
  }
  EXPECT_GT(tally.answers, tally.cases * 9 / 10);
}

TEST(ObbFilter, SaysNothingWrongWhereBoxesTouch) {
  PairMaker maker;
  Tally tally;
  for (int i = 0; i < 4000; ++i) {
    PairMaker::Two two = maker.make();
    const Box& a = two.a;
    Box& b = two.b;
    // Away from each other along a line until they are apart, and back to where the verdict changes.
    const Vec<3, float> way(maker.vector(8));
    const Vec<3, float> start = b.center = a.center;
    if (careful(a, b) == Relation::apart) continue;
    float meets = 0;
    float parts = 1;
    const auto at = [&](float share) {
      b.center = start + share * way;
      return careful(a, b);
    };
    if (at(parts) != Relation::apart) continue;
    for (int k = 0; k < 30; ++k) {
      const float middle = (meets + parts) / 2;
      (at(middle) == Relation::apart ? parts : meets) = middle;
    }
    for (const float off : {0.0F, 1e-7F, -1e-7F, 1e-5F, -1e-5F, 1e-3F, -1e-3F, 1e-2F, -1e-2F}) {
      at(meets + off);
      tally.put(a, b);
    }
  }
  EXPECT_GT(tally.cases, 10000);
}

/// Boxes in stacks and rows have equal rotations: their parallel edges must not send each pair to the second stage.
TEST(ObbFilter, SettlesBoxesThatAreTurnedAlike) {
  Box a{{1, 2, 3}, {1, 2, 0.5F}, Mat<3, float>(1)};
  const Mat<3, double> turn = rotation_matrix(Vec<3, double>(0.6, 0, 0.8), 40);
  for (Dim i = 0; i < 3; ++i) a.axes[i] = Vec<3, float>(turn[i]);
  Box b = a;
  b.center += Vec<3, float>(0.25F, -0.5F, 0.125F);
  EXPECT_EQ(detail::filter_of_obbs(a, b), Relation::overlapping);
  b.center += 10.0F * a.axes[2];
  EXPECT_EQ(detail::filter_of_obbs(a, b), Relation::apart);
}

TEST(ObbFilter, LeavesNumbersAtTheEndsOfTheirRangeToOthers) {
  constexpr float most = std::numeric_limits<float>::max();
  constexpr float least = std::numeric_limits<float>::denorm_min();
  for (const float size : {most, std::numeric_limits<float>::infinity()}) {
    for (Dim i = 0; i < 3; ++i) {
      Box huge;
      huge.half_extents[i] = size;
      EXPECT_EQ(detail::filter_of_obbs(huge, huge), std::nullopt);
      Box far;
      far.center[i] = -size;
      Box opposite;
      opposite.center[i] = size;
      EXPECT_NE(detail::filter_of_obbs(far, opposite), Relation::overlapping);
    }
  }
  const Box speck{{0, 0, 0}, {least, least, least}, Mat<3, float>(1)};
  EXPECT_EQ(detail::filter_of_obbs(speck, speck), std::nullopt);
}

TEST(ObbFilter, HasNoAnswerForNan) {
  const Box box;
  for (Dim i = 0; i < 3; ++i) {
    std::vector<Box> broken(5, box);
    broken[0].center[i] = NAN;
    broken[1].half_extents[i] = NAN;
    for (Dim j = 0; j < 3; ++j) broken[2 + static_cast<std::size_t>(j)].axes[j][i] = NAN;
    for (const Box& other : broken) {
      EXPECT_EQ(detail::filter_of_obbs(box, other), std::nullopt);
      EXPECT_EQ(detail::filter_of_obbs(other, box), std::nullopt);
    }
  }
}

}  // namespace
}  // namespace graze::obb_filter_test
#endif
