// SPDX-License-Identifier: MIT
// The fast contact of 2D spheres, capsules and boxes against the general method.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/fast_contact/boxes_2d.hpp>
#include <graze/query/fast_contact/sphere_2d.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

namespace graze::detail::flat_touch_test {
namespace {

using V2 = Vec<2, double>;
template <class T>
using Ball = Sphere<2, T>;
template <class T>
using Capsule3 = Capsule<2, T>;
template <class T>
using Box = Aabb<2, T>;
template <class T>
using Turned = Obb<2, T>;

constexpr Feature vertex(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature flat_side(std::uint32_t i) { return {FeatureKind::edge, i}; }

/// The fast contact of an overlapping pair, and its part of a manifold.
struct Seen {
  Penetration<2> found;
  std::array<SurfacePair<2>, 2> points{};
  std::size_t size = 0;

  explicit Seen(const auto& look) : found(look.found) { size = look.put_points(points.data()); }
};

TEST(SphereContact2d, IsAtTheLowestPoint) {
  const Box<double> box{{0, 0}, {4, 2}};
  const FastContact<2> on_top = find_fast_contact(Ball<double>{{1, 2.5}, 1}, box, false);
  ASSERT_TRUE(on_top.is_known && on_top.meets && on_top.is_single);
  EXPECT_EQ(on_top.found.normal, V2(0, -1));
  EXPECT_NEAR(on_top.found.depth, 0.5, on_top.found.error);
  EXPECT_EQ(on_top.feature_a, vertex(0));
  EXPECT_EQ(on_top.feature_b, flat_side(3));
  const FastContact<2> at_corner = find_fast_contact(Ball<double>{{7, 6}, 6}, box, true);
  ASSERT_TRUE(at_corner.is_known && at_corner.meets);
  EXPECT_NEAR(at_corner.found.depth, 1, at_corner.found.error);
  EXPECT_NEAR(length(at_corner.found.normal - V2(0.6, 0.8)), 0, 1e-15);
  EXPECT_EQ(at_corner.feature_a, vertex(3));
  const FastContact<2> inside = find_fast_contact(Ball<double>{{1, 1.75}, 0.5}, box, false);
  ASSERT_TRUE(inside.is_known && inside.meets);
  EXPECT_NEAR(inside.found.depth, 0.75, inside.found.error);
}

TEST(Contact2d, OfTwoBoxesIsWhatTheirSidesShare) {
  const Turned<double> below{{0, 0}, {2, 1}, Mat<2, double>(1.0)};
  const Turned<double> above{{1.5, 1.9}, {1, 1}, Mat<2, double>(1.0)};
  const FastContact2d look = find_fast_contact(below, above, false);
  ASSERT_TRUE(look.is_known && look.meets);
  EXPECT_EQ(look.found.normal, V2(0, 1));
  ASSERT_EQ(look.size, 2U);
  EXPECT_NEAR(length(look.points[0].point_b - V2(0.5, 0.9)), 0, 1e-15);
  EXPECT_EQ(look.points[0].feature_a, flat_side(3));
  EXPECT_EQ(look.points[0].feature_b, vertex(0));
  EXPECT_NEAR(length(look.points[1].point_b - V2(2, 0.9)), 0, 1e-15);
  EXPECT_EQ(look.points[1].feature_a, vertex(3));
  EXPECT_EQ(look.points[1].feature_b, flat_side(2));
}

TEST(Contact2d, OfTwoRodsSideBySideIsWhatTheyShare) {
  const Capsule3<double> below{{0, 0}, {4, 0}, 1};
  const Capsule3<double> above{{5, 1.5}, {1, 1.5}, 1};
  const FastContact2d look = find_fast_contact(below, above, false);
  ASSERT_TRUE(look.is_known && look.meets);
  EXPECT_NEAR(look.found.depth, 0.5, look.found.error);
  ASSERT_EQ(look.size, 2U);
  EXPECT_NEAR(length(look.points[0].point_b - V2(4, 0.5)), 0, 1e-14);
  EXPECT_EQ(look.points[0].feature_a, vertex(1));
  EXPECT_EQ(look.points[0].feature_b, flat_side(0));
  EXPECT_EQ(look.points[1].feature_a, flat_side(0));
  EXPECT_EQ(look.points[1].feature_b, vertex(1));
}

TEST(SphereContact2d, IsApartWhereThatIsPlainAndNotKnownWhereItIsNot) {
  const Box<double> box{{0, 0}, {4, 2}};
  const auto look = [&box](const Ball<double>& sphere) { return find_fast_contact(sphere, box, false); };
  EXPECT_TRUE(look({{1, 4}, 1}).is_known);
  EXPECT_FALSE(look({{1, 4}, 1}).meets);
  EXPECT_TRUE(look({{7, 6}, 4.5}).is_known) << "beyond a corner";
  EXPECT_FALSE(look({{7, 6}, 4.5}).meets);
  EXPECT_FALSE(look({{1, 3}, 1}).is_known) << "touches";
  EXPECT_FALSE(look({{4, 2.5}, 1}).is_known) << "above a corner";
  EXPECT_FALSE(look({{4, 2}, 1}).is_known) << "at a corner";
  EXPECT_FALSE(look({{1, std::nan("")}, 1}).is_known);
  EXPECT_FALSE(find_fast_contact(Ball<double>{{1, 2}, 1}, Box<double>{{0, 1}, {4, 1}}, false).is_known) << "a flat box";
}

// ---- Against the general method

enum class Kind { any, grid, level, far, orthonormality_error };

class Drawer {
 public:
  explicit Drawer(Kind kind) : kind_(kind) {}

  void draw(Ball<double>& sphere) const { sphere = {place(0.6), 0.2 + 0.6 * share()}; }
  void draw(Capsule3<double>& capsule) const {
    const V2 start = place(0.6);
    const double angle = share() < 0.5 ? 0 : 1e-7 * (share() - 0.5);
    const V2 way = kind_ == Kind::level ? V2(1 + share(), angle) : (V2(share(), share()) - 0.5) * 2.0;
    capsule = {start, start + (kind_ == Kind::grid ? V2(1, 0) : way), 0.1 + 0.3 * share()};
  }
  void draw(Box<double>& box) const {
    const V2 center = place(0.6);
    const V2 half = half_extents();
    box = {center - half, center + half};
  }
  void draw(Turned<double>& box) const {
    const bool is_level = kind_ == Kind::grid || kind_ == Kind::level;
    Mat<2, double> axes = rotation_matrix(is_level ? 90.0 * static_cast<double>(*test::choice(4)) : 360 * share());
    if (kind_ == Kind::orthonormality_error) axes[0] += (V2(share(), share()) - 0.5) * 4e-5;
    box = {place(0.6), half_extents(), axes};
  }

 private:
  static double share() { return static_cast<double>(*test::choice(1001)) / 1000; }
  V2 half_extents() const { return kind_ == Kind::grid ? V2(0.5, 1) : V2(share(), share()) * 0.8 + 0.01; }
  V2 place(double size) const {
    const V2 drawn = (V2(share(), share()) - 0.5) * (2 * size);
    if (kind_ == Kind::grid) return V2(std::round(2 * drawn.x) / 2, std::round(2 * drawn.y) / 2);
    return kind_ == Kind::far ? drawn + V2(3e5, -7e5) : drawn;
  }

  Kind kind_;
};

template <class T>
Ball<T> as(const Ball<double>& s) {
  return {Vec<2, T>(s.center), static_cast<T>(s.radius)};
}
template <class T>
Capsule3<T> as(const Capsule3<double>& s) {
  return {Vec<2, T>(s.a), Vec<2, T>(s.b), static_cast<T>(s.radius)};
}
template <class T>
Box<T> as(const Box<double>& s) {
  return {Vec<2, T>(s.min), Vec<2, T>(s.max)};
}
template <class T>
Turned<T> as(const Turned<double>& s) {
  return {Vec<2, T>(s.center), Vec<2, T>(s.half_extents), Mat<2, T>(s.axes)};
}

/// If another normal is as good, only the depth is known. Far from zero the general method, which rounds its point
/// before it names it, may name a corner after its side. For boxes with skew axes it may choose another incident side,
/// among those that face the reference equally up to the skew.
template <class A, class B>
void expect_agreement(const A& a, const B& b, const Seen& look, Kind kind) {
  const WideManifold<2> plain = manifold_of_met(a, b);
  const double error = look.found.error + plain.found.error;
  RC_ASSERT(std::fabs(look.found.depth - plain.found.depth) <= error);
  RC_ASSERT(std::fabs(length(look.found.normal) - 1) <= 1e-15);
  if (max_abs(look.found.normal - plain.found.normal) > 1e-7) return;
  RC_ASSERT(look.size == plain.size);
  if (kind == Kind::far && look.size == 1) return;
  const double allowed =
      kind == Kind::orthonormality_error ? 1e-4 : 64 * error + 4 * tolerance::epsilon * max_abs(look.found.point_a);
  for (std::size_t i = 0; i < look.size; ++i) {
    const SurfacePair<2>& point = look.points[i];
    const auto* const end = plain.pairs.data() + plain.size;
    const auto* same = std::find_if(plain.pairs.data(), end, [&](const SurfacePair<2>& pair) {
      return pair.feature_a == point.feature_a && pair.feature_b == point.feature_b;
    });
    if (same == end && kind == Kind::orthonormality_error) return;
    RC_ASSERT(same != end);
    RC_ASSERT(std::fabs(same->depth - point.depth) <= allowed);
    RC_ASSERT(max_abs(point.point_a - point.point_b - look.found.normal * point.depth) <= allowed);
  }
  const V2 off = look.found.point_a - penetration_of_met(a, b).point_a;  // along a side, where several are as deep
  RC_ASSERT(max_abs(off) <= 1e-4 || std::fabs(dot(off, look.found.normal)) <= allowed);
  const double deepest = look.size == 2 ? std::max(look.points[0].depth, look.points[1].depth) : look.points[0].depth;
  RC_ASSERT(max_abs(look.found.point_a - look.found.point_b - look.found.normal * deepest) <= 1e-5);
}

template <class T, class A, class B>
void compare(Kind kind, int& cases, int& known) {
  test::check_property([&] {
    A drawn_a;
    B drawn_b;
    Drawer(kind).draw(drawn_a);
    Drawer(kind).draw(drawn_b);
    const auto a = as<T>(drawn_a);
    const auto b = as<T>(drawn_b);
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const auto look = find_fast_contact(a, b, false);
    const auto turned = find_fast_contact(a, b, true);
    ++cases;
    RC_ASSERT(look.is_known == turned.is_known);
    if (!look.is_known) return;
    ++known;
    RC_ASSERT(look.meets == turned.meets);
    RC_ASSERT(look.meets == (decide(a, b) != Relation::apart));
    if (!look.meets) return;
    const Seen seen(look);
    expect_agreement(a, b, seen, kind);
    RC_ASSERT(turned.found.normal == -look.found.normal);
    RC_ASSERT(turned.found.point_a == look.found.point_b);
    RC_ASSERT(Seen(turned).points[0].feature_a == seen.points[0].feature_b);
  });
}

template <class T>
void compare_all(Kind kind, double least_known) {
  int cases = 0;
  int known = 0;
  compare<T, Ball<double>, Box<double>>(kind, cases, known);
  compare<T, Ball<double>, Turned<double>>(kind, cases, known);
  compare<T, Capsule3<double>, Capsule3<double>>(kind, cases, known);
  compare<T, Box<double>, Capsule3<double>>(kind, cases, known);
  compare<T, Turned<double>, Capsule3<double>>(kind, cases, known);
  compare<T, Box<double>, Turned<double>>(kind, cases, known);
  compare<T, Turned<double>, Turned<double>>(kind, cases, known);
  // Small samples may have fewer: permits four standard deviations.
  const double deviation = std::sqrt(least_known * (1 - least_known) * cases);
  EXPECT_GE(known, least_known * cases - 4 * deviation);
}

TEST(Contact2d, IsThatOfAllShapes) {
  for (const auto& [kind, least_known] :
       {std::pair(Kind::any, 0.95), {Kind::level, 0.9}, {Kind::orthonormality_error, 0.9}}) {
    compare_all<float>(kind, least_known);
    compare_all<double>(kind, least_known);
  }
}

TEST(Contact2d, IsThatOfAllShapesWhereMuchIsInDoubt) {
  for (const Kind kind : {Kind::grid, Kind::far}) {
    compare_all<float>(kind, 0.2);
    compare_all<double>(kind, 0.2);
  }
}

}  // namespace
}  // namespace graze::detail::flat_touch_test
