// SPDX-License-Identifier: MIT
// Laws of contains, closest_point, closest_boundary_point and signed_distance for every type of shape: how they agree
// with each other, and invariances.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact/point.hpp"
#include "parts_of.hpp"
#include "query/numbers_of.hpp"
#include "query/placement.hpp"
#include "query/point_answers.hpp"
#include "query/point_judgement.hpp"
#include "query/points.hpp"

namespace graze::test::point_laws_test {
namespace {

/// The largest coordinate of a shape and a point, including those of parts whose bounds are hidden by infinite ones.
template <Dim N, class T>
double whole_size_of(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  double size = size_of<N, T>({shape, point});
  if (const auto* ray = std::get_if<Ray<N, T>>(&shape)) {
    size = std::max(size, static_cast<double>(max_abs(ray->origin)));
  }
  if (const auto compound = parts_of<N, T>(shape)) {
    for (const Part<N, T>& part : compound->parts) size = std::max(size, whole_size_of<N, T>(part.shape, point));
  }
  return size;
}

/// The factor by which answers may be less accurate close to a shape's sharp corners.
template <Dim N, class T>
double sharpness_of(const AnyShape<N, T>& shape) {
  if (const auto compound = parts_of<N, T>(shape)) {
    double sharpest = 1;
    for (const Part<N, T>& part : compound->parts) sharpest = std::max(sharpest, sharpness_of<N, T>(part.shape));
    return sharpest;
  }
  return detail::visit([](const auto& held) { return slenderness(held); }, shape);
}

/// The tolerance in addition to rounding to T: that of thin shapes, and the widest band in double.
template <Dim N, class T>
double allowed(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  const double size =
      std::max(whole_size_of<N, T>(shape, point), static_cast<double>(max_abs(answers<N, T>(shape, point).boundary)));
  const double ulps_of_t = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
  return (tolerance::surface<T> + 64 * tolerance::epsilon + ulps_of_t) * size * sharpness_of<N, T>(shape);
}

template <Dim N, class T>
double length_between(const Vec<N, T>& a, const Vec<N, T>& b) {
  const Vec<N, double> between = wide<N, T>(b) - wide<N, T>(a);
  return std::sqrt(dot(between, between));
}

/// Whether the shape has an interior, so that the laws of solids hold; a compound if all its parts do.
template <Dim N, class T>
bool is_solid(const AnyShape<N, T>& shape) {
  if (const auto compound = parts_of<N, T>(shape)) {
    return std::all_of(compound->parts.begin(), compound->parts.end(),
                       [](const Part<N, T>& part) { return is_solid<N, T>(part.shape); });
  }
  const bool is_flat_triangle = N == 3 && std::holds_alternative<Triangle<N, T>>(shape);
  return !is_flat_triangle && !std::holds_alternative<Vec<N, T>>(shape) &&
         !std::holds_alternative<Segment<N, T>>(shape) && !std::holds_alternative<Ray<N, T>>(shape) &&
         !std::holds_alternative<Plane<N, T>>(shape);
}

template <class SpaceType>
class PointLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Point = Vec<N, T>;

  static PointAnswers<N, T> of(const Any& shape, const Point& point) { return answers<N, T>(shape, point); }
  static double distance(const Any& shape, const Point& point) {
    return static_cast<double>(of(shape, point).distance);
  }

