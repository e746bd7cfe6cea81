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
#include <graze/shape/parts/box_tree.hpp>
#include <graze/shape/parts/grown_box.hpp>
#include <graze/shape/parts/pieces.hpp>
#include <graze/shape/parts/reach_lanes.hpp>
#include <graze/shape/parts/triangle_block.hpp>
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

/// The faces, as the lowest level of a tree.
template <Dim N, class T>
class FaceLeaves {
 public:
  using Faces = std::vector<std::array<std::uint32_t, 3>>;

  template <class Executor>
  void set(const Executor& executor, std::span<const std::uint32_t> parts, const std::vector<Vec<N, T>>& vertices,
           const Faces& faces) {
    count_ = (parts.size() + row_length - 1) / row_length;
    blocks_.reset(new TriangleBlock<N, T>[count_]);  // not initialised, unlike by std::make_unique
    for_pieces(executor, count_ * row_length, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto& [a, b, c] = faces[parts[std::min(i, parts.size() - 1)]];
        blocks_[i / row_length].set(i % row_length, {vertices[a], vertices[b], vertices[c]});
      }
    });
  }

  Triangle<N, T> triangle(std::size_t place) const { return blocks_[place / row_length].triangle(place % row_length); }
  Aabb<N, T> box(std::size_t place) const { return grown_box_of(triangle(place)); }
  const BoxBlock<N, T>& block(std::size_t index, BoxBlock<N, T>& buffer) const {
    set_boxes_around(blocks_[index], buffer);
    return buffer;
  }
  const TriangleBlock<N, T>& contents(std::size_t index) const { return blocks_[index]; }

  /// The least box around all triangles.
  Aabb<N, T> box_around() const {
    return box_around_corners(std::span<const TriangleBlock<N, T>>(blocks_.get(), count_)).around();
  }

 private:
  std::unique_ptr<TriangleBlock<N, T>[]> blocks_;  // NOLINT(modernize-avoid-c-arrays)
  std::size_t count_ = 0;
};

/// The vertices and faces in their own coordinates, and a tree of the faces. Never changes.
template <Dim N, class T>
class MeshData {
 public:
  using Faces = std::vector<std::array<std::uint32_t, 3>>;
  using Tree = BoxTree<N, T, FaceLeaves<N, T>>;

  template <class Executor>
  MeshData(std::vector<Vec<N, T>> vertices, Faces faces, MeshKind kind, const Executor& executor)
      : vertices_(std::move(vertices)),
        faces_(std::make_shared<const Faces>(std::move(faces))),
        kind_(kind),
        tree_(new_tree(executor)) {
    set_box();
  }

  /// The same faces with other vertices: the tree keeps its order unless its boxes have grown too much.
  MeshData(const MeshData& before, std::vector<Vec<N, T>> vertices)
      : vertices_(std::move(vertices)),
        faces_(before.faces_),
        kind_(before.kind_),
        tree_(before.tree_.unbounded().empty() ? before.tree_.refitted(vertices_, *faces_) : new_tree(OneByOne())) {
    if (tree_.is_outgrown() || !tree_.is_moderate()) tree_ = new_tree(OneByOne());
    set_box();
  }

  const std::vector<Vec<N, T>>& vertices() const { return vertices_; }
  const Faces& faces() const { return *faces_; }
  MeshKind kind() const { return kind_; }
  const Tree& tree() const { return tree_; }
  /// The box around all faces; unused vertices do not count.
  const Aabb<N, T>& box() const { return box_; }

  Triangle<N, T> triangle(std::size_t face) const {
    const std::array<std::uint32_t, 3>& corners = faces()[face];
    return {vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]};
  }

  /// Calculated by the first call, because only the winding numbers of meshes with holes need them.
  const std::vector<OpenEdge>& open_edges() const {
    std::call_once(open_edges_once_, [this] { open_edges_ = open_edges_of(faces()); });
    return open_edges_;
  }

  /// One vertex of each component; likewise.
  const std::vector<std::uint32_t>& vertices_of_components() const {
    std::call_once(components_once_,
                   [this] { components_ = detail::vertices_of_components(faces(), vertices_.size()); });
    return components_;
  }

 private:
  template <class Executor>
  Tree new_tree(const Executor& executor) const {
    std::vector<Aabb<N, T>> boxes(faces().size());
    for_pieces(executor, boxes.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t face = first; face < last; ++face) boxes[face] = grown_box_of(triangle(face));
    });
    return Tree(executor, std::span<const Aabb<N, T>>(boxes), vertices_, faces());
  }

  void set_box() {
    box_ = tree_.leaves().box_around();
    for (const std::uint32_t face : tree_.unbounded()) {
      for (const Vec<N, T>& corner : triangle(face).vertices()) box_.grow(corner);
    }
  }

  std::vector<Vec<N, T>> vertices_;
  std::shared_ptr<const Faces> faces_;
  MeshKind kind_;
  Tree tree_;
  Aabb<N, T> box_ = Aabb<N, T>::nothing();
  mutable std::once_flag open_edges_once_;
  mutable std::vector<OpenEdge> open_edges_;
  mutable std::once_flag components_once_;
  mutable std::vector<std::uint32_t> components_;
};

