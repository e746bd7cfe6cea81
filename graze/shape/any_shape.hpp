// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

template <Dim N, class T>
struct Compound;

/// Any one shape, a point (a plain vector) included. The order here is the order of arguments in which functions of
/// pairs are written.
template <Dim N, class T = float>
using AnyShape = std::variant<Vec<N, T>, Segment<N, T>, Ray<N, T>, Sphere<N, T>, Aabb<N, T>, Obb<N, T>, Plane<N, T>,
                              HalfSpace<N, T>, Triangle<N, T>, Capsule<N, T>, Polytope<N, T>, Compound<N, T>>;

/// The names of the types in AnyShape's order, as scene files and reports write them.
inline constexpr std::array<std::string_view, 12> shape_type_names = {"point",    "segment", "ray",      "sphere",
                                                                      "aabb",     "obb",     "plane",    "half_space",
                                                                      "triangle", "capsule", "polytope", "compound"};

template <Dim N, Scalar T>
struct ShapeTraits<AnyShape<N, T>> : Space<N, T> {};

template <Dim N, class T>
std::string_view type_name(const AnyShape<N, T>& shape) {
  static_assert(std::variant_size_v<AnyShape<N, T>> == shape_type_names.size());
  return shape_type_names[shape.index()];
}

}  // namespace graze

// AnyShape and Compound are one recursive definition in two files: a compound's parts are any shapes.
#include <graze/shape/compound.hpp>  // IWYU pragma: export

namespace graze {

template <Dim N, class T>
std::string_view defect(const AnyShape<N, T>& shape) {
  return detail::visit([](const auto& held) { return defect(held); }, shape);
}

}  // namespace graze
