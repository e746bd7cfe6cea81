// SPDX-License-Identifier: MIT
// The nearest points of two separate cores, and a common point of two that intersect. For disjoint polytopes, a corner
// of one and any point of the other are nearest, or, in 3D, interior points of two edges.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/cores/features.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// The nearest of the offered pairs of points; the first of several.
template <Dim N>
struct ClosestPair {
  Vec<N, double> on_a;
  Vec<N, double> on_b;
  Vec<N, double> between;  ///< From on_a to on_b: not their difference, but accurate relative to its own length.
  double squared = std::numeric_limits<double>::infinity();

  /// A point of a, and its projection to b.
  void offer_from_a(const Vec<N, double>& point, const ClosestOnCore<N>& closest) {
    offer({point, closest.point, -closest.off});
  }

  /// A point of b, and its projection to a.
  void offer_from_b(const Vec<N, double>& point, const ClosestOnCore<N>& closest) {
    offer({closest.point, point, closest.off});
  }

  void offer(const ClosestPair& other) {
    const double candidate = dot(other.between, other.between);
    if (!(candidate < squared)) return;
    *this = other;
    squared = candidate;
  }
};

/// Excludes points of one core: along the direction between the best pair so far, they are farther from the other core
/// than that pair's distance. Close to the nearest pair, this excludes all but its own corners.
template <class Other>
class TooFar {
 public:
  static constexpr Dim N = dimension_of<Other>;

  /// `side` is 1 for points of a and -1 for those of b; `size` is that of both cores.
  TooFar(const Other& other, double side, double size) : other_(with_edges(other)), side_(side), size_(size) {}

  bool operator()(const Vec<N, double>& point, const ClosestPair<N>& best) {
    if (!(best.squared < known_)) return low_ - dot(direction_, point) > limit_;
    known_ = best.squared;
    direction_ = best.between * side_;
    low_ = span_along(direction_, other_).low;
    limit_ = best.squared + tolerance::rounding * sum_abs(direction_) * size_;
    return low_ - dot(direction_, point) > limit_;
  }

 private:
  using Edged = std::decay_t<decltype(with_edges(std::declval<const Other&>()))>;

  Edged other_;
  double side_;
  double size_;
  double known_ = std::numeric_limits<double>::infinity();
  Vec<N, double> direction_ = Vec<N, double>(0.0);
  double low_ = 0;
  double limit_ = 0;
};

/// The points of two cores between which a pair may be nearest: those of a no lower than `floor` along a direction, and
/// those of b no higher than `ceiling`.
template <Dim N>
struct FacingBand {
  Vec<N, double> normal = Vec<N, double>(0.0);
  double floor = -std::numeric_limits<double>::infinity();
  double ceiling = std::numeric_limits<double>::infinity();

  bool reaches_a(const Vec<N, double>& point) const { return !(dot(normal, point) < floor); }
  bool reaches_b(const Vec<N, double>& point) const { return !(dot(normal, point) > ceiling); }
};

template <class A, class B>
void offer_corners(const A& a, const B& b, double size, const FacingBand<dimension_of<A>>& band,
                   ClosestPair<dimension_of<A>>& best) {
  if constexpr (!HasEdges<A>) {
    best.offer_from_a(a, closest_on(b, a));
  } else if constexpr (!HasEdges<B>) {
    best.offer_from_b(b, closest_on(a, b));
  } else {
    const auto& feet_a = with_feet(a);
    const auto& feet_b = with_feet(b);
    TooFar<B> is_too_far_of_a(b, 1, size);
    for (const auto& corner : corner_points(a)) {
      if (!band.reaches_a(corner) || is_too_far_of_a(corner, best)) continue;
      best.offer_from_a(corner, closest_on(feet_b, corner));
    }
    TooFar<A> is_too_far_of_b(a, -1, size);
    for (const auto& corner : corner_points(b)) {
      if (!band.reaches_b(corner) || is_too_far_of_b(corner, best)) continue;
      best.offer_from_b(corner, closest_on(feet_a, corner));
    }
  }
}

