// SPDX-License-Identifier: MIT
#include <cstddef>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/shape_numbers.hpp>

#include "catalogue.hpp"
#include "shape_bits.hpp"

namespace graze::io::shape_numbers_test {
namespace {

TEST(ShapeNumbers, AreRoundedToTheOtherType) {
  const auto sphere = with_numbers<float, 2, double>(Sphere<2, double>{{0.1, 2}, 1e-3});
  EXPECT_EQ(std::get<Sphere<2>>(sphere).center, (Vec<2>(0.1F, 2)));
  EXPECT_EQ(std::get<Sphere<2>>(sphere).radius, 1e-3F);
}

TEST(ShapeNumbers, CanBeChangedAtWill) {
  const auto twice = [](double number) { return 2 * number; };
  const AnyShape<2, double> compound = compound_of<2, double>({Aabb<2, double>{{0, 1}, {2, 3}}});
  const ShapeNumbers<double, decltype(twice)> numbers(twice);
  const auto changed = std::get<Compound<2, double>>(numbers(compound));
  const Part<2, double>& part = changed.parts.front();
  EXPECT_EQ((std::get<Aabb<2, double>>(part.shape)), (Aabb<2, double>{{0, 2}, {4, 6}}));
  EXPECT_EQ(part.box, (Aabb<2, double>{{0, 2}, {4, 6}}));
}

TEST(ShapeNumbers, OfAPolytopeKeepTheOrderOfItsCorners) {
  const std::vector<Vec<3, float>> corners{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  const auto wide = with_numbers<double, 3, float>(convex_hull_in_order<3, float>(corners));
  const auto vertices = std::get<Polytope<3, double>>(wide).vertices();
  ASSERT_EQ(vertices.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(vertices[i], (graze::wide<3, float>(corners[i]))) << i;
}

template <Dim N>
void check_round_trip() {
  const AnyShape<N, float> shape = *test::any_shape<N, float>();
  const AnyShape<N, double> wide = with_numbers<double, N, float>(shape);
  const AnyShape<N, float> back = with_numbers<float, N, double>(wide);
  RC_ASSERT(wide.index() == shape.index());
  RC_ASSERT(bits_of<N>(with_numbers<double, N, float>(back)) == bits_of<N>(wide));
}

RC_GTEST_PROP(ShapeNumbers, OfFloatSurviveInDouble2d, ()) { check_round_trip<2>(); }
RC_GTEST_PROP(ShapeNumbers, OfFloatSurviveInDouble3d, ()) { check_round_trip<3>(); }

}  // namespace
}  // namespace graze::io::shape_numbers_test
