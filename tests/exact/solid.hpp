// SPDX-License-Identifier: MIT
// The exact point sets of bounded shapes, as stored: the convex hull of corners, inflated by a radius.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/numbers.hpp"

namespace graze::test {

/// Coordinates are integers divided by powers of two. `edges` contains at least one vector along every edge of the
/// hull.
template <Dim N>
struct Solid {
  std::vector<RationalVec<N>> corners;
  std::vector<RationalVec<N>> edges;
  Rational radius = 0;
};

/// The convex hull of points; every difference of two may be an edge.
template <Dim N>
Solid<N> hull_of(std::vector<RationalVec<N>> corners, Rational radius = 0) {
  Solid<N> solid{std::move(corners), {}, std::move(radius)};
  for (std::size_t i = 0; i < solid.corners.size(); ++i) {
    for (std::size_t j = i + 1; j < solid.corners.size(); ++j) {
      solid.edges.push_back(solid.corners[j] - solid.corners[i]);
    }
  }
  return solid;
}

template <Dim N, class T>
Solid<N> solid(const Vec<N, T>& point) {
  return hull_of<N>({exact(point)});
}

template <Dim N, class T>
Solid<N> solid(const Segment<N, T>& segment) {
  return hull_of<N>({exact(segment.start), exact(segment.end)});
}

template <Dim N, class T>
Solid<N> solid(const Sphere<N, T>& sphere) {
  return hull_of<N>({exact(sphere.center)}, exact(static_cast<double>(sphere.radius)));
}

/// center + the sum of u[i] half_edges[i] with |u[i]| <= 1.
template <Dim N>
Solid<N> box_of(const RationalVec<N>& center,
                const std::array<RationalVec<N>, static_cast<std::size_t>(N)>& half_edges) {
  Solid<N> box;
  for (unsigned corner = 0; corner < 1U << N; ++corner) {
    RationalVec<N> place = center;
    for (std::size_t i = 0; i < N; ++i) place = (corner >> i & 1U) != 0 ? place + half_edges[i] : place - half_edges[i];
    box.corners.push_back(place);
  }
  box.edges.assign(half_edges.begin(), half_edges.end());
  return box;
}

template <Dim N, class T>
Solid<N> solid(const Aabb<N, T>& box) {
  const RationalVec<N> min = exact(box.min);
  const RationalVec<N> max = exact(box.max);
  std::array<RationalVec<N>, static_cast<std::size_t>(N)> half_edges;
  for (std::size_t i = 0; i < N; ++i) {
    half_edges[i].fill(0);
    half_edges[i][i] = (max[i] - min[i]) / 2;
  }
  return box_of<N>((min + max) * Rational(1, 2), half_edges);
}

template <Dim N, class T>
Solid<N> solid(const Obb<N, T>& box) {
  std::array<RationalVec<N>, static_cast<std::size_t>(N)> half_edges;
  for (Dim i = 0; i < N; ++i) {
    half_edges[static_cast<std::size_t>(i)] =
        exact<N, T>(box.axes[i]) * exact(static_cast<double>(box.half_extents[i]));
  }
  return box_of<N>(exact(box.center), half_edges);
}

template <Dim N, class T>
Solid<N> solid(const Triangle<N, T>& triangle) {
  return hull_of<N>({exact(triangle.a), exact(triangle.b), exact(triangle.c)});
}

template <Dim N, class T>
Solid<N> solid(const Capsule<N, T>& capsule) {
  return hull_of<N>({exact(capsule.a), exact(capsule.b)}, exact(static_cast<double>(capsule.radius)));
}

template <Dim N, class T>
Solid<N> solid(const Polytope<N, T>& polytope) {
  std::vector<RationalVec<N>> corners;
  for (const Vec<N, T>& vertex : polytope.vertices()) corners.push_back(exact(vertex));
  return hull_of<N>(std::move(corners));
}

}  // namespace graze::test
