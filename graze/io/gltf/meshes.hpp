// SPDX-License-Identifier: MIT
// The meshes of glTF, as they are before nodes place them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <graze/io/gltf/accessors.hpp>
#include <graze/io/gltf/root.hpp>
#include <graze/io/mesh_file.hpp>

namespace graze::io {

class GltfMeshes {
 public:
  /// Refers to all of them; what is not read is counted in `file`.
  GltfMeshes(const GltfRoot& root, GltfAccessors& accessors, MeshFile& file)
      : root_(root), accessors_(accessors), file_(file) {}

  /// The triangles of all primitives of a mesh, on the vertices that they use. Meshes that differ only by materials are
  /// the same. Throws InputError.
  const Mesh<3, double>& mesh(std::size_t index);

 private:
  /// What decides about the triangles of a primitive: the accessor of the points, one more than that of the indices (0:
  /// none), and the mode.
  using Primitive = std::tuple<std::size_t, std::size_t, std::size_t>;
  using Faces = std::vector<std::array<std::uint32_t, 3>>;

  std::vector<Primitive> primitives_of(const GltfItem& mesh);
  Faces faces_of(const Primitive& primitive, const JsonPlace& place);
  Mesh<3, double> built(const std::vector<Primitive>& primitives, const GltfItem& mesh);

  const GltfRoot& root_;
  GltfAccessors& accessors_;
  MeshFile& file_;
  std::map<std::size_t, const Mesh<3, double>*> by_index_;
  std::map<std::vector<Primitive>, Mesh<3, double>> by_primitives_;
  std::map<std::size_t, std::vector<std::uint32_t>> places_;  ///< For mesh_of_used, by accessor.
};

}  // namespace graze::io
