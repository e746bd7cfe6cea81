// SPDX-License-Identifier: MIT
// Where the nodes of glTF place their meshes.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include <graze/io/gltf/root.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {

/// An affine map: x to linear * x + offset.
struct GltfTransform {
  Mat<3, double> linear = Mat<3, double>(1.0);
  Vec<3, double> offset = Vec<3, double>(0.0);

  /// First `inner`, then this.
  GltfTransform after(const GltfTransform& inner) const;
};

/// The `matrix` of a node, or its `translation`, `rotation` and `scale`; the identity without them. Throws InputError.
GltfTransform transform_of_node(const GltfItem& node);

/// Places meshes, and shares their triangles where it can.
class GltfPlacement {
 public:
  /// `most_copied`: the most vertices and faces of all scaled copies, because a small file could ask for any number.
  explicit GltfPlacement(std::size_t most_copied = 50'000'000) : most_copied_(most_copied) {}

  /// The image of a mesh. Moved and rotated images share its triangles; scaled ones share those of a scaled copy, if
  /// the scale is the same in all directions. Others have their own, except if the linear parts are equal. A mirrored
  /// image has turned faces, so that its outside stays outside. `mesh` must outlive this. Throws std::invalid_argument
  /// if a coordinate is not finite, std::length_error if the scaled copies have too many vertices and faces altogether.
  Mesh<3, double> placed(const Mesh<3, double>& mesh, const GltfTransform& transform);

 private:
  using Key = std::pair<const Mesh<3, double>*, std::array<double, 9>>;

  const Mesh<3, double>& copy(const Mesh<3, double>& mesh, const Mat<3, double>& linear);

  std::map<Key, Mesh<3, double>> copies_;
  std::size_t most_copied_;
  std::size_t copied_ = 0;
};

}  // namespace graze::io
