// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include <graze/io/json/shape_fields.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::io {
namespace {

using Name = std::string_view;

/// Alternatives to a shape's own fields.
template <class S>
constexpr std::array<Name, 0> other_fields = {};
template <Dim N>
constexpr std::array<Name, 2> other_fields<Aabb<N, double>> = {"center", "half_extents"};
template <Dim N>
constexpr std::array<Name, 1> other_fields<Obb<N, double>> = {orientation_field<N>};

/// The described fields, then the alternatives.
template <class S>
constexpr auto fields_of = detail::description_of<S>.apply([](const auto&... own) {
  std::array<Name, sizeof...(own) + other_fields<S>.size()> names = {own.name...};
  std::copy(other_fields<S>.begin(), other_fields<S>.end(), names.begin() + sizeof...(own));
  return names;
});

template <Dim N>
constexpr auto fields_by_type = detail::table_of_shapes<N, double>([]<class S>(std::type_identity<S>) {
  return std::span<const Name>(fields_of<S>);
});

constexpr std::array<std::pair<Name, Name>, 30> foreign_names = {{
    {"circle", "sphere"},
    {"ball", "sphere"},
    {"disc", "sphere"},
    {"disk", "sphere"},
    {"ellipse", "polytope"},
    {"box", "aabb"},
    {"rect", "aabb"},
    {"rectangle", "aabb"},
    {"cube", "aabb"},
    {"cuboid", "aabb"},
    {"oriented_box", "obb"},
    {"oriented_rect", "obb"},
    {"rotated_box", "obb"},
    {"line", "segment"},
    {"edge", "segment"},
    {"vertex", "point"},
    {"position", "point"},
    {"laser", "ray"},
    {"halfspace", "half_space"},
    {"half_plane", "half_space"},
    {"halfplane", "half_space"},
    {"floor", "half_space"},
    {"tri", "triangle"},
    {"pill", "capsule"},
    {"stadium", "capsule"},
    {"polygon", "polytope"},
    {"convex", "polytope"},
    {"convex_hull", "polytope"},
    {"hull", "polytope"},
    {"group", "compound"},
}};

}  // namespace

std::optional<std::size_t> shape_type_index(std::string_view type) {
  for (std::size_t i = 0; i < shape_type_names.size(); ++i) {
    if (shape_type_names[i] == type) return i;
  }
  return std::nullopt;
}

std::optional<std::string_view> our_shape_name(std::string_view foreign) {
  for (const auto& [name, ours] : foreign_names) {
    if (name == foreign) return ours;
  }
  return std::nullopt;
}

std::span<const std::string_view> shape_fields(std::size_t type_index, Dim dimension) {
  return dimension == 2 ? fields_by_type<2>[type_index] : fields_by_type<3>[type_index];
}

}  // namespace graze::io
