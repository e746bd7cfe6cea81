// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/relation/bounded.hpp>
#include <graze/query/relation/box_filter.hpp>

namespace graze::box_filter_test {
namespace {

constexpr std::uint32_t seed = 20261121;

/// Boxes and segments of about unit size, near the origin.
template <Dim N>
class Maker {
 public:
  explicit Maker(std::uint32_t first) : random_(first) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  Vec<N, double> vector(double size) {
    Vec<N, double> result;
    for (Dim i = 0; i < N; ++i) result[i] = number(-size, size);
    return result;
  }

  Mat<N, double> rotation() {
    if constexpr (N == 2) {
      return rotation_matrix(number(0, 360));
    } else {
      Vec<3, double> axis = vector(1);
      while (length_squared(axis) < 0.01) axis = vector(1);
      return rotation_matrix(axis / std::sqrt(length_squared(axis)), number(0, 360));
    }
  }

  Aabb<N, double> aabb() { return Aabb<N, double>::from_corners(vector(1.5), vector(1.5)); }

  Segment<N, double> segment() { return {vector(2), vector(2)}; }

  /// One in three is rotated by less than 0.01, one in three has axes as far from orthonormal as is valid.
  Obb<N, double> obb() {
    Obb<N, double> box{vector(1.5), abs(vector(1)), Mat<N, double>(1.0)};
    const int kind = std::uniform_int_distribution<int>(0, 2)(random_);
    if (kind > 0) box.axes = rotation();
    if (kind == 0) box.axes[0] = box.axes[0] + vector(0.00005);
    if (kind == 1) {
      for (Dim i = 0; i < N; ++i) box.axes[i] += vector(0.00002);
    }
    return box;
  }