/// A mesh at a place. Moving it makes another one of these; the triangles stay where they are.
template <Dim N, class T>
class PlacedMesh {
 public:
  explicit PlacedMesh(std::shared_ptr<const MeshData<N, T>> data) : data_(std::move(data)) { set_lane_place(); }

  PlacedMesh(std::shared_ptr<const MeshData<N, T>> data, const Pose<N, T>& pose)
      : data_(std::move(data)), pose_(pose), is_moved_(true), largest_(max_abs(wide<N, T>(pose.position))) {
    set_lane_place();
  }

  const std::shared_ptr<const MeshData<N, T>>& data() const { return data_; }
  const Pose<N, T>& pose() const { return pose_; }
  bool is_moved() const { return is_moved_; }
  /// The least box around all faces; at another place calculated by the first call.
  const Aabb<N, T>& box() const {
    if (!is_moved_) return data_->box();
    std::call_once(box_once_, [this] {
      for (Dim i = 0; i < N; ++i) {
        box_.min[i] = -extreme(i, -1);
        box_.max[i] = extreme(i, 1);
      }
    });
    return box_;
  }

  /// Whether all coordinates of faces are finite at this place.
  bool is_finite() const {
    const auto& tree = data_->tree();
    const auto is_finite_box = [](const Aabb<N, T>& box) {
      return graze::is_finite(box.min) && graze::is_finite(box.max);
    };
    if (tree.unbounded().empty() && is_finite_box(at_place(tree.around()))) return true;
    return data_->faces().empty() || is_finite_box(box());
  }

  Vec<N, T> vertex(std::size_t index) const { return moved(data_->vertices()[index]); }

  Triangle<N, T> triangle(std::size_t face) const { return moved(data_->triangle(face)); }
  /// The same by the place of a face in the tree, which is faster for faces that the tree visits.
  Triangle<N, T> triangle_in_tree(std::size_t place) const { return moved(data_->tree().leaves().triangle(place)); }

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

  /// The same for sixteen boxes, which may be slightly larger: `block` itself, or those in `placed`.
  const BoxBlock<N, T>& at_place(const BoxBlock<N, T>& block, BoxBlock<N, T>& placed) const {
    if (!is_moved_) return block;
#ifdef GRAZE_HAS_LANES
    place_lanes(block, lane_place_, placed);
#else
    for (std::size_t lane = 0; lane < row_length; ++lane) placed.set(lane, at_place(block.box(lane)));
#endif
    return placed;
  }

#ifdef GRAZE_HAS_LANES
  /// Sixteen faces at this place, each up to error_of_lanes() away: `block` itself, or those in `placed`.
  const TriangleBlock<N, T>& at_place(const TriangleBlock<N, T>& block, TriangleBlock<N, T>& placed) const {
    if (!is_moved_) return block;
    place_triangles(block, lane_place_, placed);
    return placed;
  }

  /// How far faces reach along a direction at this place, or a little more.
  LaneDirection<N, T> along(const Vec<N, double>& direction) const {
    Vec<N, double> own = direction;
    double offset = sum_abs(direction) * static_cast<double>(lane_place_.slack);
    if (is_moved_) {
      for (Dim j = 0; j < N; ++j) own[j] = dot(direction, wide<N, T>(pose_.rotation[j]));
      offset += dot(direction, wide<N, T>(pose_.position));
    }
    return lane_direction(Vec<N, T>(own), round_up<T>(offset));
  }
#endif
  double error_of_lanes() const {
#ifdef GRAZE_HAS_LANES
    if (is_moved_) return static_cast<double>(lane_place_.slack);
#endif
    return 0;
  }

