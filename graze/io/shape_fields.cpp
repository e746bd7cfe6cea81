// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include <graze/io/shape_fields.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {
namespace {

using Name = std::string_view;

constexpr std::array<Name, 1> point = {"position"};
constexpr std::array<Name, 2> segment = {"start", "end"};
constexpr std::array<Name, 2> ray = {"origin", "direction"};
constexpr std::array<Name, 2> sphere = {"center", "radius"};
constexpr std::array<Name, 4> aabb = {"min", "max", "center", "half_extents"};
constexpr std::array<Name, 4> obb_2d = {"center", "half_extents", "axes", "angle"};
constexpr std::array<Name, 4> obb_3d = {"center", "half_extents", "axes", "rotation"};
constexpr std::array<Name, 2> plane = {"normal", "offset"};
constexpr std::array<Name, 3> triangle = {"a", "b", "c"};
constexpr std::array<Name, 3> capsule = {"a", "b", "radius"};
constexpr std::array<Name, 1> polytope = {"points"};
constexpr std::array<Name, 1> compound = {"parts"};

struct Fields {
  std::span<const Name> in_2d;
  std::span<const Name> in_3d;
};

/// In the order of `shape_type_names`.
constexpr std::array<Fields, shape_type_names.size()> fields_by_type = {{{point, point},
                                                                         {segment, segment},
                                                                         {ray, ray},
                                                                         {sphere, sphere},
                                                                         {aabb, aabb},
                                                                         {obb_2d, obb_3d},
                                                                         {plane, plane},
                                                                         {plane, plane},
                                                                         {triangle, triangle},
                                                                         {capsule, capsule},
                                                                         {polytope, polytope},
                                                                         {compound, compound}}};

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
