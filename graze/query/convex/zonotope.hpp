// SPDX-License-Identifier: MIT
// Segments and boxes of every kind are zonotopes: a center plus a range along each of a few edges. One separating-axis
// test handles all their pairs.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>

namespace graze::detail {

/// All reference + to_center + sum of u[i] * half_edges[i] with |u[i]| <= 1. The reference is a stored point of the
/// shape and the rest is small, so that the difference of two zonotopes is rounded relative to the pair's own size,
/// however far from zero it is. `directions[i]` is parallel to half_edges[i], and not zero even if the half edge is
/// (except for a segment that is a point).
template <Dim N, std::size_t Edges>
struct Zonotope {
  Vec<N, double> reference;
  Vec<N, double> to_center;
  std::array<Vec<N, double>, Edges> directions;
  std::array<Vec<N, double>, Edges> half_edges;
};

/// From center to center. Swapping the arguments negates it exactly.
template <Dim N, std::size_t A, std::size_t B>
Vec<N, double> between_centers(const Zonotope<N, A>& a, const Zonotope<N, B>& b) {
  return (b.reference - a.reference) + (b.to_center - a.to_center);
}

template <Dim N, class T>
Zonotope<N, 0> zonotope(const Vec<N, T>& point) {
  return {wide<N, T>(point), Vec<N, double>(0.0), {}, {}};
}

template <Dim N, class T>
Zonotope<N, 1> zonotope(const Segment<N, T>& segment) {
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> half = 0.5 * (wide<N, T>(segment.end) - start);
  return {start, half, {half}, {half}};
}

template <Dim N, class T>
Zonotope<N, static_cast<std::size_t>(N)> zonotope(const Aabb<N, T>& box) {
  Zonotope<N, static_cast<std::size_t>(N)> result;
  result.reference = wide<N, T>(box.min);
  result.to_center = 0.5 * (wide<N, T>(box.max) - result.reference);
  for (Dim i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.directions[k] = unit_axis<N>(i);
    result.half_edges[k] = unit_axis<N>(i) * result.to_center[i];
  }
  return result;
}

template <Dim N, class T>
Zonotope<N, static_cast<std::size_t>(N)> zonotope(const Obb<N, T>& box) {
  Zonotope<N, static_cast<std::size_t>(N)> result;
  result.reference = wide<N, T>(box.center);
  result.to_center = Vec<N, double>(0.0);
  const Mat<N, double> edges = half_edges(box);
  for (Dim i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.directions[k] = wide<N, T>(box.axes[i]);
    result.half_edges[k] = edges[i];
  }
  return result;
}

/// The cross product, accurate to epsilon of its length; by the cheap formula if little cancels.
inline Vec<3, double> cross_of_directions(const Vec<3, double>& a, const Vec<3, double>& b) {
  const Vec<3, double> product = cross(a, b);
  constexpr double least_sine = 1.0 / 8;
  if (dot(product, product) > least_sine * least_sine * dot(a, a) * dot(b, b)) return product;
  return accurate_cross(a, b);
}

/// The separating-axis test of two zonotopes, one axis at a time. Gottschalk, Lin, Manocha, "OBBTree" (1996), with a
/// verdict.
template <Dim N>
class AxisTest {
 public:
  explicit AxisTest(const Vec<N, double>& between) : between_(between) {}

  Relation verdict() const { return verdict_; }

  /// Projects on `axis`, which is accurate to epsilon of its length, however short it is. False if it proves the
  /// zonotopes apart.
  ///
  /// The gap along the axis is |axis . between| - sum |axis . edge|. Any axis, however it was rounded, can prove the
  /// shapes apart, so that verdict only accounts for the rounding of the sum. As the measure of a depth, the axis
  /// represents the exact normal of a face, so its own rounding counts too, on every edge.
  template <std::size_t A, std::size_t B>
  bool project(const Vec<N, double>& axis, const std::array<Vec<N, double>, A>& edges_a,
               const std::array<Vec<N, double>, B>& edges_b) {
    const Vec<N, double> size = abs(axis);
    const Projection a = projection(axis, size, edges_a);
    const Projection b = projection(axis, size, edges_b);
    const double gap = std::fabs(dot(axis, between_)) - (a.reach + b.reach);
    const double magnitude = dot(size, abs(between_)) + (a.magnitude + b.magnitude);
    const double extent = sum_abs(between_) + (a.extent + b.extent);
    if (!(gap <= tolerance::rounding * magnitude)) {
      verdict_ = Relation::apart;
      return false;
    }
    const double length = sum_abs(axis);
    if (length > 0 && gap >= -tolerance::rounding * length * extent) verdict_ = Relation::touching;
    return true;
  }

 private:
  /// The projection of a zonotope to an axis: sum |axis . edge|, the same without cancellation, and the size of the
  /// edges themselves.
  struct Projection {
    double reach = 0;
    double magnitude = 0;
    double extent = 0;
  };

  template <std::size_t Edges>
  static Projection projection(const Vec<N, double>& axis, const Vec<N, double>& size,
                               const std::array<Vec<N, double>, Edges>& half_edges) {
    Projection result;
    for (const Vec<N, double>& edge : half_edges) {
      result.reach += std::fabs(dot(axis, edge));
      result.magnitude += dot(size, abs(edge));
      result.extent += sum_abs(edge);
    }
    return result;
  }

  Vec<N, double> between_;
  Relation verdict_ = Relation::overlapping;
};

/// The verdict on two zonotopes, at least one of them a box, or on two 2D segments that are not points. The faces of
/// the Minkowski difference are spanned by pairs of edges, one of the 15 axes of two boxes each (in 2D by single
/// edges); edges of the same shape come first because they separate most often.
template <Dim N, std::size_t A, std::size_t B>
Relation relation_of_zonotopes(const Zonotope<N, A>& a, const Zonotope<N, B>& b) {
  AxisTest<N> test(between_centers(a, b));
  if constexpr (N == 2) {
    const auto project_all = [&](const auto& directions) {
      for (const Vec<2, double>& direction : directions) {
        if (!test.project(perpendicular(direction), a.half_edges, b.half_edges)) return false;
        // Collinear segments are separated only along their line.
        if (A + B == 2 && !test.project(direction, a.half_edges, b.half_edges)) return false;
      }
      return true;
    };
    if (project_all(a.directions)) project_all(b.directions);
  } else {
    const auto project_pair = [&](const Vec<3, double>& first, const Vec<3, double>& second) {
      return test.project(cross_of_directions(first, second), a.half_edges, b.half_edges);
    };
    const auto project_own = [&](const auto& directions) {
      for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
        for (std::size_t j = i + 1; j < directions.size(); ++j) {
          if (!project_pair(directions[i], directions[j])) return false;
        }
      }
      return true;
    };
    if (!project_own(a.directions) || !project_own(b.directions)) return test.verdict();
    for (const Vec<3, double>& first : a.directions) {
      for (const Vec<3, double>& second : b.directions) {
        if (!project_pair(first, second)) return test.verdict();
      }
    }
  }
  return test.verdict();
}

}  // namespace graze::detail
