// SPDX-License-Identifier: MIT
// The contact points of two touching cores, given the direction from one to the other: points, segments, boxes and
// triangles in double, see features.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

// ---- foremost_feature(core, direction, margin)

/// The highest feature of a core along a direction, if everything else is lower by more than a margin.
template <Dim N>
struct ForemostFeature {
  std::array<Vec<N, double>, 2> corners;
  int count = 0;  ///< 1 for a corner, 2 for an edge; 0 if it is more, or uncertain.
};

template <Dim N>
ForemostFeature<N> foremost_feature(const Segment<N, double>& segment, const Vec<N, double>& direction, double margin) {
  const double ahead = dot(direction, segment.end - segment.start);
  if (ahead > margin) return {{segment.end}, 1};
  if (-ahead > margin) return {{segment.start}, 1};
  return {{segment.start, segment.end}, 2};
}

template <Dim N>
ForemostFeature<N> foremost_feature(const Triangle<N, double>& triangle, const Vec<N, double>& direction,
                                    double margin) {
  const std::array<Vec<N, double>, 3> corners = triangle.vertices();
  const std::array<double, 3> heights = {dot(direction, corners[0]), dot(direction, corners[1]),
                                         dot(direction, corners[2])};
  std::size_t first = heights[1] > heights[0] ? 1 : 0;
  if (heights[2] > heights[first]) first = 2;
  ForemostFeature<N> feature;
  feature.corners[0] = corners[first];
  feature.count = 1;
  for (const std::size_t other : {(first + 1) % 3, (first + 2) % 3}) {
    if (heights[first] - heights[other] > margin) continue;
    if (feature.count == 2) return {};
    feature.corners[1] = corners[other];
    feature.count = 2;
  }
  return feature;
}

template <Dim N>
ForemostFeature<N> foremost_feature(const BoxFrame<N>& box, const Vec<N, double>& direction, double margin) {
  ForemostFeature<N> feature{{box.center, box.center}, 1};
  for (Dim i = 0; i < N; ++i) {
    const Vec<N, double>& half_edge = box.half_edges[i];
    const double ahead = dot(direction, half_edge);
    if (!(2 * std::fabs(ahead) > margin)) {
      if (feature.count == 2) return {};
      feature.count = 2;
      feature.corners[0] -= half_edge;
      feature.corners[1] += half_edge;
    } else {
      for (Vec<N, double>& corner : feature.corners) corner += ahead > 0 ? half_edge : -half_edge;
    }
  }
  return feature;
}

/// For two 3D edges that are not nearly parallel.
inline ClosestPair<3> closest_of_crossing(const Segment<3, double>& a, const Segment<3, double>& b) {
  constexpr double least_squared_sine = 1.0 / 64;
  ClosestPair<3> best;
  const Vec<3, double> along_a = of_unit_size(a.end - a.start);
  const Vec<3, double> along_b = of_unit_size(b.end - b.start);
  const Vec<3, double> across = cross(along_a, along_b);
  if (dot(across, across) > least_squared_sine * dot(along_a, along_a) * dot(along_b, along_b)) {
    offer_perpendicular(a, b, best);
  }
  return best;
}

/// If one core has a corner, or each an edge, that alone is near the other.
template <HasEdges A, HasEdges B>
ClosestPair<dimension_of<A>> closest_of_foremost(const A& a, const B& b, const Vec<dimension_of<A>, double>& normal,
                                                 double margin) {
  constexpr Dim N = dimension_of<A>;
  ClosestPair<N> best;
  const ForemostFeature<N> of_b = foremost_feature(with_edges(b), -normal, margin);
  if (of_b.count == 1) {
    best.offer_from_b(of_b.corners[0], closest_on(a, of_b.corners[0]));
    return best;
  }
  const ForemostFeature<N> of_a = foremost_feature(with_edges(a), normal, margin);
  if (of_a.count == 1) {
    best.offer_from_a(of_a.corners[0], closest_on(b, of_a.corners[0]));
  } else if constexpr (N == 3) {
    if (of_a.count == 2 && of_b.count == 2) {
      best = closest_of_crossing({of_a.corners[0], of_a.corners[1]}, {of_b.corners[0], of_b.corners[1]});
    }
  }
  return best;
}

/// The points of two cores of which b just touches a, in the direction `normal` (unit vector). A point of a that is
/// below all of b by a distance is at least that far from b; so if points much nearer to each other are found, it need
/// not be tried.
template <class A, class B>
ClosestPair<dimension_of<A>> closest_of_touching(const A& a, const B& b, const Vec<dimension_of<A>, double>& normal,
                                                 double size) {
  if constexpr (HasEdges<A> && HasEdges<B>) {
    const double near = tolerance::coarse * size;
    const ClosestPair<dimension_of<A>> foremost = closest_of_foremost(a, b, normal, 4 * near);
    if (foremost.squared < near * near) return foremost;
    const FacingBand<dimension_of<A>> band{normal, span_along(normal, with_edges(b)).low - 2 * near,
                                           span_along(normal, with_edges(a)).high + 2 * near};
    const ClosestPair<dimension_of<A>> pair = closest_of_meeting(a, b, size, band);
    if (pair.squared < near * near) return pair;
  }
  return closest_of_meeting(a, b, size);
}

}  // namespace graze::detail