  /// Calls `property(shape, point)` for shapes of every type except compounds without parts.
  static void check(const std::function<void(const Any&, const Point&)>& property) {
    for (std::size_t type = 0; type < shape_type_names.size(); ++type) {
      check_property([type, &property] {
        const auto [shape, point] = *shape_and_point<N, T>(type);
        RC_PRE(std::isfinite(distance(shape, point)));
        RC_LOG() << to_source<N, T>(shape) << ", " << to_source(point) << "\n";
        property(shape, point);
      });
    }
  }
};

// The other two spaces are covered by point_agreement_*_test.cpp.
using LawSpaces = ::testing::Types<Space<3, float>, Space<2, double>>;
TYPED_TEST_SUITE(PointLaw, LawSpaces);

TYPED_TEST(PointLaw, AShapeContainsTheClosestPointsFound) {
  TestFixture::check([](const auto& shape, const auto& point) {
    const auto found = TestFixture::of(shape, point);
    RC_ASSERT(TestFixture::of(shape, found.closest).contained);
    RC_ASSERT(TestFixture::of(shape, found.boundary).contained);
  });
}

TYPED_TEST(PointLaw, ContainsIsADistanceOfZeroOrLessAndAPointThatIsItsOwnClosest) {
  TestFixture::check([](const auto& shape, const auto& point) {
    const auto found = TestFixture::of(shape, point);
    if (!is_solid<TestFixture::N, typename TestFixture::T>(shape)) {
      RC_ASSERT(found.contained || found.closest != point);
      return;
    }
    RC_ASSERT(found.contained == (found.distance <= 0));
    RC_ASSERT(found.contained == (found.closest == point));
    RC_ASSERT(found.contained || found.closest == found.boundary);
  });
}

TYPED_TEST(PointLaw, TheSignedDistanceIsThatToTheClosestBoundaryPoint) {
  TestFixture::check([](const auto& shape, const auto& point) {
    const auto found = TestFixture::of(shape, point);
    const double error = length_between(point, found.boundary) - std::fabs(static_cast<double>(found.distance));
    RC_ASSERT(std::fabs(error) <= (allowed<TestFixture::N, typename TestFixture::T>(shape, point)));
  });
}

TYPED_TEST(PointLaw, NoPointOfTheShapeIsNearerThanTheDistance) {
  TestFixture::check([](const auto& shape, const auto& point) {
    using Number = typename TestFixture::T;
    if (is_union<TestFixture::N, Number>(shape)) return;  // may begin with an empty part
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const typename TestFixture::Point other(point_of<TestFixture::N, Number>(shape, random));
    double slack = allowed<TestFixture::N, Number>(shape, point) + allowed<TestFixture::N, Number>(shape, other);
    // A point drawn on a plane is off it by the rounding of coordinates, which the normal may ignore.
    if (std::holds_alternative<Plane<TestFixture::N, Number>>(shape)) {
      slack += std::fabs(exact_signed_distance<TestFixture::N, Number>(shape, other));
    }
    const auto found = TestFixture::of(shape, point);
    const double distance = found.contained ? 0.0 : std::fabs(static_cast<double>(found.distance));
    RC_ASSERT(distance <= length_between(point, other) + slack);
  });
}

TYPED_TEST(PointLaw, TheSignedDistanceNeverChangesFasterThanThePoint) {
  TestFixture::check([](const auto& shape, const auto& point) {
    using Number = typename TestFixture::T;
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto other = placed_point<TestFixture::N, Number>(shape, point * Number(0.75), seed);
    const double slack = allowed<TestFixture::N, Number>(shape, point) + allowed<TestFixture::N, Number>(shape, other);
    const double change = TestFixture::distance(shape, other) - TestFixture::distance(shape, point);
    RC_ASSERT(std::fabs(change) <= length_between(point, other) + slack);
  });
}

TYPED_TEST(PointLaw, ScalingByAPowerOfTwoScalesEveryAnswerToTheBit) {
  TestFixture::check([](const auto& shape, const auto& point) {
    using Number = typename TestFixture::T;
    const auto factor = std::ldexp(Number(1), *rc::gen::inRange(-30, 31));
    const auto before = TestFixture::of(shape, point);
    const auto after = TestFixture::of(scaled<TestFixture::N, Number>(shape, factor), point * factor);
    RC_ASSERT(after.contained == before.contained);
    RC_ASSERT(after.closest == before.closest * factor);
    RC_ASSERT(after.boundary == before.boundary * factor);
    RC_ASSERT(after.distance == before.distance * factor);
  });
}

TYPED_TEST(PointLaw, QuarterTurnsChangeNothingBeyondRounding) {
  TestFixture::check([](const auto& shape, const auto& point) {
    using Number = typename TestFixture::T;
    const auto turn = [](auto& v) {
      std::swap(v[0], v[1]);
      v[0] = -v[0];
    };
    auto turned = shape;
    auto turned_point = point;
    for_each_vector<TestFixture::N, Number>(turned, turn);
    turn(turned_point);
    const double change = TestFixture::distance(turned, turned_point) - TestFixture::distance(shape, point);
    RC_ASSERT(std::fabs(change) <= (allowed<TestFixture::N, Number>(shape, point)));
  });
}

TYPED_TEST(PointLaw, ACompoundIsItsNearestPart) {
  TestFixture::check([](const auto& shape, const auto& point) {
    using Number = typename TestFixture::T;
    const auto other = *any_shape<TestFixture::N, Number>();
    // The sides of a plane have no sign once it is a part.
    const auto distance_of_part = [&](const auto& part) {
      const double distance = TestFixture::distance(part, point);
      return std::holds_alternative<Plane<TestFixture::N, Number>>(part) ? std::fabs(distance) : distance;
    };
    const auto both = TestFixture::of(compound_of<TestFixture::N, Number>({shape, other}), point);
    RC_ASSERT(both.contained == (TestFixture::of(shape, point).contained || TestFixture::of(other, point).contained));
    RC_ASSERT(static_cast<double>(both.distance) == std::min(distance_of_part(shape), distance_of_part(other)));
  });
}

}  // namespace
}  // namespace graze::test::point_laws_test
