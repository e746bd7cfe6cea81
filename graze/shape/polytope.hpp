// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/hull/convex_ring.hpp>
#include <graze/shape/hull/corner_rows.hpp>
#include <graze/shape/hull/input.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/monotone_chain.hpp>
#include <graze/shape/hull/octagon.hpp>
#include <graze/shape/hull/vertices.hpp>

namespace graze {

template <Dim N, class T>
class Polytope;

namespace detail {
template <Dim N, class T>
const CornerRows<N, T>& rows_of(const Polytope<N, T>& polytope);
template <Dim N, class T, class F>
Polytope<N, T> with_corners_mapped(const Polytope<N, T>& polytope, const F& f);
}  // namespace detail

/// A solid convex polytope, in 2D a convex polygon. Made by `convex_hull`. Copies share one immutable list of vertices,
/// so a copy is as cheap as a sphere's. Default: the single point at the origin.
template <Dim N, class T = float>
class Polytope {
 public:
  Polytope() : Polytope(std::vector<Vec<N, T>>{Vec<N, T>(T(0))}) {}

  /// The corners, at least one; a corner's index is its id in contacts. In 2D they are in counter-clockwise order (y
  /// up), and none lies on the line between its neighbours; `convex_hull` starts with the lexicographically least. In
  /// 3D none lies in the hull of the others; `convex_hull` sorts them lexicographically. `transformed` keeps the order;
  /// in 3D rounding may then move a corner into the hull of the others, or onto another one.
  std::span<const Vec<N, T>> vertices() const { return corners_->vertices; }

 private:
  struct Corners {
    std::vector<Vec<N, T>> vertices;
    detail::CornerRows<N, T> rows{vertices};
  };

  explicit Polytope(std::vector<Vec<N, T>> vertices)
      : corners_(std::make_shared<const Corners>(Corners{std::move(vertices)})) {}

  template <Dim M, class U>
  friend Polytope<M, U> convex_hull(std::type_identity_t<std::span<const Vec<M, U>>> points);
  template <Dim M, class U>
  friend Polytope<M, U> convex_hull_in_order(std::type_identity_t<std::span<const Vec<M, U>>> points);
  template <Dim M, class U>
  friend Polytope<M, U> transformed(const Polytope<M, U>& polytope, const Pose<M, U>& pose);
  template <Dim M, class U>
  friend const detail::CornerRows<M, U>& detail::rows_of(const Polytope<M, U>& polytope);
  template <Dim M, class U, class F>
  friend Polytope<M, U> detail::with_corners_mapped(const Polytope<M, U>& polytope, const F& f);

