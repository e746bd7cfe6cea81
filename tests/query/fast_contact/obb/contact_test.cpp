// SPDX-License-Identifier: MIT
// The fast contact of two 3D oriented boxes against the general method for boxes.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>
#include <graze/query/manifold.hpp>

#include "catalogue.hpp"

#ifdef GRAZE_HAS_LANES

namespace graze::detail::obb_touch_test {
namespace {

using V3 = Vec<3, double>;
using Box = Obb<3, double>;

const Mat<3, double> tilt = rotation_matrix(V3(1, 2, 3), 50);

TEST(LookingFace, IsTheOneThatSideAlongChooses) {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Box, Box>();
    for (Dim i = 0; i < 3; ++i) {
      const BoxSide<3> side = side_along<3>(face_normals(a.axes), b.axes[i]);
      const BoxFaceNumbers face = facing_face(paired_box(a, V3(0.0)), PairedVec(b.axes[i]));
      RC_ASSERT(face.axis == side.axis);
      RC_ASSERT(face.is_far == side.is_far);
    }
  });
}

TEST(FaceAlong, LooksStraightUpToTheToleranceOfManifolds) {
  const PairedBox box = paired_box(Box{{0, 0, 0}, {1, 1, 1}, tilt}, V3(0.0));
  const V3 straight = -tilt[1];
  const ReferenceFace face = face_along(box, PairedVec(straight), true);
  ASSERT_TRUE(face.is_any);
  EXPECT_EQ(face.numbers.face(), 2U);
  EXPECT_TRUE(face.is_of_b);
  const V3 turned = straight + tilt[0] * 1e-4;
  EXPECT_FALSE(face_along(box, PairedVec(turned / length(turned)), true).is_any);
}

TEST(QuickPairOnEdges, IsWhereTheyCross) {
  const Box below{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 45)};
  const Box above{{0, 0, 2.5}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)};
  const CrossingEdges edges = crossing_of_edges(MeetingObbs(ObbsInFrame(below, above), all_boxes_axes<3>));
  ASSERT_TRUE(edges.is_known);
  EXPECT_NEAR(length(plain(edges.points.point_a) - V3(0, 0, std::sqrt(2.0))), 0, 1e-15);
  EXPECT_NEAR(length(plain(edges.points.point_b) - V3(0, 0, 2.5 - std::sqrt(2.0))), 0, 1e-15);
  EXPECT_EQ(edges.points.feature_a.kind, FeatureKind::edge);
  const Box beside{{0, 1, 2.5}, {1, 1, 1}, above.axes};  // at the end of the lower edge
  EXPECT_FALSE(crossing_of_edges(MeetingObbs(ObbsInFrame(below, beside), 1U << (6U + 3 * 1 + 0))).is_known);
}

TEST(CornerOverFace, IsTheDeepestOneIfItIsOverTheFace) {
  const Box table{{0, 0, -1}, {4, 4, 1}};
  const auto tilted = [](double x) { return Box{{x, 0, 1.5}, {1, 1, 1}, rotation_matrix(V3(1, 1, 0), 40)}; };
  constexpr BoxesAxes upward = 1U << 2U;
  const CornerOverFace over = corner_over_face(MeetingObbs(ObbsInFrame(table, tilted(0)), upward));
  ASSERT_TRUE(over.is_any);
  V3 lowest(0.0);
  for (const V3& corner : corner_points(tilted(0))) {
    if (corner.z < lowest.z) lowest = corner;
  }
  lowest.z += 1;  // seen from the table's center
  EXPECT_NEAR(length(plain(over.corner) - lowest), 0, 1e-14);
  EXPECT_NEAR(length(plain(over.on_face) - V3(lowest.x, lowest.y, 1)), 0, 1e-14);
  EXPECT_FALSE(corner_over_face(MeetingObbs(ObbsInFrame(table, tilted(4.5)), upward)).is_any);
  const CornerOverFace below = corner_over_face(MeetingObbs(ObbsInFrame(tilted(0), table), upward << 3U));
  ASSERT_TRUE(below.is_any);
  EXPECT_NEAR(length(plain(below.corner) + V3(0, 0, 1.5) - (lowest - V3(0, 0, 1))), 0, 1e-14);
}

// Bit-identical.
void expect_what_the_search_finds(const Box& a, const Box& b, BoxesAxes axes) {
  const BoxSides<3> sides_a = sides_of(relative_to(a.center, a));
  const BoxSides<3> sides_b = sides_of(relative_to(a.center, b));
  const BoxesContact<3> plain = contact_of_sides(sides_a, sides_b, axes);
  const BoxesContact<3> quick = MeetingObbs(ObbsInFrame(a, b), axes).contact();
  RC_ASSERT(quick.size == plain.size);
  RC_ASSERT(quick.found.normal == plain.found.normal);
  RC_ASSERT(quick.found.depth == plain.found.depth);
  RC_ASSERT(quick.found.error == plain.found.error);
  RC_ASSERT(quick.axis.edges == plain.axis.edges);
  RC_ASSERT(quick.axis.edges || (quick.axis.is_of_b == plain.axis.is_of_b && quick.axis.face == plain.axis.face));
}

