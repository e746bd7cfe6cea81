// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

#include "../catalogue.hpp"

namespace graze::any_shape_test {
namespace {

static_assert(dimension_of<AnyShape<2, float>> == 2 && std::is_same_v<scalar_of<AnyShape<3, double>>, double>);
static_assert(std::variant_size_v<AnyShape<3, double>> == shape_type_names.size());

template <class S>
class AnyShapeIn : public testing::Test {};
TYPED_TEST_SUITE(AnyShapeIn, test::Spaces);

TYPED_TEST(AnyShapeIn, NamesEveryTypeInItsOrder) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  using Any = AnyShape<N, T>;
  EXPECT_EQ(type_name(Any(Vec<N, T>(T(0)))), "point");
  EXPECT_EQ(type_name(Any(Segment<N, T>{})), "segment");
  EXPECT_EQ(type_name(Any(Ray<N, T>{})), "ray");
  EXPECT_EQ(type_name(Any(Sphere<N, T>{})), "sphere");
  EXPECT_EQ(type_name(Any(Aabb<N, T>{})), "aabb");
  EXPECT_EQ(type_name(Any(Obb<N, T>{})), "obb");
  EXPECT_EQ(type_name(Any(Plane<N, T>{})), "plane");
  EXPECT_EQ(type_name(Any(HalfSpace<N, T>{})), "half_space");
  EXPECT_EQ(type_name(Any(Triangle<N, T>{})), "triangle");
  EXPECT_EQ(type_name(Any(Capsule<N, T>{})), "capsule");
  EXPECT_EQ(type_name(Any(Polytope<N, T>{})), "polytope");
  EXPECT_EQ(type_name(Any(Compound<N, T>{})), "compound");
}

TYPED_TEST(AnyShapeIn, EveryTypeIsValidByDefault) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::for_each_shape_type<N, T>([]<class S>(std::type_identity<S>) {
    if constexpr (!std::is_same_v<S, Vec<N, T>>) {  // GLM does not initialise vectors
      EXPECT_TRUE(is_valid(AnyShape<N, T>(S{}))) << test::Entry<S>::name;
    }
  });
}

TYPED_TEST(AnyShapeIn, HasTheDefectOfWhatItHolds) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(defect(AnyShape<N, T>(Sphere<N, T>{Vec<N, T>(T(0)), -1})), "has a negative radius");
  EXPECT_EQ(defect(AnyShape<N, T>(Vec<N, T>(T(NAN)))), "has a coordinate that is not finite");
  EXPECT_FALSE(is_valid(AnyShape<N, T>(Plane<N, T>{Vec<N, T>(T(0)), 0})));
}

TYPED_TEST(AnyShapeIn, CatalogueMakesEveryTypeOfIt) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<int> made(shape_type_names.size());
  rc::Random random(1);
  for (int i = 0; i < 600; ++i) ++made[test::any_shape<N, T>()(random.split()).value().index()];
  for (std::size_t type = 0; type < made.size(); ++type) EXPECT_GE(made[type], 10) << shape_type_names[type];
}

// The only macro: the text that is printed for a failing case must compile to that case, so it is compiled here.
#define EXPECT_IS_ITS_OWN_SOURCE(...) EXPECT_EQ(test::to_source(__VA_ARGS__), #__VA_ARGS__)

TEST(AnyShape, PrintsAsSourceThatMakesIt) {
  EXPECT_IS_ITS_OWN_SOURCE(Vec<2, float>{0.1F, -3});
  EXPECT_IS_ITS_OWN_SOURCE(Segment<3, double>{{0, 1, 2}, {1e-300, 0.1, 5e-324}});
  EXPECT_IS_ITS_OWN_SOURCE(Ray<2, float>{{1e+06F, 0}, {16777216, -1}});
  EXPECT_IS_ITS_OWN_SOURCE(Sphere<2, float>{{-0.0F, 1.5F}, 0.30000004F});
  EXPECT_IS_ITS_OWN_SOURCE(Sphere<3, double>{{1, 2, 3}, 0.30000000000000004});
  EXPECT_IS_ITS_OWN_SOURCE(Aabb<2, double>{{-INFINITY, 12345678901.0}, {INFINITY, 1e+300}});
  EXPECT_IS_ITS_OWN_SOURCE(Obb<2, float>{{0, 0}, {1, 2}, {{0, 1}, {-1, 0}}});
  EXPECT_IS_ITS_OWN_SOURCE(Obb<3, double>{{0, 0, 0}, {1, 2, 3}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}});
  EXPECT_IS_ITS_OWN_SOURCE(Plane<2, float>{{0, 1}, 0.25F});
  EXPECT_IS_ITS_OWN_SOURCE(HalfSpace<3, float>{{0, 1, 0}, -4});
  EXPECT_IS_ITS_OWN_SOURCE(Triangle<2, double>{{0, 0}, {1, 0}, {0, 1}});
  EXPECT_IS_ITS_OWN_SOURCE(Capsule<2, float>{{0, 0}, {1, 0}, 3.4028235e+38F});
  EXPECT_IS_ITS_OWN_SOURCE(convex_hull<2, float>(std::vector<Vec<2, float>>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_IS_ITS_OWN_SOURCE(convex_hull<3, double>(std::vector<Vec<3, double>>{{0, 0, 0.5}}));
  EXPECT_IS_ITS_OWN_SOURCE(compound_of<2, float>({}));
  EXPECT_IS_ITS_OWN_SOURCE(
      compound_of<2, float>({Vec<2, float>{1, 2}, compound_of<2, float>({Sphere<2, float>{{0, 0}, 1}})}));
  EXPECT_IS_ITS_OWN_SOURCE(Pose<2, double>{{{1, 0}, {0, 1}}, {3, 4}});
}

TEST(AnyShape, PrintsAsTheShapeItHolds) {
  EXPECT_EQ(test::to_source(AnyShape<2, float>(Circle<>{{1, 2}, 3})), "Sphere<2, float>{{1, 2}, 3}");
  EXPECT_EQ(rc::toString(AnyShape<2, float>(Circle<>{{1, 2}, 3})), "Sphere<2, float>{{1, 2}, 3}");
  EXPECT_EQ(testing::PrintToString(Circle<>{{1, 2}, NAN}), "Sphere<2, float>{{1, 2}, NAN}");
  EXPECT_EQ(testing::PrintToString(Vec<3, float>(1, 2, 3)), "Vec<3, float>{1, 2, 3}");
}

}  // namespace
}  // namespace graze::any_shape_test
