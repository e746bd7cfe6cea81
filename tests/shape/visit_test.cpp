// SPDX-License-Identifier: MIT
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/visit.hpp>

#include "../catalogue.hpp"

namespace graze::visit_test {
namespace {

template <class S>
class VisitIn : public testing::Test {};
TYPED_TEST_SUITE(VisitIn, test::Spaces);

TYPED_TEST(VisitIn, CallsWithWhatIsHeldForEveryTypeOfShape) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::for_each_shape_type<N, T>([]<class S>(std::type_identity<S>) {
    const AnyShape<N, T> shape{S{}};
    const bool is_same = detail::visit(
        [&shape]<class Held>(const Held& held) {
          return std::is_same_v<Held, S> && static_cast<const void*>(&held) == std::get_if<S>(&shape);
        },
        shape);
    EXPECT_TRUE(is_same) << test::Entry<S>::name;
  });
}

TYPED_TEST(VisitIn, CallsWithBothThatAreHeldInTheirOrder) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::for_each_shape_type<N, T>([]<class A>(std::type_identity<A>) {
    test::for_each_shape_type<N, T>([]<class B>(std::type_identity<B>) {
      const AnyShape<N, T> a{A{}};
      const AnyShape<N, T> b{B{}};
      const auto are_same = []<class HeldA, class HeldB>(const HeldA&, const HeldB&) {
        return std::is_same_v<HeldA, A> && std::is_same_v<HeldB, B>;
      };
      EXPECT_TRUE(detail::visit(are_same, a, b)) << test::Entry<A>::name << ", " << test::Entry<B>::name;
    });
  });
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

/// Cannot be made of a number: whoever tries leaves a variant without a value.
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
