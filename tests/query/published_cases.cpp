// SPDX-License-Identifier: MIT
// Evaluates the published cases: compiled once for all of their tables.
#include "query/published_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounding/sphere.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact/kinds.hpp"
#include "query/contacts.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/point_answers.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/regressions.hpp"
#include "query/shape_casts.hpp"
#include "query/times_of_impact.hpp"

namespace graze::test {
namespace {

/// The usual error of an answer, in epsilon of its type times the largest number of the case: that of rounding a few
/// input numbers, and the answer.
constexpr double usual_error = 4;

/// The numbers among the words of a text.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (const auto x = number_in<double>(word)) numbers.push_back(*x);
  }
  return numbers;
}

double largest_in(const PublishedCase& c) {
  double largest = 0;
  for (const char* text : {c.a, c.b}) {
    for (const double x : numbers_in(text)) largest = std::max(largest, std::fabs(x));
  }
  return largest;
}

template <Dim N, class T>
Vec<N, T> vector_at(const std::vector<double>& numbers, std::size_t first) {
  Vec<N, T> result(T(0));
  for (Dim i = 0; i < N; ++i) result[i] = static_cast<T>(numbers.at(first + static_cast<std::size_t>(i)));
  return result;
}

template <Dim N, class T>
Vec<N, double> difference(const Vec<N, T>& a, const Vec<N, double>& b) {
  return wide<N, T>(a) - b;
}

/// One case in one space.
template <Dim N, class T>
class Asked {
 public:
  using Any = AnyShape<N, T>;

  explicit Asked(const PublishedCase& published)
      : case_(published),
        answer_(numbers_in(published.answer)),
        epsilon_(static_cast<double>(std::numeric_limits<T>::epsilon()) * usual_error * published.slack),
        error_(epsilon_ * largest_in(published)) {}

  void about(std::string_view question) const {
    if (question == "relation") return relation();
    if (question == "distance") return distance();
    if (question == "depth") return depth();
    if (question == "ray") return ray();
    if (question == "cast") return cast();
    if (question == "impact") return impact();
    if (question == "point") return point();
    if (question == "hull") return hull();
    if (question == "ball") return sphere();
    if (question == "mass") return mass();
    ADD_FAILURE() << "nothing is asked by \"" << question << "\"";
  }

 private:
  Any first() const { return shape_from<N, T>(case_.a); }
  Any second() const { return shape_from<N, T>(case_.b); }

  /// A shape from -x to x is 2 x wide.
  double volume_error() const { return epsilon_ * std::pow(2 * largest_in(case_), N); }

  void expect_near(double given, double wanted, double error) const {
    EXPECT_TRUE(std::fabs(given - wanted) <= error) << number_text(given) << " instead of " << number_text(wanted)
                                                    << ", off by " << given - wanted << ", allowed " << error;
  }

  void expect_near(const Vec<N, T>& given, std::size_t at, double error) const {
    EXPECT_LE(max_abs(difference(given, vector_at<N, double>(answer_, at))), error) << given;
  }

  /// Laws of any two shapes: the queries agree, in both orders.
  Relation story(const Any& a, const Any& b) const {
    const Relation relation = relation_of<N, T>(a, b);
    EXPECT_EQ((relation_of<N, T>(b, a)), relation);
    const auto nearest = closest_points_of<N, T>(a, b);
    EXPECT_EQ((distance_of<N, T>(a, b)), nearest.distance);
    EXPECT_EQ((distance_of<N, T>(b, a)), nearest.distance);
    EXPECT_EQ(nearest.relation, relation);
    const auto contact = contact_of<N, T>(a, b);
    const auto swapped = contact_of<N, T>(b, a);
    EXPECT_EQ(contact.has_value(), relation != Relation::apart);
    EXPECT_EQ(swapped.has_value(), relation != Relation::apart);
    EXPECT_EQ(nearest.distance == T(0), relation != Relation::apart);
    if (relation == Relation::apart) {
      const double length = std::sqrt(length_squared(wide<N, T>(nearest.point_b) - wide<N, T>(nearest.point_a)));
      expect_near(length, static_cast<double>(nearest.distance), 2 * error_);
      EXPECT_LE((distance_of<N, T>(a, Any(nearest.point_a))), error_);
      EXPECT_LE((distance_of<N, T>(b, Any(nearest.point_b))), error_);
    } else if (contact && swapped) {
      EXPECT_EQ(contact->depth, swapped->depth);
      if (std::isfinite(contact->depth)) parts(a, b, *contact);
    }
    return relation;
  }