/// Alternates between the nearest points of both cores, which quickly approaches the nearest pair: not for its result,
/// but so that few corners and edges need to be tried.
template <class A, class B>
void offer_projections(const A& a, const B& b, ClosestPair<dimension_of<A>>& best) {
  constexpr int steps = 2;
  const auto& feet_a = with_feet(a);
  const auto& feet_b = with_feet(b);
  const auto corners = corner_points(a);
  Vec<dimension_of<A>, double> on_a(0.0);
  for (const auto& corner : corners) on_a += corner / static_cast<double>(corners.size());
  for (int step = 0; step < steps; ++step) {
    const Vec<dimension_of<A>, double> on_b = closest_on(feet_b, on_a).point;
    const ClosestOnCore<dimension_of<A>> closest = closest_on(feet_a, on_b);
    best.offer_from_b(on_b, closest);
    on_a = closest.point;
  }
}

// ---- Two 3D edges

/// Where along two segments, from 0 to 1, their lines are nearest to each other. With p(s) = start_a + s u, q(t) =
/// start_b + t v, w = start_b - start_a, n = u x v the perpendicular is at s n^2 = (w x v) . n, t n^2 = (w x u) . n.
template <Dim N>
class Perpendicular {
 public:
  Perpendicular(const Segment<N, double>& a, const Segment<N, double>& b)
      : u_(a.end - a.start), v_(b.end - b.start), w_(b.start - a.start) {
    const auto n = cross_of_edges(u_, v_);
    n0_ = of_unit_size(n);  // replaces one n, otherwise n^2 would leave the range of double
    whole_ = inner(n, n0_);
  }

  /// False if the segments are parallel, or points: then the positions are not valid.
  bool is_any() const { return whole_ > 0; }
  double on_a() const { return place(v_); }
  double on_b() const { return place(u_); }

 private:
  double place(const Vec<N, double>& other) const {
    return std::clamp(inner(accurate_cross(w_, other), n0_) / whole_, 0.0, 1.0);
  }

  Vec<N, double> u_;
  Vec<N, double> v_;
  Vec<N, double> w_;
  decltype(cross_of_edges(Vec<N, double>(), Vec<N, double>())) n0_;
  double whole_;
};

/// Both positions are rounded, the more so the more parallel the lines are, but the rounding is correlated: each one's
/// own projection to the other segment is used, and the nearer of the two. Where Eberly, "Robust computation of
/// distance between line segments" (2018), minimises by conjugate gradients, here the corners are offered as well, and
/// the best of these valid answers is accurate up to rounding.
template <Dim N>
void offer_perpendicular(const Segment<N, double>& a, const Segment<N, double>& b, ClosestPair<N>& best) {
  const Perpendicular<N> perpendicular(a, b);
  if (!perpendicular.is_any()) return;
  const Vec<N, double> on_a = a.start + (a.end - a.start) * perpendicular.on_a();
  const Vec<N, double> on_b = b.start + (b.end - b.start) * perpendicular.on_b();
  best.offer_from_a(on_a, closest_on(b, on_a));
  best.offer_from_b(on_b, closest_on(a, on_b));
}

/// The gap between two cores along the common normal of an edge of each.
struct NormalGap {
  Vec<3, double> from_a = Vec<3, double>(0.0);  ///< Perpendicular to both edges, of any length.
  double gap = -std::numeric_limits<double>::infinity();
};

/// None for edges that are parallel, or points.
template <class A, class B>
NormalGap gap_along_normal(const Vec<3, double>& edge_a, const Vec<3, double>& edge_b, const A& a, const B& b) {
  const Vec<3, double> normal = of_unit_size(cross_of_directions(edge_a, edge_b));
  const double squared = dot(normal, normal);
  if (!(squared > 0)) return {};
  const Span span_a = span_along(normal, a);
  const Span span_b = span_along(normal, b);
  const double ahead = span_b.low - span_a.high;
  const double behind = span_a.low - span_b.high;
  return {ahead >= behind ? normal : -normal, std::max(ahead, behind) / std::sqrt(squared)};
}

/// If interior points of two edges are nearest, both edges are the foremost ones along their common normal, and the gap
/// between the cores along it is the distance. No gap along any direction is larger: so only the largest matters, or
/// the few as large up to rounding. `size` is that of both cores.
template <class A, class B>
void offer_edges(const A& core_a, const B& core_b, double size, ClosestPair<3>& best) {
  const auto& a = with_edges(core_a);
  const auto& b = with_edges(core_b);
  const auto edges_a = edge_vectors(a);
  const auto edges_b = edge_vectors(b);
  std::array<std::array<NormalGap, std::tuple_size_v<decltype(edges_b)>>, std::tuple_size_v<decltype(edges_a)>> gaps;
  double largest = 0;
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      gaps[i][j] = gap_along_normal(edges_a[i], edges_b[j], a, b);
      largest = std::max(largest, gaps[i][j].gap);
    }
  }
  const double least = largest - tolerance::coarse * size;
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      if (!(gaps[i][j].gap >= least)) continue;
      visit_foremost_edges(a, i, gaps[i][j].from_a, [&](const Segment<3, double>& edge_a) {
        visit_foremost_edges(b, j, -gaps[i][j].from_a,
                             [&](const Segment<3, double>& edge_b) { offer_perpendicular(edge_a, edge_b, best); });
      });
    }
  }
}

