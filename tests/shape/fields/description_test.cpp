// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::description_test {
namespace {

using detail::FieldKind;
using NamesAndKinds = std::vector<std::pair<std::string_view, FieldKind>>;

template <class S>
NamesAndKinds fields_of() {
  return detail::description_of<S>.apply([]<class... Fields>(const Fields&... fields) {
    return NamesAndKinds{{fields.name, Fields::kind}...};
  });
}

/// All operations on fields follow from these.
TEST(Description, SaysWhatEachFieldMeans) {
  constexpr auto point = FieldKind::point;
  constexpr auto length = FieldKind::length;
  const NamesAndKinds of_plane = {{"normal", FieldKind::direction}, {"offset", FieldKind::offset}};
  const std::array<NamesAndKinds, shape_type_names.size()> expected = {{
      {{"position", point}},
      {{"start", point}, {"end", point}},
      {{"origin", point}, {"direction", FieldKind::direction}},
      {{"center", point}, {"radius", length}},
      {{"min", point}, {"max", point}},
      {{"center", point}, {"half_extents", FieldKind::half_extents}, {"axes", FieldKind::axes}},
      of_plane,
      of_plane,
      {{"a", point}, {"b", point}, {"c", point}},
      {{"a", point}, {"b", point}, {"radius", length}},
      {{"points", FieldKind::hull}},
      {{"parts", FieldKind::parts}},
      {{"vertices", FieldKind::vertices}, {"faces", FieldKind::faces}, {"kind", FieldKind::mesh_kind}},
  }};
  const auto in_2d = detail::table_of_shapes<2, float>([]<class S>(std::type_identity<S>) { return fields_of<S>(); });
  const auto in_3d = detail::table_of_shapes<3, double>([]<class S>(std::type_identity<S>) { return fields_of<S>(); });
  for (std::size_t type = 0; type < expected.size(); ++type) {
    EXPECT_EQ(in_2d[type], expected[type]) << shape_type_names[type];
    EXPECT_EQ(in_3d[type], expected[type]) << shape_type_names[type];
  }
  EXPECT_EQ(fields_of<Frustum<3>>(), (NamesAndKinds{{"corners", FieldKind::corners}}));
}

struct Unknown {};
static_assert(detail::Described<Sphere<2, float>> && detail::Described<Vec<3, double>>);
static_assert(!detail::Described<Unknown> && !detail::Described<AnyShape<2, float>>);

TEST(Description, LetsFieldsBeReadAndChanged) {
  Sphere<3, double> sphere{{1, 2, 3}, 4};
  detail::description_of<Sphere<3, double>>.apply(
      [&](const auto& center, const auto& radius) { radius.in(sphere) += center.in(std::as_const(sphere)).z; });
  EXPECT_EQ(sphere.radius, 7);
  Vec<2, double> point(1, 2);
  detail::for_each_field(point, [](const auto&, auto& position) { position.x = 5; });
  EXPECT_EQ(point, (Vec<2, double>(5, 2)));
}

TEST(Description, VisitsEveryNumber) {
  Obb<2, double> box{{1, 2}, {3, 4}, {{5, 6}, {7, 8}}};
  std::vector<double> numbers;
  detail::for_each_field(std::as_const(box), [&numbers](const auto&, const auto& value) {
    detail::for_each_number(value, [&numbers](double number) { numbers.push_back(number); });
  });
  EXPECT_EQ(numbers, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  detail::for_each_field(
      box, [](const auto&, auto& value) { detail::for_each_number(value, [](double& number) { number = -number; }); });
  EXPECT_EQ(box.axes[1].y, -8);
}

}  // namespace
}  // namespace graze::description_test