TEST(MeetingObbs, OfOneAxisAreWhatTheSearchFindsOnIt) {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Box, Box>();
    for (unsigned place = 0; place < 15; ++place) expect_what_the_search_finds(a, b, 1U << place);
  });
}

TEST(MeetingObbs, OfSeveralAxesAreWhatTheSearchFindsOnThem) {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Box, Box>();
    const auto some = static_cast<BoxesAxes>(*test::choice(all_boxes_axes<3>)) + 1;
    for (const BoxesAxes axes : {all_boxes_axes<3>, some}) {
      expect_what_the_search_finds(a, b, axes);
      expect_what_the_search_finds(a, Box{b.center, b.half_extents, a.axes}, axes);
    }
  });
}

// ---- Pairs of every kind

Mat<3, double> any_rotation() {
  const auto part = [] { return static_cast<double>(*test::choice(2001)) / 1000 - 1; };
  const V3 axis(part(), part(), part());
  return rotation_matrix(length(axis) > 0.1 ? axis : V3(1, 0, 0), 180 * part());
}

enum class Kind { any, stacked, tilted, edges, concentric, flat, far };

/// Two boxes, the first of at most about size 1.
std::pair<Box, Box> draw(Kind kind) {
  const auto share = [] { return static_cast<double>(*test::choice(1001)) / 1000; };
  const auto half = [&] { return V3(0.1 + share(), 0.1 + share(), 0.1 + share()); };
  const Mat<3, double> whole = any_rotation();
  const V3 place = V3(share(), share(), share()) * (kind == Kind::far ? 1e6 : 1.0);
  Box a{place, half(), whole};
  Box b{place, half(), whole};
  if (kind == Kind::flat) a.half_extents[static_cast<Dim>(*test::choice(3))] = 0;
  if (kind == Kind::concentric) {
    b.axes = any_rotation();
  } else if (kind == Kind::any || kind == Kind::flat) {
    b.axes = any_rotation();
    b.center += (V3(share(), share(), share()) - 0.5) * 2.0;
  } else if (kind == Kind::edges) {
    a.axes = whole * rotation_matrix(V3(1, 0, 0), 45);
    b.axes = whole * rotation_matrix(V3(0, 1, 0), 45);
    b.center += whole[2] * (0.7 * (a.half_extents.y + a.half_extents.z) + 0.6 * (b.half_extents.x + b.half_extents.z));
  } else {
    const double turn = kind == Kind::tilted ? 1e-4 * share() : 0;
    b.axes = whole * rotation_matrix(V3(1, share(), 0), turn) * rotation_matrix(V3(0, 0, 1), 360 * share());
    b.center += whole * V3(share() - 0.5, share() - 0.5, a.half_extents.z + b.half_extents.z - 0.01);
  }
  return *test::choice(2) == 0 ? std::pair{a, b} : std::pair{b, a};
}

template <class T>
Obb<3, T> in_type(const Box& box) {
  return {Vec<3, T>(box.center), Vec<3, T>(box.half_extents), Mat<3, T>(box.axes)};
}

/// Points may be off by the tilt of faces that are taken to be flush; if they are clipped at such a small angle, by
/// more.
template <class T>
double allowed_off(const Obb<3, T>& a, const Obb<3, T>& b, double error) {
  const auto coordinate = static_cast<double>(std::max(max_abs(a.center), max_abs(b.center)));
  const auto size = static_cast<double>(max_abs(a.half_extents) + max_abs(b.half_extents));
  return 8 * error + 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * (coordinate + size);
}

/// A corner of a face above a face, in the form of SpanningChoice, for the two boxes in the order of their contact.
struct Corner {
  V3 point_a;
  V3 point_b;
  double depth;
  ContactId id;
};

/// By the fast method, in its order. None if it leaves them to the general one, or if no face is the reference face.
std::vector<Corner> quick_corners(const MeetingObbs& met, const ReferenceFace& face) {
  std::vector<Corner> corners;
  if (!face.is_any) return corners;
  FaceOverFace over = face_over(met, face, tolerance::aligned);
  if (!over.run()) return corners;
  for (unsigned rest = over.left(); rest != 0; rest &= rest - 1) {
    PairedPoints pair = over.pair(static_cast<std::size_t>(std::countr_zero(rest)));
    if (face.is_of_b) {
      std::swap(pair.point_a, pair.point_b);
      std::swap(pair.feature_a, pair.feature_b);
    }
    corners.push_back({plain(pair.point_a), plain(pair.point_b), pair.depth, {pair.feature_a, pair.feature_b, 0, 0}});
  }
  return corners;
}

/// The same corners by the general method, in the order of the fast one, which lists each once.
std::vector<Corner> corners_in_order(const SurfacePairs<3>& pairs, const std::vector<Corner>& order) {
  std::vector<Corner> corners;
  for (const Corner& other : order) {
    for (const SurfacePair<3>& pair : pairs) {
      const ContactId id{pair.feature_a, pair.feature_b, 0, 0};
      if (id == other.id) corners.push_back({pair.point_a, pair.point_b, pair.depth, id});
    }
  }
  return corners;
}