/// The nearest points of two separate cores. `size` is a bound on the coordinates of both.
template <class A, class B>
ClosestPair<dimension_of<A>> closest_of_apart(const A& a, const B& b, double size) {
  ClosestPair<dimension_of<A>> best;
  if constexpr (HasEdges<A> && HasEdges<B> && (BoxCore<A> || BoxCore<B>)) offer_projections(a, b, best);
  offer_corners(a, b, size, {}, best);
  if constexpr (dimension_of<A> == 3 && HasEdges<A> && HasEdges<B>) offer_edges(a, b, size, best);
  return best;
}

/// AABBs, apart or not: coordinate by coordinate, in the middle of the common range.
template <Dim N>
ClosestPair<N> closest_of_boxes(const Aabb<N, double>& a, const Aabb<N, double>& b) {
  ClosestPair<N> pair;
  for (Dim i = 0; i < N; ++i) {
    const double low = std::max(a.min[i], b.min[i]);
    const double high = std::min(a.max[i], b.max[i]);
    const double middle = 0.5 * low + 0.5 * high;
    const bool is_gap = low > high;
    pair.on_a[i] = is_gap ? (a.max[i] < b.min[i] ? a.max[i] : a.min[i]) : middle;
    pair.on_b[i] = is_gap ? (a.max[i] < b.min[i] ? b.min[i] : b.max[i]) : middle;
  }
  pair.between = pair.on_b - pair.on_a;
  pair.squared = dot(pair.between, pair.between);
  return pair;
}

// ---- Intersecting cores: a corner of one in the other, or an edge of one through the other

/// A core in the form of visit_crossings.
template <class Core>
const Core& with_crossings(const Core& core) {
  return core;
}

/// A triangle with a normal of its plane.
struct CrossedTriangle {
  Triangle<3, double> triangle;
  Vec<3, double> normal;
};
inline CrossedTriangle with_crossings(const Triangle<3, double>& core) {
  return {core, of_unit_size(cross_of_directions(core.b - core.a, core.c - core.a))};
}

/// Calls `visit` with points of an edge, one of which is a point of the core if an interior point of the edge is one.
template <Dim N, class Visit>
void visit_crossings(const Segment<N, double>& edge, const Segment<N, double>& core, double, const Visit& visit) {
  const Perpendicular<N> perpendicular(edge, core);
  if (perpendicular.is_any()) visit(edge.start + (edge.end - edge.start) * perpendicular.on_a());
}

template <Dim N, class Visit>
void visit_crossings(const Segment<N, double>& edge, const Triangle<N, double>& core, double size, const Visit& visit) {
  visit_edges(core, [&](const Segment<N, double>& side) { visit_crossings(edge, side, size, visit); });
}

template <class Visit>
void visit_crossings(const Segment<3, double>& edge, const CrossedTriangle& core, double size, const Visit& visit) {
  visit_crossings(edge, core.triangle, size, visit);
  const Vec<3, double> way = edge.end - edge.start;
  const double climb = dot(core.normal, way);
  if (climb == 0) return;
  visit(edge.start + way * std::clamp(dot(core.normal, core.triangle.a - edge.start) / climb, 0.0, 1.0));
}

/// The parameters of an edge, from 0 to 1, that are between the faces of a box; none if low > high.
struct ShareRange {
  double low = 0;
  double high = 1;
};

/// Start and direction are given in coordinates of the box.
template <Dim N>
ShareRange range_between_faces(const Vec<N, double>& start, const Vec<N, double>& way,
                               const Vec<N, double>& half_extents) {
  ShareRange range;
  for (Dim i = 0; i < N; ++i) {
    if (way[i] == 0) continue;
    const double first = (-half_extents[i] - start[i]) / way[i];
    const double second = (half_extents[i] - start[i]) / way[i];
    range.low = std::max(range.low, std::min(first, second));
    range.high = std::min(range.high, std::max(first, second));
  }
  return range;
}

