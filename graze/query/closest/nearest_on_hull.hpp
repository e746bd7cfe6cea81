// SPDX-License-Identifier: MIT
// The point of a convex shape nearest to one outside, calculated at the shape's own scale. GJK on differences (gjk.hpp)
// bounds the distance, but the differences of a small shape from a distant point agree in most of their digits, so the
// distinction between its corners is lost. Here corners are relative to one of them, and so is the point.
#pragma once

#include <algorithm>
#include <cstddef>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/gjk.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A point of the hull of corners, and the vector from it to the target.
template <Dim N>
struct NearPlace {
  Vec<N, double> place = Vec<N, double>(0.0);
  Vec<N, double> off = Vec<N, double>(0.0);
  Simplex<N> face;
};

/// The point of a simplex nearest to a target outside of it. Tries every corner, edge and triangle; which of two points
/// is nearer is decided by the vector between them, because the difference of their distances would be lost to
/// rounding.
template <Dim N>
class NearPlaceSearch {
 public:
  using Point = Vec<N, double>;

  NearPlaceSearch(const Simplex<N>& simplex, const Point& target) : simplex_(simplex), target_(target) {}

  NearPlace<N> run() {
    const std::size_t size = simplex_.size;
    for (std::size_t i = 0; i < size; ++i) {
      offer(simplex_.points[i], target_ - simplex_.points[i], {i});
      for (std::size_t j = i + 1; j < size; ++j) {
        try_edge(i, j);
        if constexpr (N == 3) {
          for (std::size_t k = j + 1; k < size; ++k) try_triangle(i, j, k);
        }
      }
    }
    return best_;
  }

  /// How much nearer a point is to the target than another: half the difference of the squared distances.
  static double nearer_by(const Point& place, const Point& off, const NearPlace<N>& other) {
    return dot(place - other.place, (off + other.off) * 0.5);
  }

 private:
  template <std::size_t Count>
  void offer(const Point& place, const Point& off, const std::size_t (&corners)[Count]) {
    if (best_.face.size > 0 && !(nearer_by(place, off, best_) > 0)) return;
    best_.place = place;
    best_.off = off;
    best_.face.size = 0;
    for (const std::size_t corner : corners) best_.face.push(simplex_.points[corner]);
  }

  void try_edge(std::size_t i, std::size_t j) {
    const Point& start = simplex_.points[i];
    const Point edge = simplex_.points[j] - start;
    const double along = dot(target_ - start, edge) / dot(edge, edge);
    if (along > 0 && along < 1) offer(start + edge * along, -closest_on_line(start - target_, edge), {i, j});
  }

  void try_triangle(std::size_t i, std::size_t j, std::size_t k) {
    const Point& start = simplex_.points[i];
    const Point to = target_ - start;
    const Point first = simplex_.points[j] - start;
    const Point second = simplex_.points[k] - start;
    const Point area = accurate_cross(first, second);
    const Point normal = of_moderate_size(area);
    const double area_squared = dot(normal, normal);
    if (!(area_squared > 0)) return;
    const double along_first = dot(accurate_cross(to, second), normal) / dot(area, normal);
    const double along_second = dot(accurate_cross(first, to), normal) / dot(area, normal);
    if (!(along_first > 0 && along_second > 0 && along_first + along_second < 1)) return;
    offer(start + first * along_first + second * along_second, normal * (dot(normal, to) / area_squared), {i, j, k});
  }

  const Simplex<N>& simplex_;
  const Point target_;
  NearPlace<N> best_;
};

/// The support point, relative to a point near the shape.
template <Convex S>
Vec<dimension_of<S>, double> support_from(const S& shape, const Vec<dimension_of<S>, double>& from,
                                          const Vec<dimension_of<S>, double>& direction) {
  return wide_support(shape, direction) - from;
}

/// Corners are compared by the vector between them, which may be much shorter than they are.
template <Dim N, class T>
Vec<N, double> support_from(const Polytope<N, T>& polytope, const Vec<N, double>& from,
                            const Vec<N, double>& direction) {
  Vec<N, double> farthest = wide<N, T>(polytope.vertices().front()) - from;
  for (const Vec<N, T>& vertex : polytope.vertices().subspan(1)) {
    const Vec<N, double> corner = wide<N, T>(vertex) - from;
    if (dot(corner - farthest, direction) > 0) farthest = corner;
  }
  return farthest;
}

/// The corner at a position, without rounding by the conversions.
template <Convex S>
Vec<dimension_of<S>, double> as_stored(const S&, const Vec<dimension_of<S>, double>& from,
                                       const Vec<dimension_of<S>, double>& place) {
  return from + place;
}

template <Dim N, class T>
Vec<N, double> as_stored(const Polytope<N, T>& polytope, const Vec<N, double>& from, const Vec<N, double>& place) {
  const auto is_there = [&](const Vec<N, T>& vertex) { return wide<N, T>(vertex) - from == place; };
  return wide<N, T>(*std::find_if(polytope.vertices().begin(), polytope.vertices().end(), is_there));
}

/// A point of a shape, and the vector from it to the query point.
template <Dim N>
struct NearestOnHull {
  Vec<N, double> point;
  Vec<N, double> off;
};

/// The nearest point for one outside, or on the surface up to rounding. Continues until no support point is nearer: for
/// a polytope, until the right face is found. A corner is returned as stored.
template <Convex S>
NearestOnHull<dimension_of<S>> nearest_on_hull(const S& shape, const Vec<dimension_of<S>, double>& p) {
  constexpr Dim N = dimension_of<S>;
  constexpr int step_limit = 128;
  const Vec<N, double> from = wide_support(shape, unit_axis<N>(0));
  NearPlace<N> nearest;
  nearest.off = p - from;
  nearest.face.push(nearest.place);
  const Vec<N, double> target = nearest.off;
  for (int step = 0; step < step_limit && max_abs(nearest.off) > 0; ++step) {
    const Vec<N, double> next = support_from(shape, from, nearest.off);
    if (!(dot(nearest.off, next - nearest.place) > 0) || is_corner_of(nearest.face, next)) break;
    Simplex<N> extended = nearest.face;
    extended.push(next);
    const NearPlace<N> found = NearPlaceSearch<N>(extended, target).run();
    if (!(NearPlaceSearch<N>::nearer_by(found.place, found.off, nearest) > 0)) break;
    nearest = found;
  }
  if (nearest.face.size == 1) {
    const Vec<N, double> corner = as_stored(shape, from, nearest.place);
    return {corner, p - corner};
  }
  return {from + nearest.place, nearest.off};
}

}  // namespace graze::detail
