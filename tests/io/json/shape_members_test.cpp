// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_members.hpp>

namespace graze::io::shape_members_test {
namespace {

template <class Shape>
std::vector<std::string_view> member_names() {
  return std::apply([](const auto&... each) { return std::vector<std::string_view>{each.name...}; },
                    shape_members<Shape>);
}

template <Dim N, class... Shapes>
void expect_names_of_the_format(std::type_identity<std::variant<Shapes...>>) {
  const std::vector<std::vector<std::string_view>> names = {member_names<Shapes>()...};
  for (std::size_t type = 0; type < names.size(); ++type) {
    const auto fields = shape_fields(type, N);
    const bool is_list = shape_type_names[type] == "polytope" || shape_type_names[type] == "compound";
    ASSERT_EQ(names[type].empty(), is_list) << shape_type_names[type];
    EXPECT_TRUE(std::equal(names[type].begin(), names[type].end(), fields.begin())) << shape_type_names[type];
  }
}

TEST(ShapeMembers, AreTheFirstFieldsOfEachTypeInTheSceneFormat) {
  expect_names_of_the_format<2>(std::type_identity<AnyShape<2, double>>());
  expect_names_of_the_format<3>(std::type_identity<AnyShape<3, float>>());
}

TEST(ShapeMembers, CanBeReadAndWritten) {
  Sphere<3, double> sphere{{1, 2, 3}, 4};
  const auto& [center, radius] = shape_members<Sphere<3, double>>;
  std::invoke(radius.of, sphere) += std::invoke(center.of, sphere).z;
  EXPECT_EQ(sphere.radius, 7);
  Vec<2, double> point(1, 2);
  std::invoke(std::get<0>(shape_members<Vec<2, double>>).of, point).x = 5;
  EXPECT_EQ(point, (Vec<2, double>(5, 2)));
}

}  // namespace
}  // namespace graze::io::shape_members_test
