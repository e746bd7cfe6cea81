// SPDX-License-Identifier: MIT
// The faces of two meshes that are nearest to each other, and the nearest points. Include closest_points.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/nearest_part.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/parts/inside.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh/placed_mesh.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/may_matter.hpp>
#include <graze/shape/parts/reach_lanes.hpp>
#include <graze/shape/parts/triangle_block.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// For `BoxTree::visit_nearest_pairs`: what may be as near as the nearest pair of faces so far. Of faces, the gap along
/// the directions between the last pairs decides, too: neighbours look at each other in similar directions.
template <Dim N, class T>
class MayBeNearestPair {
 public:
  MayBeNearestPair(const PlacedMesh<N, T>& a, const PlacedMesh<N, T>& b)
      : a_(a), b_(b), margin_(tolerance::box_slack * std::max(largest_of(a.box()), largest_of(b.box()))) {
    directions_.fill(Vec<N, double>(0.0));
  }

  const NearestPart<N>& best() const { return best_; }

  void add(const Proximity<N, double>& pair, std::uint64_t index) {
    best_.add(pair, index);
    Vec<N, double> way = pair.point_b - pair.point_a;
    const double size = max_abs(way);
    if (!(pair.distance > 0 && size > 0 && is_finite(way))) return;
    way /= size;
    way /= std::sqrt(dot(way, way));
    directions_[next_] = way;
    next_ = (next_ + 1) % directions_.size();
#ifdef GRAZE_HAS_LANES
    along_a_ = a_.along(way);
    along_b_ = b_.along(-way);
    constexpr T most_offset = std::numeric_limits<T>::max() / 2;  // so that no reach overflows
    has_direction_ = std::fabs(along_a_.offset) < most_offset && std::fabs(along_b_.offset) < most_offset;
#endif
  }

  bool admits(T squared) const { return !(squared > most()); }

  LaneMask lanes(const BoxBlock<N, T>& block, const Aabb<N, T>& box, Row<T>& squared) const {
    return squared_distances(block, box, most(), squared);
  }

#ifdef GRAZE_HAS_LANES
  /// Of sixteen faces of each mesh, those that are near enough to one of the others along the last direction.
  PairOfLanes lanes(const TriangleBlock<N, T>& block_a, const TriangleBlock<N, T>& block_b) const {
    if (!has_direction_) return {};
    const T most = round_up<T>(best_.nearest().distance + margin_);
    constexpr T lowest = std::numeric_limits<T>::lowest();
    alignas(64) Row<T> keys;
    lanes_beyond(block_b, along_b_, lowest, keys);
    const LaneMask lanes_a = lanes_beyond(block_a, along_a_, least_of(keys) - most, keys);
    if (lanes_a == 0) return {0, 0};
    return {lanes_a, lanes_beyond(block_b, along_b_, least_of(keys) - most, keys)};
  }
#endif

  /// Whether faces are farther apart along one of the directions.
  bool is_too_wide(const Triangle<N, T>& a, const Triangle<N, T>& b) const {
    const double most = best_.nearest().distance + margin_;
    return std::any_of(directions_.begin(), directions_.end(), [&](const Vec<N, double>& direction) {
      return -reach(b, -direction) - reach(a, direction) > most;
    });
  }

 private:
  T most() const { return most_squared<T>(best_.nearest().distance); }

  static double largest_of(const Aabb<N, T>& box) {
    return is_nothing(box) ? 0.0 : static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
  }

  /// How far a face reaches along a direction.
  static double reach(const Triangle<N, T>& face, const Vec<N, double>& direction) {
    return std::max(
        {dot(direction, wide<N, T>(face.a)), dot(direction, wide<N, T>(face.b)), dot(direction, wide<N, T>(face.c))});
  }

  const PlacedMesh<N, T>& a_;
  const PlacedMesh<N, T>& b_;
  NearestPart<N> best_;
  std::array<Vec<N, double>, 4> directions_;  // zero: none yet
  std::size_t next_ = 0;
  double margin_;
#ifdef GRAZE_HAS_LANES
  LaneDirection<N, T> along_a_;  // the last direction, and its opposite
  LaneDirection<N, T> along_b_;
  bool has_direction_ = false;
#endif
};

