// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/platform/throw.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/mesh/placed_mesh.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

template <Dim N, class T>
class Mesh;

namespace detail {
template <Dim N, class T>
const PlacedMesh<N, T>& placed(const Mesh<N, T>& mesh);
}  // namespace detail

/// Triangles that share vertices: the union of its closed faces and, of a solid in 3D, all points with a winding number
/// above 1/2, that is, the inside. In 2D, faces are filled areas, so a surface and a solid contain the same points.
/// Made by `mesh_of`. A mesh never changes: copies share the triangles, and a moved one (`transformed`) shares them,
/// too. Default: a surface without faces, which is valid and touches nothing.
template <Dim N, class T = float>
class Mesh {
 public:
  Mesh()
      : Mesh(std::make_shared<const Data>(std::vector<Vec<N, T>>(), Faces(), MeshKind::surface, detail::OneByOne())) {}

  /// Whether it is a surface or a solid.
  MeshKind kind() const { return placed_->data()->kind(); }

  /// The corners of the faces, by index; some may belong to no face. Those of a mesh that was moved are calculated by
  /// the first call, and are exactly those that queries use.
  std::span<const Vec<N, T>> vertices() const { return placed_->vertices(); }

  /// Three indices of vertices each. As seen from outside a solid they run counter-clockwise.
  std::span<const std::array<std::uint32_t, 3>> faces() const { return placed_->data()->faces(); }

  /// One of the faces.
  Triangle<N, T> triangle(std::size_t face) const { return placed_->triangle(face); }

 private:
  using Data = detail::MeshData<N, T>;
  using Faces = typename Data::Faces;
  using Placed = detail::PlacedMesh<N, T>;

  explicit Mesh(std::shared_ptr<const Data> data) : placed_(std::make_shared<const Placed>(std::move(data))) {}
  explicit Mesh(std::shared_ptr<const Placed> placed) : placed_(std::move(placed)) {}

  template <Dim M, class U, class Executor>
  friend Mesh<M, U> mesh_of(std::type_identity_t<std::span<const Vec<M, U>>> vertices,
                            std::span<const std::array<std::uint32_t, 3>> faces, MeshKind kind,
                            const Executor& executor);
  template <Dim M, class U>
  friend Mesh<M, U> moved(const Mesh<M, U>& mesh, std::type_identity_t<std::span<const Vec<M, U>>> vertices);
  template <Dim M, class U>
  friend Mesh<M, U> transformed(const Mesh<M, U>& mesh, const Pose<M, U>& pose);
  template <Dim M, class U>
  friend const detail::PlacedMesh<M, U>& detail::placed(const Mesh<M, U>& mesh);

  std::shared_ptr<const Placed> placed_;
};

namespace detail {

template <Dim N, class T>
const PlacedMesh<N, T>& placed(const Mesh<N, T>& mesh) {
  return *mesh.placed_;
}

template <Dim N, class T>
inline constexpr auto description_of<Mesh<N, T>> = Description("mesh",
                                                               field::vertices("vertices", &Mesh<N, T>::vertices),
                                                               field::faces("faces", &Mesh<N, T>::faces),
                                                               field::mesh_kind("kind", &Mesh<N, T>::kind));

/// Throws std::invalid_argument, naming `function` and the vertex, if a coordinate is not finite.
template <Dim N, class T>
void check_vertices(std::string_view function, std::span<const Vec<N, T>> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (is_finite(vertices[i])) continue;
    GRAZE_THROW(std::invalid_argument(std::string(function) + ": vertex " + std::to_string(i) +
                                      " has a coordinate that is not finite"));
  }
}

/// Throws std::invalid_argument, naming the face, if an index is not that of a vertex; std::length_error if there are
/// more faces than 32 bits can count.
inline void check_faces(std::span<const std::array<std::uint32_t, 3>> faces, std::size_t vertices) {
  if (faces.size() >= std::numeric_limits<std::uint32_t>::max()) {
    GRAZE_THROW(std::length_error("mesh_of: there are more than 2^32 - 2 faces"));
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (const std::uint32_t vertex : faces[face]) {
      if (vertex < vertices) continue;
      GRAZE_THROW(std::invalid_argument("mesh_of: face " + std::to_string(face) + " has vertex " +
                                        std::to_string(vertex) + ", but there are " + std::to_string(vertices) +
                                        " vertices, numbered from 0"));
    }
  }
}

}  // namespace detail