  /// Moved by slightly more than normal times depth, the shapes do not overlap; by slightly less, they do.
  void parts(const Any& a, const Any& b, const Contact<N, T>& contact) const {
    EXPECT_NEAR(static_cast<double>(length_squared(wide<N, T>(contact.normal))), 1, 8 * epsilon_);
    const auto manifold = manifold_of<N, T>(a, b);
    EXPECT_GT(manifold.size, 0U);
    const T out = contact.depth + static_cast<T>(4 * error_);
    EXPECT_NE((relation_of<N, T>(a, moved<N, T>(b, contact.normal * out))), Relation::overlapping);
    const T in = contact.depth - static_cast<T>(4 * error_);
    if (in > T(0)) {
      EXPECT_NE((relation_of<N, T>(a, moved<N, T>(b, contact.normal * in))), Relation::apart);
    }
  }

  void relation() const {
    const Relation given = story(first(), second());
    const std::string_view wanted = case_.answer;
    if (wanted == "meet") {
      EXPECT_NE(given, Relation::apart);
    } else {
      EXPECT_EQ(name_of(given), wanted);
    }
  }

  void distance() const {
    const Any a = first();
    const Any b = second();
    story(a, b);
    const auto nearest = closest_points_of<N, T>(a, b);
    expect_near(static_cast<double>(nearest.distance), answer_.at(0), error_);
    if (answer_.size() > 1) {
      expect_near(nearest.point_a, 1, error_);
      expect_near(nearest.point_b, 1 + static_cast<std::size_t>(N), error_);
    }
  }

  void depth() const {
    const Any a = first();
    const Any b = second();
    story(a, b);
    const auto contact = contact_of<N, T>(a, b);
    ASSERT_TRUE(contact);
    expect_near(static_cast<double>(contact->depth), answer_.at(0), error_);
    if (answer_.size() > 1) expect_near(contact->normal, 1, epsilon_);
  }

  std::optional<RayHit<N, T>> hit(const Any& shape, const Any& path) const {
    if (const auto* segment = std::get_if<Segment<N, T>>(&path)) return hit_of<N, T>(shape, *segment);
    return hit_of<N, T>(shape, std::get<Ray<N, T>>(path), std::numeric_limits<T>::infinity());
  }

  void ray() const {
    const Any shape = first();
    const Any path = second();
    const auto found = hit(shape, path);
    EXPECT_EQ(found.has_value(), (relation_of<N, T>(shape, path)) != Relation::apart);
    if (std::string_view(case_.answer) == "none") {
      EXPECT_FALSE(found) << "at " << found->t;
      return;
    }
    ASSERT_TRUE(found);
    const auto* ray = std::get_if<Ray<N, T>>(&path);
    const auto* segment = std::get_if<Segment<N, T>>(&path);
    const Vec<N, double> way =
        ray != nullptr ? wide<N, T>(ray->direction) : wide<N, T>(segment->end) - wide<N, T>(segment->start);
    const double size = std::sqrt(length_squared(way));
    expect_near(static_cast<double>(found->t), answer_.at(0), error_ / size + epsilon_ * std::fabs(answer_[0]));
    EXPECT_LE((distance_of<N, T>(shape, Any(found->point))), error_);
    if (answer_.size() > 1) expect_near(found->normal, 1, epsilon_);
  }

  /// The parts before and after "by".
  static std::pair<Any, std::vector<double>> moving(const std::string& text) {
    const std::size_t by = text.find(" by ");
    if (by == std::string::npos) throw std::runtime_error("published cases: nothing moves: " + text);
    return {shape_from<N, T>(text.substr(0, by)), numbers_in(text.substr(by + 4))};
  }

  static Motion<N, T> motion_of(const std::vector<double>& numbers) {
    if constexpr (N == 2) {
      return {vector_at<N, T>(numbers, 0), static_cast<T>(numbers.at(2)), vector_at<N, T>(numbers, 3)};
    } else {
      return {vector_at<N, T>(numbers, 0), vector_at<N, T>(numbers, 3), vector_at<N, T>(numbers, 6)};
    }
  }

  void impact() const {
    const auto [a, way_a] = moving(case_.a);
    const auto [b, way_b] = moving(case_.b);
    const Motion<N, T> motion_a = motion_of(way_a);
    const Motion<N, T> motion_b = motion_of(way_b);
    const auto found = impact_of<N, T>({a, motion_a, b, motion_b});
    const auto other = impact_of<N, T>({b, motion_b, a, motion_a});
    EXPECT_EQ(found.has_value(), other.has_value());
    if (std::string_view(case_.answer) == "none") {
      EXPECT_FALSE(found) << "at " << found->t;
      return;
    }
    ASSERT_TRUE(found && other);
    EXPECT_EQ(found->t, other->t);
    EXPECT_LE(static_cast<double>(found->t), answer_.at(0) + error_);
    // motions have at least unit length
    expect_near(static_cast<double>(found->t), answer_[0], 4 * (error_ + found->error));
  }

