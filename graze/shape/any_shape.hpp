// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/compound.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/point.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

/// A shape of any type; a point is a plain vector. Algorithms for pairs are written for arguments in the order of these
/// alternatives.
template <Dim N, class T = float>
using AnyShape =
    std::variant<Vec<N, T>, Segment<N, T>, Ray<N, T>, Sphere<N, T>, Aabb<N, T>, Obb<N, T>, Plane<N, T>, HalfSpace<N, T>,
                 Triangle<N, T>, Capsule<N, T>, Polytope<N, T>, Compound<N, T>, Mesh<N, T>>;

/// One shape of a compound, and a box around it by which queries skip the part.
template <Dim N, class T = float>
struct Part {
  AnyShape<N, T> shape;  ///< Any shape, another compound included.
  Aabb<N, T> box;        ///< Contains the shape, as `bounds(shape)` does.
};

namespace detail {

/// The array of what `make(std::type_identity<S>())` returns for each alternative S of AnyShape, in its order.
template <Dim N, class T, class Make>
constexpr auto table_of_shapes(const Make& make) {
  return [&make]<class... Shapes>(std::type_identity<std::variant<Shapes...>>) {
    static_assert((Described<Shapes> && ...),
                  "a shape of AnyShape has no description_of: add one behind its struct, as in graze/shape/sphere.hpp");
    return std::array{make(std::type_identity<Shapes>())...};
  }(std::type_identity<AnyShape<N, T>>());
}

}  // namespace detail

/// The names of the types in AnyShape's order, as scene files and reports write them.
inline constexpr auto shape_type_names =
    detail::table_of_shapes<2, float>([]<class S>(std::type_identity<S>) { return detail::description_of<S>.name; });

template <Dim N, Scalar T>
struct ShapeTraits<AnyShape<N, T>> : Space<N, T> {};

/// The name of the alternative that the variant holds, one of `shape_type_names`.
template <Dim N, class T>
std::string_view type_name(const AnyShape<N, T>& shape) {
  return shape_type_names[shape.index()];
}

/// The `defect` of the shape that the variant holds: empty for valid values, otherwise the first fault, worded as the
/// rest of a sentence.
template <Dim N, class T>
std::string_view defect(const AnyShape<N, T>& shape) {
  return detail::visit([](const auto& held) { return defect(held); }, shape);
}

}  // namespace graze