/// The next, built by the threads of an Executor (broad/executor.hpp): the mesh does not depend on it.
template <Dim N, class T, class Executor>
Mesh<N, T> mesh_of(std::type_identity_t<std::span<const Vec<N, T>>> vertices,
                   std::span<const std::array<std::uint32_t, 3>> faces, MeshKind kind, const Executor& executor) {
  using Data = detail::MeshData<N, T>;
  detail::check_vertices<N, T>("mesh_of", vertices);
  detail::check_faces(faces, vertices.size());
  return Mesh<N, T>(std::make_shared<const Data>(std::vector<Vec<N, T>>(vertices.begin(), vertices.end()),
                                                 typename Data::Faces(faces.begin(), faces.end()), kind, executor));
}

/// A mesh of vertices and faces, which are copied. Any faces are accepted: open or closed, crossing each other, flat,
/// equal, or none; `report` tells. Vertices are equal only if their indices are: see `welded`. Throws
/// std::invalid_argument, naming the vertex or face, if a coordinate is not finite or an index is not that of a vertex.
template <Dim N, class T>
Mesh<N, T> mesh_of(std::type_identity_t<std::span<const Vec<N, T>>> vertices,
                   std::span<const std::array<std::uint32_t, 3>> faces, MeshKind kind = MeshKind::surface) {
  return mesh_of<N, T>(vertices, faces, kind, detail::OneByOne());
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto mesh_of(const Row& vertices, std::span<const std::array<std::uint32_t, 3>> faces,
             MeshKind kind = MeshKind::surface) {
  using Point = ElementOf<Row>;
  return mesh_of<detail::vec_dimension<Point>, typename Point::value_type>(span_of(vertices), faces, kind);
}

/// The overload for a contiguous range of points if the dimension is given: mesh_of<3>(vertices, faces).
template <Dim N, PointRowIn<N> Row>
auto mesh_of(const Row& vertices, std::span<const std::array<std::uint32_t, 3>> faces,
             MeshKind kind = MeshKind::surface) {
  return mesh_of(vertices, faces, kind);
}

/// The same faces with other vertices, one for each of `vertices()`: faster than `mesh_of`, because the tree behind the
/// queries is adapted. It is built anew if the faces have moved so far apart that it would be slow. Throws
/// std::invalid_argument if the number of vertices is another one or a coordinate is not finite.
template <Dim N, class T>
Mesh<N, T> moved(const Mesh<N, T>& mesh, std::type_identity_t<std::span<const Vec<N, T>>> vertices) {
  using Data = detail::MeshData<N, T>;
  const Data& before = *detail::placed(mesh).data();
  if (vertices.size() != before.vertices().size()) {
    GRAZE_THROW(std::invalid_argument("moved: the mesh has " + std::to_string(before.vertices().size()) +
                                      " vertices, but " + std::to_string(vertices.size()) + " are given"));
  }
  detail::check_vertices<N, T>("moved", vertices);
  return Mesh<N, T>(std::make_shared<const Data>(before, std::vector<Vec<N, T>>(vertices.begin(), vertices.end())));
}

/// The image of a mesh; it shares the triangles. Each coordinate of a vertex is calculated in double and rounded to T
/// once, so faces that share a vertex still do. Of a mesh that was moved before, the poses are multiplied. Throws
/// std::invalid_argument if a coordinate of a face is not finite.
template <Dim N, class T>
Mesh<N, T> transformed(const Mesh<N, T>& mesh, const Pose<N, T>& pose) {
  const auto& before = detail::placed(mesh);
  const Pose<N, T> both{rotated<N, T>(before.pose().rotation, pose), transformed<N, T>(before.pose().position, pose)};
  bool is_ok = is_finite(both.position);
  for (Dim j = 0; j < N; ++j) is_ok = is_ok && is_finite(both.rotation[j]);
  auto placed = std::make_shared<const detail::PlacedMesh<N, T>>(before.data(), both);
  if (!is_ok || !placed->is_finite()) {
    GRAZE_THROW(std::invalid_argument("transformed: a vertex has a coordinate that is not finite"));
  }
  return Mesh<N, T>(std::move(placed));
}

/// Always empty: `mesh_of` refuses what is not valid.
template <Dim N, class T>
std::string_view defect(const Mesh<N, T>& /*mesh*/) {
  return {};
}

}  // namespace graze