 private:
  void set_lane_place() {
#ifdef GRAZE_HAS_LANES
    lane_place_ = lane_place<N, T>(pose_.rotation, pose_.position, data_->tree().around());
#endif
  }

  Vec<N, T> moved(const Vec<N, T>& vertex) const { return is_moved_ ? transformed<N, T>(vertex, pose_) : vertex; }
  Triangle<N, T> moved(const Triangle<N, T>& face) const {
    return is_moved_ ? Triangle<N, T>{moved(face.a), moved(face.b), moved(face.c)} : face;
  }

  /// For the tree: boxes and faces that may reach beyond a coordinate, times `sign`; the farthest first.
  struct MayReach {
    double key(const Aabb<N, T>& box) const {
      const Aabb<N, T> placed = faces.at_place(box);
      return -static_cast<double>(std::max(sign * placed.min[axis], sign * placed.max[axis]));
    }
    bool admits(double key) const { return !(-key <= static_cast<double>(best)); }
    bool operator()(const Aabb<N, T>& box) const { return admits(key(box)); }
#ifdef GRAZE_HAS_LANES
    LaneMask lanes(const BoxBlock<N, T>& block, Row<T>& keys) const { return lanes_beyond(block, along, best, keys); }
    LaneMask lanes(const TriangleBlock<N, T>& block, Row<T>& keys) const {
      return lanes_beyond(block, along, best, keys);
    }

    LaneDirection<N, T> along;
#endif
    const PlacedMesh& faces;
    Dim axis;
    T sign;
    const T& best;
  };

  MayReach may_reach(Dim axis, T sign, const T& best) const {
#ifdef GRAZE_HAS_LANES
    return {along(static_cast<double>(sign) * unit_axis<N>(axis)), *this, axis, sign, best};
#else
    return {*this, axis, sign, best};
#endif
  }

  /// The greatest coordinate of a used vertex, times `sign`; -infinity without faces.
  T extreme(Dim axis, T sign) const {
    T best = -std::numeric_limits<T>::infinity();
    const auto visit = [&](const Triangle<N, T>& face) {
      for (const Vec<N, T>& corner : face.vertices()) best = std::max(best, sign * corner[axis]);
    };
    for (const std::uint32_t face : data_->tree().unbounded()) visit(triangle(face));
    data_->tree().visit(may_reach(axis, sign, best), ByKey(), [&](std::uint32_t /*face*/, std::size_t place) {
      visit(triangle_in_tree(place));
      return true;
    });
    return best;
  }

  std::shared_ptr<const MeshData<N, T>> data_;
  Pose<N, T> pose_{};
  bool is_moved_ = false;
  double largest_ = 0;  ///< Coordinate of the pose's position.
#ifdef GRAZE_HAS_LANES
  LanePlace<N, T> lane_place_;
#endif
  mutable std::once_flag box_once_;
  mutable Aabb<N, T> box_;
  mutable std::once_flag vertices_once_;
  mutable std::vector<Vec<N, T>> vertices_;
};

/// For the tree of a mesh: boxes and blocks at its place.
template <Dim N, class T>
struct BoxesAtPlace {
  Aabb<N, T> operator()(const Aabb<N, T>& box) const { return faces.at_place(box); }
  const BoxBlock<N, T>& operator()(const BoxBlock<N, T>& block, BoxBlock<N, T>& placed) const {
    return faces.at_place(block, placed);
  }

  const PlacedMesh<N, T>& faces;
};

/// Calls visit(face of a, face of b) until it returns false, for all pairs of faces whose grown boxes overlap. Returns
/// whether all were visited.
template <Dim N, class T, class Visit>
bool visit_near_faces(const PlacedMesh<N, T>& a, const PlacedMesh<N, T>& b, const Visit& visit) {
  return a.data()->tree().visit_pairs(b.data()->tree(), BoxesAtPlace<N, T>{a}, BoxesAtPlace<N, T>{b}, visit);
}

/// The same for pairs of two different faces of one mesh, each once and in any order; moved, because rounding may have
/// closed a gap.
template <Dim N, class T, class Visit>
bool visit_near_faces(const PlacedMesh<N, T>& mesh, const Visit& visit) {
  return mesh.data()->tree().visit_own_pairs(BoxesAtPlace<N, T>{mesh}, visit);
}

}  // namespace detail
}  // namespace graze
