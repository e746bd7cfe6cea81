// SPDX-License-Identifier: MIT
/// @file
/// Converts shapes between number types.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/converted.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::io {

/// Converts shapes by applying `change(number)`, which returns a number of the new type, to every number. The boxes of
/// a compound's parts are recalculated. Throws std::invalid_argument if a corner of a polytope or a mesh is no longer
/// finite.
template <class To, class Change>
class ShapeNumbers {
 public:
  /// Keeps a copy of the function.
  explicit ShapeNumbers(Change change) : change_(std::move(change)) {}

  /// The converted shape, of the same alternative. A polytope becomes the hull of its converted corners, in their
  /// order.
  template <Dim N, class From>
  AnyShape<N, To> operator()(const AnyShape<N, From>& shape) const {
    return detail::visit([this](const auto& held) { return AnyShape<N, To>(this->of(held)); }, shape);
  }

  /// The converted point.
  template <Dim N, class From>
  Vec<N, To> of(const Vec<N, From>& point) const {
    Vec<N, To> changed;
    detail::convert(point, changed, change_);
    return changed;
  }

 private:
  template <template <Dim, class> class S, Dim N, class From>
  S<N, To> of(const S<N, From>& shape) const {
    return detail::converted<To>(shape, change_);
  }
  template <Dim N, class From>
  Polytope<N, To> of(const Polytope<N, From>& polytope) const {
    std::vector<Vec<N, To>> points;
    for (const Vec<N, From>& vertex : polytope.vertices()) points.push_back(of(vertex));
    return convex_hull_in_order<N, To>(points);
  }
  template <Dim N, class From>
  Mesh<N, To> of(const Mesh<N, From>& mesh) const {
    std::vector<Vec<N, To>> vertices;
    for (const Vec<N, From>& vertex : mesh.vertices()) vertices.push_back(of(vertex));
    return mesh_of<N, To>(vertices, mesh.faces(), mesh.kind());
  }
  template <Dim N, class From>
  Compound<N, To> of(const Compound<N, From>& compound) const {
    std::vector<AnyShape<N, To>> parts;
    for (const Part<N, From>& part : compound.parts) parts.push_back((*this)(part.shape));
    return compound_of<N, To>(std::move(parts));
  }

  Change change_;
};

/// A shape converted to another number type: exactly if it is the larger one, otherwise rounded. Throws like
/// ShapeNumbers.
template <class To, Dim N, class From>
AnyShape<N, To> with_numbers(const AnyShape<N, From>& shape) {
  if constexpr (std::is_same_v<To, From>) {
    return shape;
  } else {
    const auto round = [](From number) { return static_cast<To>(number); };
    return ShapeNumbers<To, decltype(round)>(round)(shape);
  }
}

}  // namespace graze::io
