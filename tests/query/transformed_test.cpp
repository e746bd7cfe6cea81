// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/transformed.hpp>

#include "catalogue.hpp"

namespace graze::transformed_test {
namespace {

template <class S, Dim N, class T>
double size_of(const S& shape, const Pose<N, T>& pose) {
  const Aabb<N, T> box = bounds(shape);
  return static_cast<double>(std::max({max_abs(box.min), max_abs(box.max), max_abs(pose.position)}));
}

/// The composition of `first`, then `second`.
template <Dim N, class T>
Pose<N, T> composed(const Pose<N, T>& first, const Pose<N, T>& second) {
  return {rotated<N, T>(first.rotation, second), transformed(first.position, second)};
}

TEST(Transformed, MovesWhatAnyShapeHolds) {
  const Pose<2, float> pose{Mat<2, float>(rotation_matrix(90)), {10, 0}};
  const AnyShape<2, float> moved = transformed(AnyShape<2, float>(Circle<>{{1, 2}, 3}), pose);
  EXPECT_EQ(test::to_source(moved), "Sphere<2, float>{{8, 1}, 3}");
}

TEST(Transformed, MakesAnOrientedBoxOfAnUprightOne) {
  const Pose<2, float> pose{Mat<2, float>(1.0F), {10, 0}};
  const AnyShape<2, float> moved = transformed(AnyShape<2, float>(Rect<>{{0, 0}, {2, 4}}), pose);
  EXPECT_EQ(test::to_source(moved), "Obb<2, float>{{11, 2}, {1, 2}, {{1, 0}, {0, 1}}}");
}

TEST(Transformed, MovesThePartsOfACompoundAndTheirBoxes) {
  const Compound<2> compound =
      compound_of<2, float>({Circle<>{{2, 0}, 1}, compound_of<2, float>({Rect<>{{0, 0}, {4, 2}}})});
  const Compound<2> moved = transformed(compound, {Mat<2, float>(rotation_matrix(90)), {0, 5}});
  ASSERT_EQ(moved.parts.size(), 2u);
  EXPECT_EQ(test::to_source(moved.parts[0].shape), "Sphere<2, float>{{0, 7}, 1}");
  EXPECT_EQ(moved.parts[0].box, (Rect<>{{-1, 6}, {1, 8}}));
  EXPECT_EQ(type_name(moved.parts[1].shape), "compound");
  EXPECT_EQ(moved.parts[1].box, (Rect<>{{-2, 5}, {0, 9}}));
}

TEST(Transformed, LeavesACompoundWithoutPartsEmpty) {
  EXPECT_TRUE(transformed(Compound<3>{}, Pose<3>{{}, {1, 2, 3}}).parts.empty());
}

/// AABBs become oriented boxes, and compounds may contain AABBs.
template <class S>
inline constexpr bool becomes_another = false;
template <Dim N, class T>
inline constexpr bool becomes_another<Aabb<N, T>> = true;
template <Dim N, class T>
inline constexpr bool becomes_another<Compound<N, T>> = true;

template <class S>
class TransformedIn : public testing::Test {};
TYPED_TEST_SUITE(TransformedIn, test::Spaces);

TYPED_TEST(TransformedIn, ByTheIdentityIsTheSameShape) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_every_type<N, T>([]<class S>(const S& shape) {
    if constexpr (!becomes_another<S>) {
      RC_ASSERT(test::to_source(transformed(shape, Pose<N, T>{})) == test::to_source(shape));
    }
  });
}

TYPED_TEST(TransformedIn, IsValidAndOfTheSameTypeButForBoxes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const AnyShape<N, T> shape = *test::any<AnyShape<N, T>>();
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const AnyShape<N, T> moved = transformed(shape, pose);
    RC_ASSERT(std::string(defect(moved)) == "");
    RC_ASSERT(type_name(moved) == (type_name(shape) == "aabb" ? "obb" : type_name(shape)));
  });
}

