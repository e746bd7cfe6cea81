// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/shape/compound.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::compound_test {
namespace {

template <class S>
class CompoundIn : public testing::Test {};
TYPED_TEST_SUITE(CompoundIn, test::Spaces);

TYPED_TEST(CompoundIn, WithoutPartsIsValid) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_TRUE((Compound<N, T>{}.parts.empty()));
  EXPECT_TRUE(is_valid(Compound<N, T>{}));
}

TYPED_TEST(CompoundIn, IsAsValidAsItsPartsAtAnyDepth) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const T radius : test::nasty_values<T>) {
    const Sphere<N, T> sphere{Vec<N, T>(T(0)), radius};
    Compound<N, T> compound = compound_of<N, T>({Aabb<N, T>{}, sphere});
    const std::string_view expected = is_valid(sphere) ? "" : "has a part that is not valid";
    EXPECT_EQ(defect(compound), expected) << compound;
    for (int depth = 0; depth < 20; ++depth) compound = compound_of<N, T>({Aabb<N, T>{}, compound});
    EXPECT_EQ(defect(compound), expected) << compound;
  }
}

TEST(Compound, KeepsItsPartsInOrderWithABoxForEach) {
  const Compound<2> compound =
      compound_of<2, float>({Circle<>{{10, 0}, 2}, Vec<2, float>(1, 2), Rect<>{{3, 4}, {5, 6}}});
  ASSERT_EQ(compound.parts.size(), 3u);
  EXPECT_EQ(type_name(compound.parts[0].shape), "sphere");
  EXPECT_EQ(compound.parts[0].box, (Rect<>{{8, -2}, {12, 2}}));
  EXPECT_EQ(type_name(compound.parts[1].shape), "point");
  EXPECT_EQ(compound.parts[1].box, (Rect<>{{1, 2}, {1, 2}}));
  EXPECT_EQ(type_name(compound.parts[2].shape), "aabb");
  EXPECT_EQ(compound.parts[2].box, (Rect<>{{3, 4}, {5, 6}}));
}

TEST(Compound, MayHoldACompoundWithTheBoxOfItsParts) {
  const Compound<2> inner = compound_of<2, float>({Circle<>{{0, 0}, 1}, Circle<>{{10, 5}, 1}});
  const Compound<2> outer = compound_of<2, float>({inner});
  ASSERT_EQ(outer.parts.size(), 1u);
  EXPECT_EQ(outer.parts[0].box, (Rect<>{{-1, -1}, {11, 6}}));
  EXPECT_EQ((compound_of<2, float>({Compound<2>{}}).parts[0].box), Rect<>::nothing());
}

TEST(Compound, OwnsItsParts) {
  std::vector<AnyShape<2, float>> shapes{Circle<>{{0, 0}, 1}};
  const Compound<2> compound = compound_of<2, float>(shapes);
  std::get<Circle<>>(shapes[0]).radius = 99;
  EXPECT_EQ(std::get<Circle<>>(compound.parts[0].shape).radius, 1.0F);
}

TYPED_TEST(CompoundIn, HasTheBoxesOfItsPartsInsideItsBounds) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Compound<N, T> compound = *test::any<Compound<N, T>>();
    const Aabb<N, T> outer = bounds(compound);
    Aabb<N, T> sum = Aabb<N, T>::nothing();
    for (const Part<N, T>& part : compound.parts) {
      RC_ASSERT(part.box == bounds(part.shape));
      for (Dim i = 0; i < N && !is_nothing(part.box); ++i) {
        RC_ASSERT(outer.min[i] <= part.box.min[i]);
        RC_ASSERT(outer.max[i] >= part.box.max[i]);
      }
      sum.grow(part.box);
    }
    RC_ASSERT(outer == sum);
  });
}

}  // namespace
}  // namespace graze::compound_test
