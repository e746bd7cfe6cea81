// SPDX-License-Identifier: MIT
// What a mesh holds: the triangles, which all its copies share, and the place at which they are seen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/mesh/components.hpp>
#include <graze/shape/mesh/open_edges.hpp>
#include <graze/shape/parts/grown_box.hpp>
#include <graze/shape/parts/part_tree.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

/// Which points belong to a mesh.
enum class MeshKind {
  surface,  ///< Those of its closed faces.
  solid,    ///< Those of its closed faces, and all with a winding number above 1/2.
};

/// The names of the kinds in their order, as scene files write them.
inline constexpr std::array<std::string_view, 2> mesh_kind_names = {"surface", "solid"};

namespace detail {

/// The vertices and faces in their own coordinates, and a tree of the faces' grown boxes. Never changes.
template <Dim N, class T>
class MeshData {
 public:
  using Faces = std::vector<std::array<std::uint32_t, 3>>;

  MeshData(std::vector<Vec<N, T>> vertices, Faces faces, MeshKind kind)
      : vertices_(std::move(vertices)), faces_(std::move(faces)), kind_(kind), tree_(boxes_of_faces(), whole(), true) {}

  /// The same faces with other vertices: the tree keeps its order unless its boxes have grown too much.
  MeshData(const MeshData& before, std::vector<Vec<N, T>> vertices)
      : vertices_(std::move(vertices)),
        faces_(before.faces_),
        kind_(before.kind_),
        tree_(before.tree_.refitted(boxes_of_faces(), whole(), true)) {}

  const std::vector<Vec<N, T>>& vertices() const { return vertices_; }
  const Faces& faces() const { return faces_; }
  MeshKind kind() const { return kind_; }
  const PartTree<N, T>& tree() const { return tree_; }
  /// The box around all faces; unused vertices do not count.
  const Aabb<N, T>& box() const { return tree_.bounds(); }

  Triangle<N, T> triangle(std::size_t face) const {
    const std::array<std::uint32_t, 3>& corners = faces_[face];
    return {vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]};
  }

  /// Calculated by the first call, because only the winding numbers of meshes with holes need them.
  const std::vector<OpenEdge>& open_edges() const {
    std::call_once(open_edges_once_, [this] { open_edges_ = open_edges_of(faces_); });
    return open_edges_;
  }

  /// One vertex of each component; likewise.
  const std::vector<std::uint32_t>& vertices_of_components() const {
    std::call_once(components_once_,
                   [this] { components_ = detail::vertices_of_components(faces_, vertices_.size()); });
    return components_;
  }

 private:
  Aabb<N, T> box_of_face(std::size_t face) const {
    Aabb<N, T> box = Aabb<N, T>::nothing();
    for (const std::uint32_t vertex : faces_[face]) box.grow(vertices_[vertex]);
    return box;
  }
  std::vector<Aabb<N, T>> boxes_of_faces() const {
    std::vector<Aabb<N, T>> boxes(faces_.size());
    for (std::size_t face = 0; face < boxes.size(); ++face) {
      boxes[face] = box_of_face(face);
      grow_for_touching(boxes[face]);
    }
    return boxes;
  }
  Aabb<N, T> whole() const {
    Aabb<N, T> box = Aabb<N, T>::nothing();
    for (std::size_t face = 0; face < faces_.size(); ++face) box.grow(box_of_face(face));
    return box;
  }

  std::vector<Vec<N, T>> vertices_;
  Faces faces_;
  MeshKind kind_;
  PartTree<N, T> tree_;
  mutable std::once_flag open_edges_once_;
  mutable std::vector<OpenEdge> open_edges_;
  mutable std::once_flag components_once_;
  mutable std::vector<std::uint32_t> components_;
};

/// A mesh at a place. Moving it makes another one of these; the triangles stay where they are.
template <Dim N, class T>
class PlacedMesh {
 public:
  explicit PlacedMesh(std::shared_ptr<const MeshData<N, T>> data) : data_(std::move(data)), box_(data_->box()) {}

  PlacedMesh(std::shared_ptr<const MeshData<N, T>> data, const Pose<N, T>& pose)
      : data_(std::move(data)), pose_(pose), is_moved_(true), largest_(max_abs(wide<N, T>(pose.position))) {
    for (Dim i = 0; i < N; ++i) {
      box_.min[i] = -extreme(i, -1);
      box_.max[i] = extreme(i, 1);
    }
  }

