// SPDX-License-Identifier: MIT
// The cases recorded by the exam: those on which graze once failed, and the hardest of every pair that passed.
#include "query/regressions.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exact/kinds.hpp"
#include "exact/ray_entry.hpp"
#include "exact/sweep.hpp"
#include "query/cast_judgement.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/distance_judgement.hpp"
#include "query/impact_judgement.hpp"
#include "query/manifold_judgement.hpp"
#include "query/mass_judgement.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/point_answers.hpp"
#include "query/point_judgement.hpp"
#include "query/ray_casts.hpp"
#include "query/ray_judgement.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::regressions_test {
namespace {

std::string root() {
  const char* folder = std::getenv("GRAZE_ROOT");
  return folder != nullptr ? folder : ".";
}

template <Dim N, class T>
void expect_right_relation(const Regression& row) {
  const AnyShape<N, T> a = shape_from<N, T>(row.a);
  const AnyShape<N, T> b = shape_from<N, T>(row.b);
  const Relation claim = relation_of<N, T>(a, b);
  EXPECT_EQ((relation_of<N, T>(b, a)), claim);
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  EXPECT_EQ(name_of(truth.relation), row.expected);
  EXPECT_NE(judge(claim, truth, a.index(), b.index()), Judgement::wrong) << "said " << name_of(claim);
}

template <Dim N, class T>
void expect_right_point(const Regression& row) {
  const AnyShape<N, T> any = shape_from<N, T>(row.a);
  const Vec<N, T> point = std::get<Vec<N, T>>(shape_from<N, T>(row.b));
  const PointAnswers<N, T> given = answers<N, T>(any, point);
  EXPECT_TRUE((answers<N, T>(any, given.closest).contained));
  EXPECT_TRUE((answers<N, T>(any, given.boundary).contained));
  detail::visit(
      [&](const auto& shape) {
        if constexpr (!has_parts<std::decay_t<decltype(shape)>>) {
          const PointErrors errors = point_errors(shape, point, given);
          EXPECT_EQ(number_text(errors.truth), row.expected);
          EXPECT_TRUE(errors.are_within_bounds<T>())
              << errors.forgiven << " (forgiven), " << errors.distance << " (distance), " << errors.closest
              << " (closest point), " << errors.boundary << " (boundary point), times as long as thick "
              << errors.slenderness;
        } else {
          ADD_FAILURE() << "compounds are tested by their parts";
        }
      },
      any);
}

template <Dim N, class T>
void expect_right_distance(const Regression& row) {
  const AnyShape<N, T> a = shape_from<N, T>(row.a);
  const AnyShape<N, T> b = shape_from<N, T>(row.b);
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  EXPECT_EQ(number_text(std::max(0.0, truth.gap)), row.expected);
  const DistanceErrors errors = distance_errors<N, T>(a, b, truth);
  EXPECT_NE(errors.judgement, Judgement::wrong)
      << errors.fault << ": " << errors.distance << " (distance), " << errors.points << " (points)";
}

template <Dim N, class T>
void expect_right_contact(const Regression& row) {
  const AnyShape<N, T> a = shape_from<N, T>(row.a);
  const AnyShape<N, T> b = shape_from<N, T>(row.b);
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  EXPECT_EQ(number_text(truth.gap), row.expected);
  const ContactErrors errors = contact_errors<N, T>(a, b, truth, contact_of<N, T>(a, b));
  EXPECT_NE(errors.judgement, Judgement::wrong) << errors.depth << " (depth), " << errors.left << " (left)";
}

template <Dim N, class T>
void expect_right_manifold(const Regression& row) {
  const AnyShape<N, T> a = shape_from<N, T>(row.a);
  const AnyShape<N, T> b = shape_from<N, T>(row.b);
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  EXPECT_EQ(number_text(truth.gap), row.expected);
  const ManifoldErrors errors = manifold_errors<N, T>(a, b, truth);
  EXPECT_NE(errors.judgement, Judgement::wrong)
      << errors.fault << ": " << errors.depth << " (depth), " << errors.points << " (points)";
}

template <Dim N, class T>
void expect_right_ray_cast(const Regression& row) {
  const AnyShape<N, T> shape = shape_from<N, T>(row.a);
  const Ray<N, T> ray = std::get<Ray<N, T>>(shape_from<N, T>(row.b));
  const std::optional<double> entry = exact_entry<N, T>(shape, ray);
  EXPECT_EQ(entry ? number_text(*entry) : "none", row.expected);
  const auto hit = hit_of<N, T>(shape, ray, std::numeric_limits<T>::infinity());
  const AnyShape<N, T> path(ray);
  const RayErrors errors =
      ray_errors<N, T>(shape, ray, exact_verdict<N, T>(shape, path), size_of<N, T>({shape, path}), hit);
  EXPECT_NE(errors.judgement, Judgement::wrong) << errors.entry << " (entry)";
}

template <Dim N, class T>
void expect_right_shape_cast(const Regression& row) {
  const Cast<N, T> cast = cast_from<N, T>(row);
  const std::optional<ExactPassage> passage = exact_passage<N, T>(cast.a, cast.motion, 1.0, cast.b);
  ASSERT_TRUE(passage.has_value()) << "the oracle does not support these casts";
  EXPECT_EQ(name_of(passage->so_far.relation), row.expected);
  const CastErrors errors = cast_errors<N, T>(cast, exact_verdict<N, T>(cast.a, cast.b));
  EXPECT_NE(errors.judgement, Judgement::wrong)
      << errors.fault << ": " << errors.gap << " (gap), " << errors.claimed << " (claimed)";
}

template <Dim N, class T>
void expect_right_impact(const Regression& row) {
  const ImpactErrors errors = impact_errors(moving_from<N, T>(row));
  EXPECT_EQ(errors.hits ? "touch" : "miss", row.expected);
  EXPECT_NE(errors.judgement, Judgement::wrong)
      << errors.fault << ": " << errors.gap << " (gap), " << errors.claimed << " (claimed)";
}

template <Dim N, class T>
void expect_right_hull(const Regression& row) {
  std::vector<Vec<N, T>> points;
  const AnyShape<N, T> held = shape_from<N, T>(row.a);
  for (const Part<N, T>& part : std::get<Compound<N, T>>(held).parts) points.push_back(std::get<Vec<N, T>>(part.shape));
  EXPECT_EQ((std::to_string(convex_hull<N, T>(points).vertices().size())), row.expected);
}

template <Dim N, class T>
void expect_right_mass(const Regression& row) {
  const MassErrors errors = mass_errors<N, T>(shape_from<N, T>(row.a));
  EXPECT_EQ(number_text(errors.true_volume), row.expected);
  EXPECT_TRUE(errors.are_within_bounds())
      << errors.volume << " (volume), " << errors.centroid << " (centroid), " << errors.inertia << " (inertia)";
}

/// Whether the row belongs to this space; if so, it is checked.
template <Dim N, class T>
bool is_checked(const Regression& row) {
  if (row.space != space_text<N, T>()) return false;
  if (row.query == "relation") {
    expect_right_relation<N, T>(row);
  } else if (row.query == "point") {
    expect_right_point<N, T>(row);
  } else if (row.query == "distance") {
    expect_right_distance<N, T>(row);
  } else if (row.query == "contact") {
    expect_right_contact<N, T>(row);
  } else if (row.query == "manifold") {
    expect_right_manifold<N, T>(row);
  } else if (row.query == "ray_cast") {
    expect_right_ray_cast<N, T>(row);
  } else if (row.query == "shape_cast") {
    expect_right_shape_cast<N, T>(row);
  } else if (row.query == "time_of_impact") {
    expect_right_impact<N, T>(row);
  } else if (row.query == "convex_hull") {
    expect_right_hull<N, T>(row);
  } else if (row.query == "mass_properties") {
    expect_right_mass<N, T>(row);
  } else {
    ADD_FAILURE() << "no query is named \"" << row.query << "\"";
  }
  return true;
}

TEST(Regressions, EveryCaseThatTheExamKeptIsAnsweredWithinItsBound) {
  const std::vector<Regression> rows = read_regressions(root() + "/tests/exam/regressions.csv");
  EXPECT_GT(rows.size(), 250U) << "one for most pairs and spaces at least";
  for (const Regression& row : rows) {
    SCOPED_TRACE(row.query + "," + row.space + "," + row.a + "," + row.b + "," + row.expected);
    EXPECT_TRUE((is_checked<2, float>(row) || is_checked<2, double>(row) || is_checked<3, float>(row) ||
                 is_checked<3, double>(row)));
  }
}

TEST(Regressions, ARowReadsBackAsTheSameShapesOfEveryType) {
  check_property([] {
    const AnyShape<3, float> shape = *any_shape<3, float>();
    RC_LOG() << to_source<3, float>(shape) << "\n";
    const std::string text = shape_text<3, float>(shape);
    RC_ASSERT((to_source<3, float>(shape_from<3, float>(text)) == to_source<3, float>(shape)));
  });
}

TEST(Regressions, ARowOfMotionsReadsBackAsTheSame) {
  const Moving<3, float> moving{Sphere<3, float>{{1, 2, 3}, 0.5F},
                                {{0.1F, 0, -4}, {0, 3, 0}, {1, 2, 3}},
                                Segment<3, float>{{0, 0, 0}, {5, 0, 0}},
                                {}};
  const std::string text = impact_row<3, float>(moving, "touch");
  EXPECT_EQ(text,
            "time_of_impact,3D float,sphere 1 2 3 0.5 by 0.1 0 -4 0 3 0 1 2 3,"
            "segment 0 0 0 5 0 0 by 0 0 0 0 0 0 0 0 0,touch");
  const Regression row{"time_of_impact", "3D float", "sphere 1 2 3 0.5 by 0.1 0 -4 0 3 0 1 2 3",
                       "segment 0 0 0 5 0 0 by 0 0 0 0 0 0 0 0 0", "touch"};
  EXPECT_EQ((impact_row<3, float>(moving_from<3, float>(row), "touch")), text);
}

TEST(Regressions, AShapeIsItsNameAndItsNumbers) {
  using Sphere2 = Sphere<2, double>;
  EXPECT_EQ((shape_text<2, double>(Sphere2{{0.1, -2}, 3})), "sphere 0.1 -2 3");
  const AnyShape<2, double> both = compound_of<2, double>({Sphere2{{1, 2}, 3}, Vec<2, double>{4, 5}});
  EXPECT_EQ((shape_text<2, double>(both)), "compound 2 sphere 1 2 3 point 4 5");
  EXPECT_THROW((shape_from<2, double>("circle 1 2 3")), std::runtime_error);
  EXPECT_THROW((shape_from<2, double>("sphere 1 2 x")), std::runtime_error);
  EXPECT_THROW((shape_from<2, double>("sphere 1 2")), std::runtime_error);
}

}  // namespace
}  // namespace graze::test::regressions_test
