// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/edges.hpp>
#include <graze/shape/hull/flat_points.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/input.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/quickhull.hpp>
#include <graze/shape/hull/undecided_points.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/polytope.hpp>

namespace graze {

/// One side of an edge, from `origin` to the origin of `next`, counter-clockwise around its face as seen from outside.
/// All members are indices into the lists of a ConvexMesh.
struct HalfEdge {
  std::uint32_t origin = 0;  ///< Start, in `vertices`.
  std::uint32_t twin = 0;    ///< The opposite half-edge, in `half_edges`; it belongs to the neighbouring face.
  std::uint32_t next = 0;    ///< The following half-edge of the same face, in `half_edges`.
  std::uint32_t face = 0;    ///< In `faces`.

  /// True if all four indices are equal.
  bool operator==(const HalfEdge&) const = default;
};

/// The surface of a 3D convex polytope: corners, edges and faces with their neighbours. Made by `convex_mesh`. Faces
/// are polygons of any number of corners: coplanar triangles, which is decided exactly, form one face.
template <class T = float>
struct ConvexMesh {
  std::vector<Vec<3, T>> vertices;   ///< In lexicographic order, as in `convex_hull`.
  std::vector<HalfEdge> half_edges;  ///< Face by face, each face from its least vertex on.
  /// The first half-edge of each face; sorted by its origin, then by the next one's.
  std::vector<std::uint32_t> faces;
};

namespace detail {

/// Builds the mesh of a hull that is not flat.
template <class T>
class MeshMaker {
 public:
  MeshMaker(const Quickhull<T>& hull, std::span<const Vec<3, T>> points)
      : hull_(hull),
        points_(points),
        are_bent_(bent_edges(hull)),
        are_vertices_(detail::are_vertices(hull, are_bent_)) {}

  ConvexMesh<T> mesh() {
    ConvexMesh<T> mesh;
    mesh.vertices = number_vertices();
    find_rings();
    place_of_edge_.assign(are_bent_.size(), 0);
    for (const Ring& ring : rings_) {
      const auto face = static_cast<std::uint32_t>(mesh.faces.size());
      const auto first = static_cast<std::uint32_t>(mesh.half_edges.size());
      mesh.faces.push_back(first);
      for (std::uint32_t i = 0; i < ring.size; ++i) {
        const std::uint32_t edge = ring_edges_[ring.first + (ring.start + i) % ring.size];
        place_of_edge_[edge] = first + i;
        mesh.half_edges.push_back({number_of(edge), edge, first + (i + 1) % ring.size, face});
      }
    }
    // Up to here `twin` holds the triangle edge with which each one begins.
    for (HalfEdge& edge : mesh.half_edges) edge.twin = place_of_edge_[beginning_of_twin(edge.twin)];
    return mesh;
  }

 private:
  /// The edges of a face, from `first` on in ring_edges_, the one from its least vertex at `start`.
  struct Ring {
    std::uint32_t least;
    std::uint32_t second;
    std::uint32_t first;
    std::uint32_t size;
    std::uint32_t start;
  };

  std::uint32_t number_of(std::uint32_t edge) const { return numbers_[hull_.origin(edge)]; }

  std::vector<Vec<3, T>> number_vertices() {
    std::vector<std::uint32_t> order;
    for (std::uint32_t corner = 0; corner < are_vertices_.size(); ++corner) {
      if (are_vertices_[corner]) order.push_back(corner);
    }
    const auto point = [&](std::uint32_t corner) { return points_[hull_.corners()[corner].index]; };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return lexicographically_less<3, T>(point(a), point(b)); });
    numbers_.assign(are_vertices_.size(), 0);
    std::vector<Vec<3, T>> vertices;
    vertices.reserve(order.size());
    for (const std::uint32_t corner : order) {
      numbers_[corner] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(point(corner));
    }
    return vertices;
  }

  /// The next bent edge around a flat part of the surface.
  std::uint32_t following(std::uint32_t edge) const {
    edge = Quickhull<T>::next(edge);
    while (!are_bent_[edge]) edge = Quickhull<T>::next(hull_.twin(edge));
    return edge;
  }

  /// An edge of the polytope may consist of several collinear triangle edges: returns the twin side's first, given the
  /// first of this side.
  std::uint32_t beginning_of_twin(std::uint32_t edge) const {
    std::uint32_t after = following(edge);
    while (!are_vertices_[hull_.origin(after)]) {
      edge = after;
      after = following(edge);
    }
    return hull_.twin(edge);
  }

  void find_rings() {
    std::vector<bool> is_done(are_bent_.size(), false);
    for (std::uint32_t edge = 0; edge < are_bent_.size(); ++edge) {
      if (!are_bent_[edge] || is_done[edge]) continue;
      Ring ring{std::numeric_limits<std::uint32_t>::max(), 0, static_cast<std::uint32_t>(ring_edges_.size()), 0, 0};
      std::uint32_t current = edge;
      do {
        is_done[current] = true;
        if (are_vertices_[hull_.origin(current)]) {
          if (number_of(current) < ring.least) {
            ring.least = number_of(current);
            ring.start = ring.size;
          }
          ring_edges_.push_back(current);
          ++ring.size;
        }
        current = following(current);
      } while (current != edge);
      ring.second = number_of(ring_edges_[ring.first + (ring.start + 1) % ring.size]);
      rings_.push_back(ring);
    }
    std::sort(rings_.begin(), rings_.end(), [](const Ring& a, const Ring& b) {
      return a.least != b.least ? a.least < b.least : a.second < b.second;
    });
  }

