// SPDX-License-Identifier: MIT
// Whether a shape lies inside a solid mesh, if it touches none of its faces.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A point of a convex shape that is known exactly, if its type stores one; of a user's type, one of its supports.
template <class S>
Vec<dimension_of<S>, scalar_of<S>> point_in(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using Point = Vec<N, scalar_of<S>>;
  if constexpr (std::is_same_v<S, Point>) {
    return shape;
  } else if constexpr (requires { shape.start; }) {
    return shape.start;
  } else if constexpr (requires { shape.origin; }) {
    return shape.origin;
  } else if constexpr (requires { shape.center; }) {
    return shape.center;
  } else if constexpr (requires { shape.min; }) {
    return shape.min;
  } else if constexpr (requires { shape.a; }) {
    return shape.a;
  } else if constexpr (requires { shape.vertices(); }) {
    return shape.vertices()[0];
  } else {
    return Point(wide_support(shape, unit_axis<N>(0)));
  }
}

template <class S>
concept HasNoEnd = requires(const S& shape) {
  shape.normal;
};

/// A point of a face that is inside a solid with holes, whose winding number may be any on a component of the other.
template <Dim N, class T>
std::optional<Vec<N, T>> point_of_face_near_inside(const Mesh<N, T>& solid, const Mesh<N, T>& mesh) {
  std::optional<Vec<N, T>> point;
  const auto visit = [&](const FacePart<N, T>& face, std::size_t) {
    if (is_inside(solid, face.shape.a)) point = face.shape.a;
    return !point;
  };
  visit_parts(mesh, MayTouch<N, T>{touching_bounds(solid)}, visit);
  return point;
}

/// A point of a shape that touches no face of a mesh, if the shape is inside the mesh. Only a solid in 3D has more than
/// its faces. Shapes of several parts are inside if one of them is.
template <Dim N, class T, class S>
std::optional<Vec<N, T>> point_inside(const Mesh<N, T>& mesh, const S& shape) {
  if (N == 2 || mesh.kind() != MeshKind::solid) return std::nullopt;
  if constexpr (is_mesh<S>) {
    const PlacedMesh<N, T>& other = placed(shape);
    if (!placed(mesh).data()->open_edges().empty()) return point_of_face_near_inside(mesh, shape);
    for (const std::uint32_t vertex : other.data()->vertices_of_components()) {
      if (is_inside(mesh, other.vertex(vertex))) return other.vertex(vertex);
    }
  } else if constexpr (is_compound<S>) {
    for (const Part<N, T>& part : shape.parts) {
      const auto point = detail::visit([&mesh](const auto& held) { return point_inside(mesh, held); }, part.shape);
      if (point) return point;
    }
  } else if constexpr (!HasNoEnd<S>) {
    if (std::isnan(numbers_of(shape))) return std::nullopt;
    const Vec<N, T> point = point_in(shape);
    if (is_inside(mesh, point)) return point;
  }
  return std::nullopt;
}
template <Dim N, class T, class S>
std::optional<Vec<N, T>> point_inside(const Compound<N, T>&, const S&) {
  return std::nullopt;  // a mesh among its parts has been asked
}

}  // namespace graze::detail