/// A pair of faces that are near to each other: looked for from one mesh to the other and back, from the nearest faces
/// of one to those of the other.
template <Dim N, class T>
std::optional<std::pair<std::size_t, std::size_t>> near_faces(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  constexpr int most_steps = 8;
  constexpr double least_gain = 0.01;
  const Vec<N, T> middle = placed(a).box().center();
  std::size_t face_a = DecidingPart::no_part;
  std::size_t face_b = DecidingPart::no_part;
  Vec<N, T> point = middle;
  double distance = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const DecidingPart on_b = deciding_part(b, point, face_b);
    if (on_b.index == DecidingPart::no_part) return std::nullopt;
    const Vec<N, T> point_b = closest_point_of(b.triangle(on_b.index), point);
    const DecidingPart on_a = deciding_part(a, point_b, face_a);
    if (on_a.index == DecidingPart::no_part) return std::nullopt;
    if (!(on_a.distance < (1 - least_gain) * distance)) break;
    face_a = on_a.index;
    face_b = on_b.index;
    distance = on_a.distance;
    point = closest_point_of(a.triangle(face_a), point_b);
  }
  if (face_a == DecidingPart::no_part) return std::nullopt;
  return std::pair{face_a, face_b};
}

/// The nearest pair of faces, of several that of the first face of `a`, then of `b`: by pair(face, face). The index is
/// that of the pair: the face of `a`, times the number of faces of `b`, plus that of `b`.
template <Dim N, class T, class PairOfFaces>
NearestPart<N> nearest_faces(const Mesh<N, T>& a, const Mesh<N, T>& b, const PairOfFaces& pair) {
  const PlacedMesh<N, T>& faces_a = placed(a);
  const PlacedMesh<N, T>& faces_b = placed(b);
  const auto& tree_a = faces_a.data()->tree();
  const auto& tree_b = faces_b.data()->tree();
  MayBeNearestPair<N, T> near(faces_a, faces_b);
  const auto index_of = [&b](std::size_t face_a, std::size_t face_b) {
    return std::uint64_t{face_a} * b.faces().size() + face_b;
  };
  const auto add = [&](std::size_t face_a, std::size_t face_b) {
    near.add(pair(faces_a.triangle(face_a), faces_b.triangle(face_b)), index_of(face_a, face_b));
    return true;
  };
  if (const auto first = near_faces(a, b)) add(first->first, first->second);
  tree_a.visit_unbounded_pairs(tree_b, add);
  const auto visit = [&](std::size_t place_a, std::size_t place_b) {
    const std::uint64_t index = index_of(tree_a.part_at(place_a), tree_b.part_at(place_b));
    if (near.best().is_decided_before(index)) return;
    const Triangle<N, T> face_a = faces_a.triangle_in_tree(place_a);
    const Triangle<N, T> face_b = faces_b.triangle_in_tree(place_b);
    if (!near.is_too_wide(face_a, face_b)) near.add(pair(face_a, face_b), index);
  };
  tree_a.visit_nearest_pairs(tree_b, BoxesAtPlace<N, T>{faces_a}, BoxesAtPlace<N, T>{faces_b}, near, visit);
  return near.best();
}

/// A point of the first of so many faces of a mesh that is inside a solid, if none of them touches its faces.
template <Dim N, class T>
std::optional<Vec<N, T>> point_of_face_inside(const Mesh<N, T>& solid, const Mesh<N, T>& mesh, std::size_t count) {
  for (std::size_t face = 0; face < count; ++face) {
    if (const auto point = point_inside(solid, mesh.triangle(face))) return point;
  }
  return std::nullopt;
}

/// For a shape that lies inside a solid mesh, with this point.
template <Dim N>
Proximity<N, double> proximity_inside(const Vec<N, double>& point) {
  Proximity<N, double> result;
  result.distance = 0;
  result.point_a = result.point_b = point;
  result.relation = Relation::overlapping;
  return result;
}

/// The nearest points of two meshes, those of nearest_faces unless one mesh has faces inside the other; nothing for one
/// that touches a solid, because some of its faces may be inside that do not touch it.
template <Dim N, class T, class PairOfFaces>
std::optional<Proximity<N, double>> proximity_of_meshes(const Mesh<N, T>& a, const Mesh<N, T>& b,
                                                        const PairOfFaces& pair) {
  const NearestPart<N> best = nearest_faces(a, b, pair);
  const bool is_solid = N == 3 && b.kind() == MeshKind::solid;
  const bool is_apart = best.nearest().relation == Relation::apart;
  if (best.nearest().relation == Relation::touching && is_solid) return std::nullopt;
  if (is_solid && (!is_apart || point_inside(b, a))) {
    const auto first = static_cast<std::size_t>(is_apart ? a.faces().size() : best.index() / b.faces().size());
    if (const auto point = point_of_face_inside(b, a, first)) return proximity_inside(wide<N, T>(*point));
  }
  if (is_apart) {
    if (const auto point = point_inside(a, b)) return proximity_inside(wide<N, T>(*point));
  }
  return best.nearest();
}

}  // namespace graze::detail
