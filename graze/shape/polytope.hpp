// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

namespace graze {

/// A solid convex polytope: in 2D a convex polygon. Made by `convex_hull`; copies share one immutable list of vertices,
/// so a copy costs as little as a sphere's. Default: the single point at the origin.
template <Dim N, class T = float>
class Polytope {
 public:
  Polytope() : Polytope(std::vector<Vec<N, T>>{Vec<N, T>(T(0))}) {}

  /// At least one. In 2D the corners in counter-clockwise order (y up), none of them on the line between its
  /// neighbours; in 3D the distinct points that the hull was made of, in lexicographic order.
  std::span<const Vec<N, T>> vertices() const { return *vertices_; }

 private:
  explicit Polytope(std::vector<Vec<N, T>> vertices)
      : vertices_(std::make_shared<const std::vector<Vec<N, T>>>(std::move(vertices))) {}

  template <Dim M, class U>
  friend Polytope<M, U> convex_hull(std::type_identity_t<std::span<const Vec<M, U>>> points);

  // Shared, because a hull is built once and copied into scenes, parts and snapshots many times; it never changes.
  std::shared_ptr<const std::vector<Vec<N, T>>> vertices_;
};

namespace detail {

template <Dim N, class T>
bool lexicographically_less(const Vec<N, T>& a, const Vec<N, T>& b) {
  for (Dim i = 0; i < N; ++i) {
    if (a[i] != b[i]) return a[i] < b[i];
  }
  return false;
}

/// The corners of the hull of sorted distinct points. Andrew, "Another efficient algorithm for convex hulls in two
/// dimensions" (1979), with an exact orientation test: no corner is lost to rounding.
template <class T>
std::vector<Vec<2, T>> monotone_chain(const std::vector<Vec<2, T>>& points) {
  if (points.size() < 3) return points;
  std::vector<Vec<2, T>> hull;
  const auto extend = [&hull](const Vec<2, T>& point, std::size_t fixed) {
    while (hull.size() > fixed && orientation(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Vec<2, T>& point : points) extend(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, lower);
  hull.pop_back();
  return hull;
}

}  // namespace detail

/// The convex hull of points in any order, duplicates allowed. One point, points on a line, or in 3D on a plane, give a
/// flat polytope, which is valid. No points, or a coordinate that is not finite: std::invalid_argument.
template <Dim N, class T>
Polytope<N, T> convex_hull(std::type_identity_t<std::span<const Vec<N, T>>> points) {
  if (points.empty()) throw std::invalid_argument("convex_hull: there are no points");
  for (const Vec<N, T>& point : points) {
    if (!is_finite(point)) throw std::invalid_argument("convex_hull: a point has a coordinate that is not finite");
  }
  std::vector<Vec<N, T>> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), detail::lexicographically_less<N, T>);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if constexpr (N == 2) sorted = detail::monotone_chain(sorted);
  return Polytope<N, T>(std::move(sorted));
}

/// A polytope cannot be built with a defect.
template <Dim N, class T>
std::string_view defect(const Polytope<N, T>&) {
  return "";
}

template <Dim N, class T>
Vec<N, double> support(const Polytope<N, T>& polytope, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> best = wide<N, T>(polytope.vertices().front());
  double height = dot(best, direction);
  for (const Vec<N, T>& vertex : polytope.vertices().subspan(1)) {
    const double candidate = dot(wide<N, T>(vertex), direction);
    if (candidate > height) {
      height = candidate;
      best = wide<N, T>(vertex);
    }
  }
  return best;
}

template <Dim N, class T>
Polytope<N, T> transformed(const Polytope<N, T>& polytope, const Pose<N, T>& pose) {
  std::vector<Vec<N, T>> moved;
  moved.reserve(polytope.vertices().size());
  for (const Vec<N, T>& vertex : polytope.vertices()) moved.push_back(transformed(vertex, pose));
  return convex_hull<N, T>(moved);
}

}  // namespace graze
