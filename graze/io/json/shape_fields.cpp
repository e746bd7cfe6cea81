// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include <graze/io/json/shape_fields.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {
namespace {

using Name = std::string_view;

constexpr std::array<Name, 1> fields_of_point = {"position"};
constexpr std::array<Name, 2> fields_of_segment = {"start", "end"};
constexpr std::array<Name, 2> fields_of_ray = {"origin", "direction"};
constexpr std::array<Name, 2> fields_of_sphere = {"center", "radius"};
constexpr std::array<Name, 4> fields_of_aabb = {"min", "max", "center", "half_extents"};
constexpr std::array<Name, 4> fields_of_obb_2d = {"center", "half_extents", "axes", "angle"};
constexpr std::array<Name, 4> fields_of_obb_3d = {"center", "half_extents", "axes", "rotation"};
constexpr std::array<Name, 2> fields_of_plane = {"normal", "offset"};
constexpr std::array<Name, 3> fields_of_triangle = {"a", "b", "c"};
constexpr std::array<Name, 3> fields_of_capsule = {"a", "b", "radius"};
constexpr std::array<Name, 1> fields_of_polytope = {"points"};
constexpr std::array<Name, 1> fields_of_compound = {"parts"};

struct Fields {
  std::span<const Name> in_2d;
  std::span<const Name> in_3d;
};

/// In the order of `shape_type_names`.
constexpr std::array<Fields, shape_type_names.size()> fields_by_type = {{{fields_of_point, fields_of_point},
                                                                         {fields_of_segment, fields_of_segment},
                                                                         {fields_of_ray, fields_of_ray},
                                                                         {fields_of_sphere, fields_of_sphere},
                                                                         {fields_of_aabb, fields_of_aabb},
                                                                         {fields_of_obb_2d, fields_of_obb_3d},
                                                                         {fields_of_plane, fields_of_plane},
                                                                         {fields_of_plane, fields_of_plane},
                                                                         {fields_of_triangle, fields_of_triangle},
                                                                         {fields_of_capsule, fields_of_capsule},
                                                                         {fields_of_polytope, fields_of_polytope},
                                                                         {fields_of_compound, fields_of_compound}}};

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
  const Fields& fields = fields_by_type[type_index];
  return dimension == 2 ? fields.in_2d : fields.in_3d;
}

}  // namespace graze::io