  const Quickhull<T>& hull_;
  std::span<const Vec<3, T>> points_;
  std::vector<bool> are_bent_;
  std::vector<bool> are_vertices_;
  std::vector<std::uint32_t> numbers_;  // of vertices, by corner
  std::vector<Ring> rings_;
  std::vector<std::uint32_t> ring_edges_;
  std::vector<std::uint32_t> place_of_edge_;
};

/// The two faces of a polygon whose corners are given in order, or the mesh without faces of fewer than three corners.
template <class T>
ConvexMesh<T> flat_mesh(std::vector<Vec<3, T>> polygon) {
  const auto count = static_cast<std::uint32_t>(polygon.size());
  ConvexMesh<T> mesh;
  mesh.vertices = polygon;
  std::sort(mesh.vertices.begin(), mesh.vertices.end(), lexicographically_less<3, T>);
  if (count < 3) return mesh;
  std::rotate(polygon.begin(), std::find(polygon.begin(), polygon.end(), mesh.vertices.front()), polygon.end());
  if (lexicographically_less<3, T>(polygon.back(), polygon[1])) std::reverse(polygon.begin() + 1, polygon.end());
  std::vector<std::uint32_t> numbers;
  for (const Vec<3, T>& corner : polygon) {
    const auto place =
        std::lower_bound(mesh.vertices.begin(), mesh.vertices.end(), corner, lexicographically_less<3, T>);
    numbers.push_back(static_cast<std::uint32_t>(place - mesh.vertices.begin()));
  }
  // The second face has the corners 0, count - 1, ..., 1.
  mesh.faces = {0, count};
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.half_edges.push_back({numbers[i], 2 * count - 1 - i, (i + 1) % count, 0});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.half_edges.push_back({numbers[(count - i) % count], count - 1 - i, count + (i + 1) % count, 1});
  }
  return mesh;
}

}  // namespace detail

/// The surface of the convex hull of points, as half-edges. Coplanar points give two faces, one for each side of the
/// polygon around them; collinear points give no faces and their two ends, or one vertex, as vertices. The mesh does
/// not depend on the order of the points. Exactness and errors are those of `convex_hull`, which is cheaper.
template <class T>
ConvexMesh<T> convex_mesh(std::type_identity_t<std::span<const Vec<3, T>>> points) {
  detail::check_hull_points<3, T>("convex_mesh", points);
  const detail::HullFrame<T> frame(points);
  const detail::Quickhull<T> hull = detail::hull_of(frame);
  if (hull.base().size() == 4) return detail::MeshMaker<T>(hull, points).mesh();
  std::vector<Vec<3, T>> polygon;
  for (const std::uint32_t vertex : detail::flat_vertices(hull)) polygon.push_back(points[vertex]);
  return detail::flat_mesh(std::move(polygon));
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto convex_mesh(const Row& points) {
  return convex_mesh<typename ElementOf<Row>::value_type>(span_of(points));
}

/// The surface of a polytope. Equals the mesh of its vertices, so the mesh's vertices are in lexicographic order, which
/// may differ from the polytope's.
template <class T>
ConvexMesh<T> convex_mesh(const Polytope<3, T>& polytope) {
  return convex_mesh<T>(polytope.vertices());
}

/// The plane of a face, with an outward normal of length 1. Its error is a few epsilon of double times the ratio of the
/// face's length to its width. Nothing overflows or underflows except what exceeds the range of double.
template <class T>
Plane<3, double> face_plane(const ConvexMesh<T>& mesh, std::size_t face) {
  const std::uint32_t first = mesh.faces[face];
  const auto corner = [&](std::uint32_t edge) { return wide<3, T>(mesh.vertices[mesh.half_edges[edge].origin]); };
  const auto next = [&](std::uint32_t edge) { return mesh.half_edges[edge].next; };
  const Vec<3, double> start = corner(first);
  double size = 0;
  for (std::uint32_t edge = next(first); edge != first; edge = next(edge)) {
    size = std::max(size, max_abs(corner(edge) - start));
  }
  const double to_units = std::ldexp(1.0, -std::ilogb(size));  // corners are distinct, so not zero
  const auto way = [&](std::uint32_t edge) { return (corner(edge) - start) * to_units; };
  // Sums the triangles of a fan: their normals point the same way, so nothing cancels.
  Vec<3, double> sum(0.0);
  for (std::uint32_t edge = next(first); next(edge) != first; edge = next(edge)) {
    sum += accurate_cross(way(edge), way(next(edge)));
  }
  const Vec<3, double> normal = unit_plane(Plane<3, double>{sum, 0}).normal;
  return {normal, dot(normal, start)};
}

}  // namespace graze