/// The ids of all, or of four if there are more.
std::vector<ContactId> chosen_ids(const std::vector<Corner>& corners, const V3& normal) {
  std::vector<std::size_t> places;
  if (corners.size() > Manifold<3>::most_points) {
    for (const std::size_t place : SpanningChoice(corners, normal).run()) places.push_back(place);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  } else {
    for (std::size_t i = 0; i < corners.size(); ++i) places.push_back(i);
  }
  std::vector<ContactId> ids;
  for (const std::size_t place : places) ids.push_back(corners[place].id);
  return ids;
}

/// The fast method has all corners of the general one, and its choice is the same up to ties. It need not follow the
/// other's order of corners, nor its preference among equally good ones.
template <class T>
void expect_the_same_manifold(Kind kind) {
  test::check_property([kind] {
    const auto [wide_a, wide_b] = draw(kind);
    const auto first = in_type<T>(wide_a);
    const auto second = in_type<T>(wide_b);
    const bool turned = !is_in_order(first, second);
    const auto& a = turned ? second : first;
    const auto& b = turned ? first : second;
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const Manifold<3, T> quick = manifold(a, b);
    const bool is_apart = decide(a, b) == Relation::apart;
    RC_ASSERT((quick.size == 0) == is_apart);
    RC_PRE(!is_apart);
    const auto plain = rounded_manifold<T>(manifold_of_met(a, b));
    RC_ASSERT(quick.normal == plain.normal);
    RC_ASSERT(quick.error == plain.error);
    const MeetingObbs met(ObbsInFrame(a, b), axes_of(a, b).candidates);
    const std::vector<Corner> found = quick_corners(met, reference_face(met));
    const double allowed = allowed_off(a, b, plain.error);
    if (found.empty()) {
      RC_ASSERT(quick.size == plain.size);
      for (std::size_t i = 0; i < plain.size; ++i) {
        RC_ASSERT(quick.points[i].id == plain.points[i].id);
        RC_ASSERT(static_cast<double>(max_abs(quick.points[i].point_a - plain.points[i].point_a)) <= allowed);
        RC_ASSERT(static_cast<double>(max_abs(quick.points[i].point_b - plain.points[i].point_b)) <= allowed);
        RC_ASSERT(std::fabs(static_cast<double>(quick.points[i].depth - plain.points[i].depth)) <= allowed);
      }
      return;
    }
    const V3 origin = reference(a);
    const SurfacePairs<3> pairs = pairs_of_boxes(relative_to(origin, a), relative_to(origin, b), met.contact());
    RC_ASSERT(found.size() == pairs.size());
    const std::vector<Corner> expected = corners_in_order(pairs, found);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(max_abs(found[i].point_a - expected[i].point_a) <= allowed);
      RC_ASSERT(max_abs(found[i].point_b - expected[i].point_b) <= allowed);
      RC_ASSERT(std::fabs(found[i].depth - expected[i].depth) <= allowed);
    }
    const std::vector<ContactId> ids = chosen_ids(expected, detail::plain(met.normal));
    RC_ASSERT(quick.size == ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) RC_ASSERT(quick.points[i].id == ids[i]);
  });
}

/// Bit-identical depth and normal. Of points that are equally deep either may be chosen, so the point need only be as
/// deep as the contact.
template <class T>
void expect_the_same_contact(Kind kind) {
  test::check_property([kind] {
    const auto [wide_a, wide_b] = draw(kind);
    const auto a = in_type<T>(wide_a);
    const auto b = in_type<T>(wide_b);
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    const auto quick = contact(a, b);
    const bool is_apart = decide(a, b) == Relation::apart;
    RC_ASSERT(quick.has_value() == !is_apart);
    RC_PRE(!is_apart);
    const auto plain = *rounded_contact<T>(penetration_of_met(a, b));
    RC_ASSERT(quick->normal == plain.normal);
    RC_ASSERT(quick->depth == plain.depth);
    RC_ASSERT(quick->error == plain.error);
    const auto rest = (quick->point_a - quick->point_b) - quick->normal * quick->depth;
    RC_ASSERT(static_cast<double>(max_abs(rest)) <= allowed_off(a, b, plain.error));
  });
}

TEST(QuickManifold, IsThatOfAllBoxes) {
  for (const Kind kind :
       {Kind::any, Kind::stacked, Kind::tilted, Kind::edges, Kind::concentric, Kind::flat, Kind::far}) {
    expect_the_same_manifold<double>(kind);
    expect_the_same_manifold<float>(kind);
  }
}

TEST(QuickContact, IsThatOfAllBoxes) {
  for (const Kind kind :
       {Kind::any, Kind::stacked, Kind::tilted, Kind::edges, Kind::concentric, Kind::flat, Kind::far}) {
    expect_the_same_contact<double>(kind);
    expect_the_same_contact<float>(kind);
  }
}

}  // namespace
}  // namespace graze::detail::obb_touch_test

#endif