  const std::shared_ptr<const MeshData<N, T>>& data() const { return data_; }
  const Pose<N, T>& pose() const { return pose_; }
  bool is_moved() const { return is_moved_; }
  /// The least box around all faces.
  const Aabb<N, T>& box() const { return box_; }

  Vec<N, T> vertex(std::size_t index) const { return moved(data_->vertices()[index]); }

  Triangle<N, T> triangle(std::size_t face) const {
    const Triangle<N, T> triangle = data_->triangle(face);
    return {moved(triangle.a), moved(triangle.b), moved(triangle.c)};
  }

  /// At this place; calculated by the first call.
  std::span<const Vec<N, T>> vertices() const {
    if (!is_moved_) return data_->vertices();
    std::call_once(vertices_once_, [this] {
      vertices_.reserve(data_->vertices().size());
      for (const Vec<N, T>& vertex : data_->vertices()) vertices_.push_back(moved(vertex));
    });
    return vertices_;
  }

  /// A box that contains, at this place, all that a box of the tree contains, grown likewise.
  Aabb<N, T> at_place(const Aabb<N, T>& box) const {
    if (!is_moved_) return box;
    const Vec<N, double> low = wide<N, T>(box.min);
    const Vec<N, double> high = wide<N, T>(box.max);
    const Vec<N, double> center = 0.5 * low + 0.5 * high;
    const Vec<N, double> reach = 0.5 * high - 0.5 * low;
    const Mat<N, double> rotation = wide_matrix<N, T>(pose_.rotation);
    const Vec<N, double> middle = rotation * center + wide<N, T>(pose_.position);
    const double slack = tolerance::box_slack * (N * (max_abs(center) + max_abs(reach)) + largest_);
    Aabb<N, T> result;
    for (Dim i = 0; i < N; ++i) {
      double size = slack;
      for (Dim j = 0; j < N; ++j) size += std::fabs(rotation[j][i]) * reach[j];
      result.min[i] = round_down<T>(middle[i] - size);
      result.max[i] = round_up<T>(middle[i] + size);
    }
    grow_for_touching(result);
    return result;
  }

 private:
  Vec<N, T> moved(const Vec<N, T>& vertex) const { return is_moved_ ? transformed<N, T>(vertex, pose_) : vertex; }

  /// The greatest coordinate of a used vertex, times `sign`; -infinity without faces.
  T extreme(Dim axis, T sign) const {
    T best = -std::numeric_limits<T>::infinity();
    const auto visit = [&](std::uint32_t face) {
      for (const Vec<N, T>& corner : triangle(face).vertices()) best = std::max(best, sign * corner[axis]);
      return true;
    };
    for (const std::uint32_t face : data_->tree().unbounded()) visit(face);
    const auto most = [&](const Aabb<N, T>& box) {
      const Aabb<N, T> placed = at_place(box);
      return std::max(sign * placed.min[axis], sign * placed.max[axis]);
    };
    data_->tree().visit([&](const Aabb<N, T>& box) { return most(box) > best; },
                        [&](const Aabb<N, T>& box) { return -static_cast<double>(most(box)); }, visit);
    return best;
  }

  std::shared_ptr<const MeshData<N, T>> data_;
  Pose<N, T> pose_{};
  bool is_moved_ = false;
  double largest_ = 0;  ///< Coordinate of the pose's position.
  Aabb<N, T> box_;
  mutable std::once_flag vertices_once_;
  mutable std::vector<Vec<N, T>> vertices_;
};

/// Calls visit(face of a, face of b) until it returns false, for all pairs of faces whose grown boxes overlap. Returns
/// whether all were visited.
template <Dim N, class T, class Visit>
bool visit_near_faces(const PlacedMesh<N, T>& a, const PlacedMesh<N, T>& b, const Visit& visit) {
  const auto may_touch = [&](const Aabb<N, T>& box_a, const Aabb<N, T>& box_b) {
    return boxes_overlap(a.at_place(box_a), b.at_place(box_b));
  };
  return a.data()->tree().visit_pairs(b.data()->tree(), may_touch, visit);
}

/// The same for pairs of two different faces of one mesh, each once and in any order.
template <Dim N, class T, class Visit>
bool visit_near_faces(const PlacedMesh<N, T>& mesh, const Visit& visit) {
  const auto may_touch = [&mesh](const Aabb<N, T>& a, const Aabb<N, T>& b) {
    return boxes_overlap(mesh.at_place(a), mesh.at_place(b));  // where rounding may have closed a gap
  };
  return mesh.data()->tree().visit_own_pairs(may_touch, visit);
}

}  // namespace detail
}  // namespace graze