TYPED_TEST(TransformedIn, HasTheSupportsOfTheOriginalTurned) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_every_type<N, T>([]<Convex S>(const S& shape) {
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const Vec<N, double> direction = wide<N, T>(*test::draw_source<N, T>().direction);
    const Vec<N, double> turned = wide_matrix<N, T>(pose.rotation) * direction;
    const double before = dot(support(shape, direction), direction) + dot(wide<N, T>(pose.position), turned);
    const double after = dot(support(transformed(shape, pose), turned), turned);
    // Rotations, centers and corners are rounded to T.
    const double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    RC_ASSERT(std::fabs(after - before) <= 32 * epsilon * size_of(shape, pose) * sum_abs(direction));
  });
}

TYPED_TEST(TransformedIn, TwiceIsTransformedByTheComposition) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_every_type<N, T>([]<Convex S>(const S& shape) {
    const Pose<N, T> first = *test::any<Pose<N, T>>();
    const Pose<N, T> second = *test::any<Pose<N, T>>();
    const Vec<N, double> direction = wide<N, T>(*test::draw_source<N, T>().direction);
    const auto twice = transformed(transformed(shape, first), second);
    const auto once = transformed(shape, composed(first, second));
    const double difference = dot(support(twice, direction) - support(once, direction), direction);
    const double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    const double size = size_of(shape, first) + static_cast<double>(max_abs(second.position));
    RC_ASSERT(std::fabs(difference) <= 64 * epsilon * size * sum_abs(direction));
  });
}

TYPED_TEST(TransformedIn, FourQuarterTurnsComeBackExactly) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Pose<N, T> quarter;
  quarter.rotation[0] = unit_axis<N, T>(1);
  quarter.rotation[1] = -unit_axis<N, T>(0);
  test::check_every_type<N, T>([&quarter](const auto& shape) {
    const auto first = transformed(shape, quarter);
    auto turned = first;
    for (int i = 0; i < 4; ++i) turned = transformed(turned, quarter);
    RC_ASSERT(test::to_source(turned) == test::to_source(first));
  });
}

TYPED_TEST(TransformedIn, KeepsTheBoxesOfACompoundAroundItsParts) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Compound<N, T> compound = *test::any<Compound<N, T>>();
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const Compound<N, T> moved = transformed(compound, pose);
    RC_ASSERT(moved.parts.size() == compound.parts.size());
    for (std::size_t i = 0; i < moved.parts.size(); ++i) {
      RC_ASSERT(moved.parts[i].box == bounds(moved.parts[i].shape));
      RC_ASSERT(test::to_source(moved.parts[i].shape) == test::to_source(transformed(compound.parts[i].shape, pose)));
    }
  });
}

TEST(Transformed, ATranslationLeavesAnUprightBoxWhatItIs) {
  const Vec<2, float> offset(10, -1);
  const AnyShape<2, float> box = Rect<>{{0, 0}, {2, 4}};
  EXPECT_EQ(test::to_source(translated(box, offset)), "Aabb<2, float>{{10, -1}, {12, 3}}");
  const AnyShape<2, float> compound = compound_of<2, float>({box, Circle<>{{2, 0}, 1}});
  const AnyShape<2, float> moved = translated(compound, offset);
  const auto& parts = std::get<Compound<2, float>>(moved).parts;
  EXPECT_EQ(test::to_source(parts[0].shape), "Aabb<2, float>{{10, -1}, {12, 3}}");
  EXPECT_EQ(test::to_source(parts[1].shape), "Sphere<2, float>{{12, -1}, 1}");
  EXPECT_EQ(parts[1].box, (Rect<>{{11, -2}, {13, 0}}));
}

TYPED_TEST(TransformedIn, ATranslationIsAPoseThatDoesNotTurn) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const AnyShape<N, T> shape = *test::any_shape<N, T>();
    const Vec<N, T> offset = *test::any<Vec<N, T>>();
    const AnyShape<N, T> moved = translated(shape, offset);
    RC_ASSERT(moved.index() == shape.index());
    if (std::holds_alternative<Aabb<N, T>>(shape) || std::holds_alternative<Compound<N, T>>(shape)) return;
    RC_ASSERT(
        (test::to_source<N, T>(moved) == test::to_source<N, T>(transformed(shape, Pose<N, T>{.position = offset}))));
  });
}

}  // namespace
}  // namespace graze::transformed_test
