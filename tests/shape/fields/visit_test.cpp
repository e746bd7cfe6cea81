// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"

namespace graze::visit_test {
namespace {

template <class S>
class VisitIn : public testing::Test {};
TYPED_TEST_SUITE(VisitIn, test::Spaces);

/// One shape of each type, in AnyShape's order.
template <Dim N, class T>
std::vector<AnyShape<N, T>> one_of_each() {
  std::vector<AnyShape<N, T>> shapes;
  test::for_each_shape_type<N, T>([&shapes]<class S>(std::type_identity<S>) { shapes.emplace_back(S{}); });
  return shapes;
}

/// The index of this type among the shape's types.
template <class S, class... Types>
std::size_t place_of(const S&, const std::variant<Types...>&) {
  const std::array<bool, sizeof...(Types)> is_it{std::is_same_v<S, Types>...};
  return static_cast<std::size_t>(std::find(is_it.begin(), is_it.end(), true) - is_it.begin());
}

TYPED_TEST(VisitIn, CallsWithWhatIsHeldForEveryTypeOfShape) {
  for (const auto& shape : one_of_each<TypeParam::dimension, typename TypeParam::scalar>()) {
    const auto place = [&shape](const auto& held) { return place_of(held, shape); };
    EXPECT_EQ(detail::visit(place, shape), shape.index());
  }
}

TYPED_TEST(VisitIn, CallsWithBothThatAreHeldInTheirOrder) {
  const auto shapes = one_of_each<TypeParam::dimension, typename TypeParam::scalar>();
  for (const auto& a : shapes) {
    for (const auto& b : shapes) {
      const auto places = [&a, &b](const auto& held_a, const auto& held_b) {
        return std::pair(place_of(held_a, a), place_of(held_b, b));
      };
      EXPECT_EQ(detail::visit(places, a, b), std::pair(a.index(), b.index()));
    }
  }
}

TEST(Visit, LetsTheVisitorChangeWhatIsHeldAndGivesBackReferences) {
  std::variant<int, double> number = 2.5;
  detail::visit([](auto& held) { held *= 2; }, number);
  EXPECT_EQ(std::get<double>(number), 5);

  struct Named {
    std::string name;
  };
  struct Called : Named {};
  std::variant<Named, Called> person = Called{{"Ada"}};
  std::string& name = detail::visit([](auto& held) -> std::string& { return held.name; }, person);
  name = "Grace";
  EXPECT_EQ(std::get<Called>(person).name, "Grace");
}

TEST(Visit, IsOfUseInConstantExpressions) {
  static constexpr std::variant<int, char> held = 'a';
  static_assert(detail::visit([](auto value) { return sizeof(value); }, held) == 1);
}

/// Throws when constructed from a number, which leaves a variant valueless.
struct Fragile {
  explicit Fragile(int) { throw std::runtime_error("broken"); }
  std::string large_enough_not_to_be_made_elsewhere_first;
};

TEST(Visit, RefusesAVariantWithoutAValue) {
  std::variant<std::string, Fragile> broken = "whole";
  EXPECT_THROW(broken.emplace<Fragile>(1), std::runtime_error);
  ASSERT_TRUE(broken.valueless_by_exception());
  EXPECT_THROW(detail::visit([](const auto&) {}, broken), std::bad_variant_access);
}

}  // namespace
}  // namespace graze::visit_test