  void cast() const {
    const auto [a, numbers] = moving(case_.a);
    const Any b = second();
    const Vec<N, T> way = vector_at<N, T>(numbers, 0);
    const auto found = impact_of<N, T>(a, way, b);
    const auto other = impact_of<N, T>(b, -way, a);
    EXPECT_EQ(found.has_value(), other.has_value());
    if (std::string_view(case_.answer) == "none") {
      EXPECT_FALSE(found) << "at " << found->t;
      return;
    }
    ASSERT_TRUE(found && other);
    const double size = std::sqrt(length_squared(wide<N, T>(way)));
    EXPECT_LE(found->error, 48 * error_) << "is what it may be early by";
    const double error = answer_.at(0) == 0 ? 0 : (error_ + found->error) / size;
    expect_near(static_cast<double>(found->t), answer_[0], error);
    expect_near(static_cast<double>(other->t), answer_[0], error);
    if (answer_.size() > 1) expect_near(found->normal, 1, epsilon_);
  }

  void point() const {
    const Any shape = first();
    const auto place = std::get<Vec<N, T>>(second());
    const PointAnswers<N, T> given = answers<N, T>(shape, place);
    expect_near(static_cast<double>(given.distance), answer_.at(0), error_);
    if (answer_[0] == 0 || std::fabs(answer_[0]) > error_) {
      EXPECT_EQ(given.contained, answer_[0] <= 0);
    }
    EXPECT_TRUE((answers<N, T>(shape, given.closest).contained));
    EXPECT_TRUE((answers<N, T>(shape, given.boundary).contained));
    const double length = std::sqrt(length_squared(wide<N, T>(given.boundary) - wide<N, T>(place)));
    expect_near(length, std::fabs(answer_[0]), 2 * error_);
    expect_near(static_cast<double>(distance_of<N, T>(shape, Any(place))), std::max(0.0, answer_[0]), error_);
    if (answer_.size() > 1) expect_near(given.closest, 1, error_);
  }

  std::vector<Vec<N, T>> points() const {
    const std::vector<double> numbers = numbers_in(case_.a);
    std::vector<Vec<N, T>> result;
    for (std::size_t at = 1; at < numbers.size(); at += static_cast<std::size_t>(N)) {
      result.push_back(vector_at<N, T>(numbers, at));
    }
    return result;
  }

  void hull() const {
    const auto polytope = std::get<Polytope<N, T>>(first());
    EXPECT_EQ(static_cast<double>(polytope.vertices().size()), answer_.at(0));
    expect_near(mass_properties(polytope).volume, answer_.at(1), volume_error());
    for (const Vec<N, T>& place : points()) {
      EXPECT_NE((relation_of<N, T>(Any(polytope), Any(place))), Relation::apart) << place;
    }
  }

  void sphere() const {
    const std::vector<Vec<N, T>> all = points();
    const Sphere<N, T> sphere = bounding_sphere(all);
    expect_near(static_cast<double>(sphere.radius), answer_.at(0), error_);
    expect_near(sphere.center, 1, error_);
    for (const Vec<N, T>& place : all) EXPECT_TRUE((answers<N, T>(Any(sphere), place).contained)) << place;
  }

  void mass() const {
    const MassProperties<N> given = mass_properties(first());
    expect_near(given.volume, answer_.at(0), volume_error());
    EXPECT_LE(max_abs(given.centroid - vector_at<N, double>(answer_, 1)), error_);
  }

  const PublishedCase& case_;
  std::vector<double> answer_;
  double epsilon_;  ///< The tolerance for a number of size 1.
  double error_;    ///< The tolerance for a length.
};

void expect_answer(const PublishedCase& c) {
  std::istringstream words{std::string(c.asked)};
  std::string space;
  std::string number;
  std::string question;
  words >> space >> number >> question;
  const bool in_float = number != "double";
  const bool in_double = number != "float";
  if (question.empty()) question = number;
  if (space == "2D" && in_float) Asked<2, float>(c).about(question);
  if (space == "2D" && in_double) Asked<2, double>(c).about(question);
  if (space == "3D" && in_float) Asked<3, float>(c).about(question);
  if (space == "3D" && in_double) Asked<3, double>(c).about(question);
  EXPECT_TRUE(space == "2D" || space == "3D") << "a case begins with its space";
}

}  // namespace

void expect_published(std::span<const PublishedCase> cases) {
  for (const PublishedCase& c : cases) {
    SCOPED_TRACE(std::string(c.source) + "\n  " + c.asked + "\n  " + c.a + "\n  " + c.b + "\n  " + c.answer);
    expect_answer(c);
  }
}

}  // namespace graze::test