 private:
  std::mt19937 random_;
};

struct Tally {
  int cases = 0;
  int answers = 0;
};

/// A decided answer of the filter equals that of the exact form.
template <class Box, class Other>
void expect_agreement(const Box& box, const Other& other, Tally& tally) {
  const auto quick = detail::filter_of_box(box, other);
  const Relation careful = detail::relation_of_zonotopes(detail::zonotope(box), detail::zonotope(other));
  ++tally.cases;
  if (!quick) return;
  ++tally.answers;
  EXPECT_EQ(*quick, careful) << "case " << tally.cases;
}

/// The same with the other shape moved to where it just touches the box, and slightly off it.
template <class Box, class Other, class Move>
void expect_agreement_at_border(const Box& box, const Other& other, const Move& move, Tally& tally) {
  const auto meets = [&](double t) {
    const Other moved = move(other, t);
    return detail::relation_of_zonotopes(detail::zonotope(box), detail::zonotope(moved)) != Relation::apart;
  };
  double near = 0;
  double far = 8;
  if (!meets(near) || meets(far)) return;
  for (int step = 0; step < 60; ++step) (meets((near + far) / 2) ? near : far) = (near + far) / 2;
  for (const double by : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2}) {
    expect_agreement(box, move(other, near + by), tally);
    expect_agreement(box, move(other, near - by), tally);
  }
}

template <Dim N>
void check_everything() {
  Maker<N> make(seed);
  const auto along = [](Vec<N, double> way) {
    return [way](const auto& shape, double t) {
      auto moved = shape;
      if constexpr (requires { moved.center; }) {
        moved.center += way * t;
      } else {
        moved.start += way * t;
        moved.end += way * t;
      }
      return moved;
    };
  };
  Tally uniform;
  Tally border;
  for (int i = 0; i < 2000; ++i) {
    const Obb<N, double> a = make.obb();
    const Aabb<N, double> b = make.aabb();
    const Obb<N, double> obb = make.obb();
    const Segment<N, double> segment = make.segment();
    expect_agreement(a, obb, uniform);
    expect_agreement(b, obb, uniform);
    expect_agreement(a, segment, uniform);
    expect_agreement(b, segment, uniform);
    Vec<N, double> way = make.vector(1);
    way /= std::sqrt(length_squared(way));
    expect_agreement_at_border(a, obb, along(way), border);
    expect_agreement_at_border(b, obb, along(way), border);
    expect_agreement_at_border(a, segment, along(way), border);
    expect_agreement_at_border(b, segment, along(way), border);
  }
  EXPECT_GT(uniform.answers, uniform.cases * 95 / 100) << "the filter leaves too many undecided";
  EXPECT_GT(border.cases, 20000);
  EXPECT_LT(border.answers, border.cases) << "the filter must not decide touching shapes";
}

TEST(BoxFilter, AgreesWithTheCarefulFormWheneverItAnswersIn2D) { check_everything<2>(); }
TEST(BoxFilter, AgreesWithTheCarefulFormWheneverItAnswersIn3D) { check_everything<3>(); }

Obb<3, float> in_float(const Obb<3, double>& box) {
  return {Vec<3, float>(box.center), Vec<3, float>(box.half_extents), Mat<3, float>(box.axes)};
}
Aabb<3, float> in_float(const Aabb<3, double>& box) { return {Vec<3, float>(box.min), Vec<3, float>(box.max)}; }
Segment<3, float> in_float(const Segment<3, double>& segment) {
  return {Vec<3, float>(segment.start), Vec<3, float>(segment.end)};
}

TEST(BoxFilter, AgreesWithTheCarefulFormWheneverItAnswersInFloat) {
  Maker<3> make(seed);
  Tally tally;
  for (int i = 0; i < 10000; ++i) {
    const Obb<3, float> a = in_float(make.obb());
    const Aabb<3, float> b = in_float(make.aabb());
    const Obb<3, float> obb = in_float(make.obb());
    const Segment<3, float> segment = in_float(make.segment());
    expect_agreement(a, obb, tally);
    expect_agreement(b, obb, tally);
    expect_agreement(a, segment, tally);
    expect_agreement(b, segment, tally);
  }
  EXPECT_GT(tally.answers, tally.cases * 95 / 100);
}

TEST(BoxFilter, DoesNotAnswerForBoxesThatTouch) {
  const Obb<3, double> a{{0, 0, 0}, {1, 1, 1}, Mat<3, double>(1.0)};
  const Obb<3, double> b{{2, 0.5, 0.5}, {1, 1, 1}, Mat<3, double>(1.0)};
  EXPECT_FALSE(detail::filter_of_box(a, b));
}

TEST(BoxFilter, SettlesParallelBoxesWhoseEdgesSpanNoAxis) {
  const Obb<3, double> a{{0, 0, 0}, {1, 1, 1}, Mat<3, double>(1.0)};
  const Obb<3, double> inside{{1, 1, 1}, {1, 1, 1}, Mat<3, double>(1.0)};
  const Obb<3, double> beside{{2.5, 1, 1}, {1, 1, 1}, Mat<3, double>(1.0)};
  EXPECT_EQ(detail::filter_of_box(a, inside), Relation::overlapping);
  EXPECT_EQ(detail::filter_of_box(a, beside), Relation::apart);
}

TEST(BoxFilter, HasNoAnswerWhereFloatsUnderflowOrOverflow) {
  for (const float size : {1e-44F, 1e-30F, 1e30F, 3e38F}) {
    const Obb<3, float> a{Vec<3, float>(0.0F), Vec<3, float>(size), Mat<3, float>(1.0F)};
    const Obb<3, float> b{Vec<3, float>(size), Vec<3, float>(size), Mat<3, float>(1.0F)};
    EXPECT_NE(detail::filter_of_box(a, b), Relation::apart) << size;
    const Segment<3, float> through{Vec<3, float>(-size), Vec<3, float>(size)};
    EXPECT_NE(detail::filter_of_box(a, through), Relation::apart) << size;
    const Segment<3, float> beside{{size, -size, size}, {size, -size, size}};
    EXPECT_NE(detail::filter_of_box(a, beside), Relation::overlapping) << size;
  }
}

TEST(BoxFilter, OfABallAgreesWithTheCarefulDistance) {
  Maker<3> make(seed);
  for (int i = 0; i < 20000; ++i) {
    const Obb<3, double> box = make.obb();
    const Vec<3, double> center = make.vector(3);
    const double reach = make.number(0, 1.5);
    const auto quick = detail::filter_of_sphere(center, box, reach);
    if (!quick) continue;
    const double distance = std::sqrt(distance_squared(center, box));
    if (distance > 0) {
      EXPECT_EQ(*quick, distance > reach ? Relation::apart : Relation::overlapping) << "case " << i;
    } else {
      EXPECT_EQ(*quick, Relation::overlapping) << "case " << i;
    }
  }
}

TEST(BoxFilter, OfAWidenedSegmentAgreesWithTheCarefulDistance) {
  Maker<3> make(seed);
  int answers = 0;
  for (int i = 0; i < 20000; ++i) {
    const Obb<3, double> box = make.obb();
    const Segment<3, double> segment = make.segment();
    const double reach = make.number(0, 1);
    const auto quick = detail::filter_of_widened(box, segment, reach);
    if (!quick) continue;
    ++answers;
    const double distance = std::sqrt(distance_squared(segment, box));
    EXPECT_EQ(*quick, distance > reach ? Relation::apart : Relation::overlapping) << "case " << i;
  }
  EXPECT_GT(answers, 18000);
}

TEST(BoxFilter, CallsNothingOverlappingThatHoldsNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Obb<3, double> whole;
  const Segment<3, double> segment{{-3, 0, 0}, {3, 0, 0}};
  for (int field = 0; field < 15; ++field) {
    Obb<3, double> box;
    if (field < 3) box.center[field] = nan;
    if (field >= 3 && field < 6) box.half_extents[field - 3] = nan;
    if (field >= 6) box.axes[(field - 6) / 3][(field - 6) % 3] = nan;
    EXPECT_NE(detail::filter_of_box(box, whole), Relation::overlapping) << field;
    EXPECT_NE(detail::filter_of_box(whole, box), Relation::overlapping) << field;
    EXPECT_NE(detail::filter_of_box(box, segment), Relation::overlapping) << field;
    EXPECT_NE(detail::filter_of_sphere(Vec<3, double>(0.0), box, 1), Relation::overlapping) << field;
    EXPECT_NE(detail::filter_of_widened(box, segment, 1), Relation::overlapping) << field;
  }
}

}  // namespace
}  // namespace graze::box_filter_test
