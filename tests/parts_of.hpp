// SPDX-License-Identifier: MIT
// Shapes that are unions of others, seen alike: compounds, and meshes, which are the unions of their faces.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::test {

/// The faces of a mesh, in their order.
template <Dim N, class T>
Compound<N, T> as_compound(const Mesh<N, T>& mesh) {
  std::vector<AnyShape<N, T>> faces;
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) faces.push_back(mesh.triangle(face));
  return compound_of<N, T>(std::move(faces));
}

/// The compound that a shape is, or that has the same points; none for simple shapes.
template <Dim N, class T>
std::optional<Compound<N, T>> parts_of(const AnyShape<N, T>& shape) {
  if (const auto* compound = std::get_if<Compound<N, T>>(&shape)) return *compound;
  if (const auto* mesh = std::get_if<Mesh<N, T>>(&shape)) return as_compound(*mesh);
  return std::nullopt;
}

/// Whether a shape is the union of others.
template <Dim N, class T>
bool is_union(const AnyShape<N, T>& shape) {
  return std::holds_alternative<Compound<N, T>>(shape) || std::holds_alternative<Mesh<N, T>>(shape);
}

/// A mesh with each vertex replaced by change(vertex).
template <Dim N, class T, class Change>
Mesh<N, T> with_vertices_changed(const Mesh<N, T>& mesh, const Change& change) {
  std::vector<Vec<N, T>> vertices;
  for (const Vec<N, T>& vertex : mesh.vertices()) vertices.push_back(change(vertex));
  return mesh_of<N, T>(vertices, mesh.faces(), mesh.kind());
}

}  // namespace graze::test