  // Shared, because a hull is built once and copied many times into scenes, parts and snapshots; it never changes.
  std::shared_ptr<const Corners> corners_;
};

namespace detail {

template <Dim N, class T>
const CornerRows<N, T>& rows_of(const Polytope<N, T>& polytope) {
  return polytope.corners_->rows;
}

/// Every corner replaced by f(corner), in the same order. The caller guarantees that the results are still the corners
/// of a hull.
template <Dim N, class T, class F>
Polytope<N, T> with_corners_mapped(const Polytope<N, T>& polytope, const F& f) {
  std::vector<Vec<N, T>> corners;
  corners.reserve(polytope.vertices().size());
  for (const Vec<N, T>& corner : polytope.vertices()) corners.push_back(f(corner));
  return Polytope<N, T>(std::move(corners));
}

template <Dim N, class T>
void sort_and_forget_duplicates(std::vector<Vec<N, T>>& points) {
  std::sort(points.begin(), points.end(), lexicographically_less<N, T>);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// Those of the points that are corners, each where it first occurs. `corners` is sorted lexicographically.
template <class T>
std::vector<Vec<3, T>> sorted_as(std::span<const Vec<3, T>> points, const std::vector<Vec<3, T>>& corners) {
  std::vector<Vec<3, T>> sorted;
  std::vector<bool> is_there(corners.size(), false);
  for (const Vec<3, T>& point : points) {
    const auto place = std::lower_bound(corners.begin(), corners.end(), point, lexicographically_less<3, T>);
    if (place == corners.end() || *place != point) continue;
    const auto which = static_cast<std::size_t>(place - corners.begin());
    if (!is_there[which]) sorted.push_back(point);
    is_there[which] = true;
  }
  return sorted;
}

/// The corner that occurs first among the points, each of which is a corner or within their hull.
template <class T>
typename std::vector<Vec<2, T>>::iterator find_first_corner(std::vector<Vec<2, T>>& corners,
                                                            std::span<const Vec<2, T>> points) {
  std::vector<Vec<2, T>> sorted = corners;
  std::sort(sorted.begin(), sorted.end(), lexicographically_less<2, T>);
  const auto is_corner = [&](const Vec<2, T>& point) {
    return std::binary_search(sorted.begin(), sorted.end(), point, lexicographically_less<2, T>);
  };
  return std::find(corners.begin(), corners.end(), *std::find_if(points.begin(), points.end(), is_corner));
}

}  // namespace detail

/// The convex hull of points in any order, duplicates allowed; which of them are corners is decided exactly. One point,
/// collinear points, or in 3D coplanar points give a flat polytope, which is valid. Coordinates may have any magnitude,
/// but points that differ by less than 1e-120 of the largest coordinate may count as one. Throws std::invalid_argument
/// if there are no points or a coordinate is not finite, and std::length_error for more than 2^32 - 1 points in 3D.
template <Dim N, class T>
Polytope<N, T> convex_hull(std::type_identity_t<std::span<const Vec<N, T>>> points) {
  detail::check_hull_points<N, T>("convex_hull", points);
  std::vector<Vec<N, T>> corners;
  if constexpr (N == 2) {
    corners = detail::outer_points<T>(points);
    detail::sort_and_forget_duplicates<N, T>(corners);
    corners = detail::monotone_chain(corners);
  } else {
    for (const std::uint32_t vertex : detail::hull_vertices<T>(points)) corners.push_back(points[vertex]);
    detail::sort_and_forget_duplicates<N, T>(corners);
  }
  return Polytope<N, T>(std::move(corners));
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto convex_hull(const Row& points) {
  using Point = ElementOf<Row>;
  return convex_hull<detail::vec_dimension<Point>, typename Point::value_type>(span_of(points));
}

/// The overload for a contiguous range of points if the dimension is given: convex_hull<3>(points).
template <Dim N, PointRowIn<N> Row>
auto convex_hull(const Row& points) {
  return convex_hull(points);
}

/// The convex hull with its corners in the order in which they first occur among the points: in 3D in that order, in 2D
/// counter-clockwise from the first one. So points that are moved, or written to a file and read again, give corners of
/// the same indices, and contacts keep their ids. Otherwise as `convex_hull`, which is cheaper.
template <Dim N, class T>
Polytope<N, T> convex_hull_in_order(std::type_identity_t<std::span<const Vec<N, T>>> points) {
  const Polytope<N, T> hull = convex_hull<N, T>(points);
  std::vector<Vec<N, T>> corners(hull.vertices().begin(), hull.vertices().end());
  if constexpr (N == 2) {
    std::rotate(corners.begin(), detail::find_first_corner<T>(corners, points), corners.end());
    return Polytope<N, T>(std::move(corners));
  } else {
    return Polytope<N, T>(detail::sorted_as<T>(points, corners));
  }
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto convex_hull_in_order(const Row& points) {
  using Point = ElementOf<Row>;
  return convex_hull_in_order<detail::vec_dimension<Point>, typename Point::value_type>(span_of(points));
}

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Polytope<N, T>> = Description("polytope",
                                                                   field::hull("points", &Polytope<N, T>::vertices));
}  // namespace detail

/// The vertex that is farthest along `direction` (any nonzero length), in double; of several, always the same.
template <Dim N, class T>
Vec<N, double> support(const Polytope<N, T>& polytope, const std::type_identity_t<Vec<N, double>>& direction) {
  return wide<N, T>(polytope.vertices()[detail::rows_of(polytope).farthest(direction)]);
}

/// The image of a polytope. Corners keep their indices, so that contact ids stay the same. In 2D a corner that rounding
/// has put between its neighbours, or behind the line through them, is dropped, and the following ones move up. Throws
/// std::invalid_argument if a coordinate is not finite.
template <Dim N, class T>
Polytope<N, T> transformed(const Polytope<N, T>& polytope, const Pose<N, T>& pose) {
  std::vector<Vec<N, T>> moved;
  moved.reserve(polytope.vertices().size());
  for (const Vec<N, T>& vertex : polytope.vertices()) moved.push_back(transformed(vertex, pose));
  detail::check_hull_points<N, T>("transformed", moved);
  if constexpr (N == 2) {
    if (!detail::is_convex_ring<T>(moved)) return convex_hull_in_order<N, T>(moved);
  }
  // In 3D a new hull for each of thousands of moving polytopes would cost too much.
  return Polytope<N, T>(std::move(moved));
}

}  // namespace graze