/// The rows map vectors to coordinates of the box. An edge that touches may seem to miss by a rounding error: then the
/// faces are moved out by as much.
template <Dim N, class Visit>
void visit_middle_inside(const Segment<N, double>& edge, const Mat<N, double>& rows, const Vec<N, double>& half_extents,
                         double slack, const Visit& visit) {
  const Vec<N, double> way = edge.end - edge.start;
  Vec<N, double> start_in_box;
  Vec<N, double> way_in_box;
  for (Dim i = 0; i < N; ++i) {
    start_in_box[i] = dot(rows[i], edge.start);
    way_in_box[i] = dot(rows[i], way);
  }
  ShareRange range = range_between_faces<N>(start_in_box, way_in_box, half_extents);
  if (range.low > range.high) range = range_between_faces<N>(start_in_box, way_in_box, half_extents + slack);
  if (range.low <= range.high) visit(edge.start + way * (0.5 * (range.low + range.high)));
}

template <Dim N>
Mat<N, double> face_normals_of(const Aabb<N, double>&) {
  return Mat<N, double>(1.0);
}
template <Dim N>
Mat<N, double> face_normals_of(const Obb<N, double>& box) {
  return face_normals(box.axes);
}
template <Dim N>
Vec<N, double> half_extents_of(const Aabb<N, double>& box) {
  return box.half_extents();
}
template <Dim N>
Vec<N, double> half_extents_of(const Obb<N, double>& box) {
  return box.half_extents;
}

/// A box with the rows that map vectors from its center to its coordinates.
template <Dim N>
struct CrossedBox {
  Vec<N, double> center;
  Vec<N, double> half_extents;
  Mat<N, double> rows;
};
template <BoxCore Box>
CrossedBox<dimension_of<Box>> with_crossings(const Box& box) {
  return {frame_of(box).center, half_extents_of(box), face_normals_of(box)};
}

template <Dim N, class Visit>
void visit_crossings(const Segment<N, double>& edge, const CrossedBox<N>& box, double size, const Visit& visit) {
  visit_middle_inside<N>({edge.start - box.center, edge.end - box.center}, box.rows, box.half_extents,
                         tolerance::coarse * size, [&](const Vec<N, double>& point) { visit(box.center + point); });
}

/// Offers points of edges of a core that may be points of the other, as `offer(point)`: those that are `reached`,
/// without repetition.
template <class Core, class Other, class Reached, class Offer>
void offer_crossings(const Core& core, const Other& other, double size, const Reached& reached, const Offer& offer) {
  using Point = Vec<dimension_of<Core>, double>;
  const auto& crossed = with_crossings(other);
  Point last(std::numeric_limits<double>::quiet_NaN());  // equals no point
  visit_edges(core, [&](const Segment<dimension_of<Core>, double>& edge) {
    if (!reached(edge.start) && !reached(edge.end)) return;
    visit_crossings(edge, crossed, size, [&](const Point& point) {
      if (point == last || !reached(point)) return;
      last = point;
      offer(point);
    });
  });
}

/// Within a band: an edge has a point in it only if an end is in it.
template <class A, class B>
ClosestPair<dimension_of<A>> closest_of_meeting(const A& a, const B& b, double size,
                                                const FacingBand<dimension_of<A>>& band) {
  using Point = Vec<dimension_of<A>, double>;
  ClosestPair<dimension_of<A>> best;
  offer_corners(a, b, size, band, best);
  if constexpr (HasEdges<A> && HasEdges<B>) {
    if (best.squared == 0) return best;
    const auto& feet_a = with_feet(a);
    const auto& feet_b = with_feet(b);
    offer_crossings(
        a, b, size, [&](const Point& point) { return band.reaches_a(point); },
        [&](const Point& point) { best.offer_from_a(point, closest_on(feet_b, point)); });
    offer_crossings(
        b, a, size, [&](const Point& point) { return band.reaches_b(point); },
        [&](const Point& point) { best.offer_from_b(point, closest_on(feet_a, point)); });
  }
  return best;
}

/// A common point of two intersecting cores: a pair of points as close to each other as rounding permits.
template <class A, class B>
ClosestPair<dimension_of<A>> closest_of_meeting(const A& a, const B& b, double size) {
  return closest_of_meeting(a, b, size, FacingBand<dimension_of<A>>{});
}

}  // namespace graze::detail
