// SPDX-License-Identifier: MIT
// The judges of contacts and rays themselves: the oracle's ray entries and moved shapes, by hand; and that slightly
// wrong answers are detected.
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exact/parting.hpp"
#include "exact/ray_entry.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/ray_casts.hpp"
#include "query/ray_judgement.hpp"

namespace graze::test::judgement_test {
namespace {

using Any3 = AnyShape<3, double>;
using Point3 = Vec<3, double>;
using Ray3 = Ray<3, double>;

struct EntryRow {
  Any3 shape;
  Ray3 ray;
  std::optional<double> entry;
};

TEST(ExactEntry, IsWhatOneFindsByHand) {
  const Ray3 along_x{{-4, 0, 0}, {2, 0, 0}};
  const Triangle<3, double> triangle{{1, -1, -1}, {1, 3, -1}, {1, -1, 3}};
  const std::vector<EntryRow> rows = {
      {Point3(2, 0, 0), along_x, 3},
      {Point3(2, 1e-300, 0), along_x, std::nullopt},
      {Point3(-5, 0, 0), along_x, std::nullopt},
      {Segment<3, double>{{0, -1, 0}, {1, 1, 0}}, along_x, 2.25},
      {Segment<3, double>{{1, 0, 0}, {0, 0, 0}}, along_x, 2},
      {Ray3{{2, -3, 0}, {-1, 1, 0}}, along_x, 1.5},
      {Ray3{{2, -3, 0}, {1, -1, 0}}, along_x, std::nullopt},
      {Sphere<3, double>{{1, 0, 0}, 1}, along_x, 2},
      {Sphere<3, double>{{1, 1, 0}, 1}, along_x, 2.5},
      {Sphere<3, double>{{1, 1, 0}, 0.999}, along_x, std::nullopt},
      {Sphere<3, double>{{-3, 0, 0}, 2}, along_x, 0},
      {Aabb<3, double>{{0, -1, 0}, {2, 1, 0}}, along_x, 2},
      {Aabb<3, double>{{0, -1, -1}, {2, 1, 1}}, {{-1, -2, 0}, {1, 1, 0}}, 1},
      {Obb<3, double>{{0, 0, 0}, {1, 2, 3}}, {{4, 0, 0}, {-1, 0, 0}}, 3},
      {triangle, along_x, 2.5},
      {Triangle<3, double>{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, along_x, 2.5},
      {Triangle<3, double>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, along_x, 2},
      {Plane<3, double>{{1, 0, 0}, 3}, along_x, 3.5},
      {Plane<3, double>{{1, 0, 0}, -5}, along_x, std::nullopt},
      {HalfSpace<3, double>{{-1, 0, 0}, -3}, along_x, 3.5},
      {Capsule<3, double>{{2, -1, 0}, {2, 1, 0}, 1}, along_x, 2.5},
      {Capsule<3, double>{{0, 0, 0}, {2, 0, 0}, 1}, along_x, 1.5},
      {Capsule<3, double>{{2, 1, 0}, {2, 5, 0}, 1}, along_x, 3},
      {compound_of<3, double>({Point3(2, 0, 0), Sphere<3, double>{{1, 0, 0}, 1}}), along_x, 2},
  };
  for (const EntryRow& row : rows) {
    EXPECT_EQ((exact_entry<3, double>(row.shape, row.ray)), row.entry) << to_source<3, double>(row.shape);
  }
}

TEST(ExactEntry, OfAPolytopeIsThatOfTheSameBox) {
  const Aabb<3, double> box{{-1, -2, -3}, {1, 2, 3}};
  std::vector<Point3> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.emplace_back((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 2 : -2, (i & 4U) != 0 ? 3 : -3);
  const Ray3 ray{{5, 1, 7}, {-1, -0.25, -1.5}};
  const auto entry = exact_entry<3, double>(Any3(convex_hull<3, double>(corners)), ray);
  ASSERT_TRUE(entry.has_value());
  EXPECT_EQ(entry, (exact_entry<3, double>(Any3(box), ray)));
  EXPECT_EQ(*entry, 4);
}

TEST(OverlapAfter, TakesTheWayThatTheShapeGoes) {
  const Any3 a = Aabb<3, double>{{-1, -1, -1}, {1, 1, 1}};
  const Any3 b = Aabb<3, double>{{0.5, -3, -3}, {4, 3, 3}};
  const Solid<3> in_a = *bounded_solid<3, double>(a);
  const Solid<3> in_b = *bounded_solid<3, double>(b);
  EXPECT_EQ(overlap_along<3>(in_a, in_b, {2, 0, 0}), 0.5);
  EXPECT_EQ(overlap_along<3>(in_a, in_b, {0, 1, 0}), 4);
  EXPECT_EQ((overlap_after<3, double>(a, b, {0.5, 0, 0}, 0)), 0);
  EXPECT_EQ((overlap_after<3, double>(a, b, {0.25, 0, 0}, 0)), 0.25);
  EXPECT_EQ((overlap_after<3, double>(a, b, {-0.25, 0, 0}, 0)), 0.75);
  EXPECT_EQ((overlap_after<3, double>(a, b, {0, 4, 0}, 0)), 0);
  // A sphere that moves obliquely is free of a corner before its plane is perpendicular to the direction.
  const Any3 sphere = Sphere<3, double>{{0.5, 0, 0}, 1};
  EXPECT_EQ((overlap_after<3, double>(Any3(Point3(0, 0, 0)), sphere, {0.5, 0, 0}, 0)), 0);
  EXPECT_EQ((overlap_after<3, double>(Any3(Point3(0, 0, 0)), sphere, {0, 1, 0}, 0)), 0);
  EXPECT_FALSE((overlap_after<3, double>(a, Any3(Plane<3, double>{{1, 0, 0}, 0}), {1, 0, 0}, 0)).has_value());
}

TEST(ContactJudgement, FindsOutADepthANormalAndAnAnswerThatAreWrong) {
  const Any3 a = Obb<3, double>{{0, 0, 0}, {1, 1, 1}};
  const Any3 b = Sphere<3, double>{{1.5, 0.25, 0}, 1};
  const ExactVerdict truth = exact_verdict<3, double>(a, b);
  const auto right = contact_of<3, double>(a, b);
  ASSERT_TRUE(right.has_value());
  const auto judged = [&](const std::optional<Contact<3, double>>& found) {
    return contact_errors<3, double>(a, b, truth, found).judgement;
  };
  EXPECT_EQ(judged(right), Judgement::right);
  EXPECT_EQ(judged(std::nullopt), Judgement::wrong);
  auto found = *right;
  found.depth += 1e-13;
  EXPECT_EQ(judged(found), Judgement::wrong);
  found = *right;
  found.normal = {0, 1, 0};
  EXPECT_EQ(judged(found), Judgement::wrong);
  found.normal = -right->normal;
  EXPECT_EQ(judged(found), Judgement::wrong);
  found.normal = right->normal * 1.0001;
  EXPECT_EQ(judged(found), Judgement::wrong);
}

TEST(RayJudgement, FindsOutAnExitAMissAndAPlaceThatAreWrong) {
  const Any3 box = Obb<3, double>{{0, 0, 0}, {1, 1, 1}};
  const Ray3 ray{{-4, 0.25, 0.5}, {1, 0, 0}};
  const ExactVerdict truth = exact_verdict<3, double>(box, Any3(ray));
  const auto right = hit_of<3, double>(box, ray, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(right.has_value());
  const auto judged = [&](const std::optional<RayHit<3, double>>& hit) {
    return ray_errors<3, double>(box, ray, truth, 4, hit).judgement;
  };
  const auto at = [&](double t) {
    auto hit = *right;
    hit.t = t;
    hit.point = ray.origin + ray.direction * t;
    return hit;
  };
  EXPECT_EQ(judged(right), Judgement::right);
  EXPECT_EQ(judged(at(3)), Judgement::right);
  EXPECT_EQ(judged(std::nullopt), Judgement::wrong);
  EXPECT_EQ(judged(at(5)), Judgement::wrong) << "the exit";
  EXPECT_EQ(judged(at(3 + 1e-13)), Judgement::wrong);
  EXPECT_EQ(judged(at(3 - 1e-13)), Judgement::wrong);
  auto beside = at(3);
  beside.point.y += 1e-13;
  EXPECT_EQ(judged(beside), Judgement::wrong);
}

TEST(RayJudgement, HoldsTheErrorOfAHitToTheGapWhereTheRayOnlyNearlyTouches) {
  const Any3 sphere = Sphere<3, double>{{0, 0, 0}, 3};
  const Ray3 ray{{-8, 3 + 7e-15, 0}, {2, 0, 0}};
  const ExactVerdict truth = exact_verdict<3, double>(sphere, Any3(ray));
  ASSERT_EQ(truth.relation, Relation::apart);
  const auto right = hit_of<3, double>(sphere, ray, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(right.has_value());
  const auto judged = [&](const RayHit<3, double>& hit) {
    return ray_errors<3, double>(sphere, ray, truth, 8, hit).judgement;
  };
  EXPECT_EQ(judged(*right), Judgement::within_band);
  auto beyond = *right;
  beyond.t = 16;
  beyond.point = ray.origin + ray.direction * beyond.t;
  EXPECT_EQ(judged(beyond), Judgement::wrong);
  auto above = *right;
  above.point.y += 1e-12;
  EXPECT_EQ(judged(above), Judgement::wrong);
}

}  // namespace
}  // namespace graze::test::judgement_test
