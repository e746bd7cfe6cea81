// SPDX-License-Identifier: MIT
// The Minkowski difference b - a. A shape a that moves by a vector touches b where the origin, moving by the same
// vector, touches this set (Cameron and Culley, "Determining the minimum translational distance between two convex
// polyhedra", 1986): so a moving shape is a ray. Include shape_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/query/relation/convex.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

// ---- Any two convex shapes

/// A convex shape of any type, accessed through its support function. Code that runs much longer than an indirect call,
/// such as GJK, is compiled once for all pairs. It must not outlive the shape.
template <Dim N>
class ConvexView {
 public:
  template <Convex S>
  explicit ConvexView(const S& shape) : shape_(&shape), support_(&support_of<S>) {}

  Vec<N, double> support(const Vec<N, double>& direction) const { return support_(shape_, direction); }

 private:
  template <Convex S>
  static Vec<N, double> support_of(const void* shape, const Vec<N, double>& direction) {
    return wide_support(*static_cast<const S*>(shape), direction);
  }

  const void* shape_;
  Vec<N, double> (*support_)(const void*, const Vec<N, double>&);
};

/// The set b - (a - place) of two cores, inflated by a radius, which a ray from `place` hits where a moving a touches
/// b. With a point of a as the place, coordinates are as large as those of the shapes, and rounding is judged by them.
/// `Number` is the supports' number type.
template <Dim N, Scalar Number>
struct MinkowskiDifference {
  ConvexView<N> a;
  ConvexView<N> b;
  Vec<N, double> place;
  double radius;
};

template <Dim N, Scalar Number>
Vec<N, double> support_of_core(const MinkowskiDifference<N, Number>& difference, const Vec<N, double>& direction) {
  return difference.b.support(direction) - (difference.a.support(-direction) - difference.place);
}

/// The same without the radius.
template <Dim N, Scalar Number>
struct DifferenceCore {
  const MinkowskiDifference<N, Number>& difference;
};

template <Dim N, Scalar Number>
Vec<N, double> support(const DifferenceCore<N, Number>& core, const std::type_identity_t<Vec<N, double>>& direction) {
  return support_of_core(core.difference, direction);
}

template <Dim N, Scalar Number>
Vec<N, double> support(const MinkowskiDifference<N, Number>& difference,
                       const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return support_of_core(difference, direction) + direction * (difference.radius / size);
}

template <Dim N, Scalar Number>
DifferenceCore<N, Number> core(const MinkowskiDifference<N, Number>& difference) {
  return {difference};
}

template <Dim N, Scalar Number>
double core_radius(const MinkowskiDifference<N, Number>& difference) {
  return difference.radius;
}

template <Dim N>
inline constexpr double support_error<MinkowskiDifference<N, float>> = tolerance::convex_in<float>;
template <Dim N>
inline constexpr double support_error<DifferenceCore<N, float>> = tolerance::convex_in<float>;

/// The number type of the support points of two shapes.
template <Convex A, Convex B>
using SupportNumber =
    std::conditional_t<SupportsIn<A, dimension_of<A>, double> && SupportsIn<B, dimension_of<A>, double>, double, float>;

}  // namespace graze::detail

namespace graze {

// Their own numbers are double, whatever the supports' number type.

template <Dim N, Scalar Number>
struct ShapeTraits<detail::MinkowskiDifference<N, Number>> : Space<N, double> {};
template <Dim N, Scalar Number>
struct ShapeTraits<detail::DifferenceCore<N, Number>> : Space<N, double> {};

}  // namespace graze

namespace graze::detail {

// ---- An AABB inflated by a radius

template <Dim N>
struct RoundedBox {
  Aabb<N, double> box;
  double radius;
};

template <Dim N>
Vec<N, double> support(const RoundedBox<N>& solid, const std::type_identity_t<Vec<N, double>>& direction) {
  const double size = std::sqrt(dot(direction, direction));
  return support(solid.box, direction) + direction * (solid.radius / size);
}

template <Dim N>
const Aabb<N, double>& core(const RoundedBox<N>& solid) {
  return solid.box;
}

template <Dim N>
double core_radius(const RoundedBox<N>& solid) {
  return solid.radius;
}

template <Dim N>
RoundedBox<N> relative_to(const Vec<N, double>& origin, const RoundedBox<N>& solid) {
  return {{solid.box.min - origin, solid.box.max - origin}, solid.radius};
}

/// Only for what the closed form leaves open.
template <Dim N>
Relation closed_form(const Segment<N, double>& segment, const RoundedBox<N>& solid) {
  return relation_of_convex(segment, solid);
}

/// The times at which a path from zero crosses the planes of a box's sides, in order, between 0 and t_max.
template <Dim N>
class SideCrossings {
 public:
  SideCrossings(const Aabb<N, double>& box, const Vec<N, double>& direction, double t_max) {
    for (Dim i = 0; i < N; ++i) {
      if (!(std::fabs(direction[i]) > least_slope)) continue;
      add(box.min[i] / direction[i], t_max);
      add(box.max[i] / direction[i], t_max);
    }
    times_[count_++] = t_max;
    std::sort(times_.begin(), times_.begin() + count_);
  }

  const double* begin() const { return times_.data(); }
  const double* end() const { return times_.data() + count_; }

 private:
  void add(double t, double t_max) {
    if (t > 0 && t < t_max) times_[count_++] = t;
  }

  std::array<double, static_cast<std::size_t>(2 * N + 1)> times_{};
  std::size_t count_ = 0;
};

/// Between two such times, the nearest point of the box is on a known face, edge or corner: the line meets a sphere
/// around it, projected along the axes whose coordinates are not fixed. All coordinates are zero for a point in the
/// box.
template <Dim N>
struct NearestSides {
  NearestSides(const Aabb<N, double>& box, const Vec<N, double>& along, const Vec<N, double>& point) {
    for (Dim i = 0; i < N; ++i) {
      if (point[i] >= box.min[i] && point[i] <= box.max[i]) continue;
      center[i] = point[i] < box.min[i] ? box.min[i] : box.max[i];
      if (std::fabs(along[i]) > least_slope) direction[i] = along[i];
    }
  }

  Vec<N, double> center = Vec<N, double>(0.0);
  Vec<N, double> direction = Vec<N, double>(0.0);
};

/// The squared distance to a box is a convex function made of parabolas, one for each interval between two crossings:
/// the first one that reaches the squared radius gives the hit. Judged by the bands of the sphere in ray/verdict.hpp.
template <Dim N>
RayFinding<N> ray_verdict_of(const RoundedBox<N>& solid, const Path<N>& path) {
  const auto& [zero, direction, t_max, far] = path;
  const double size = sum_abs(solid.box.min) + sum_abs(solid.box.max) + solid.radius + far;
  const double band = tolerance::ray_filter * size * size;
  const double squared_radius = solid.radius * solid.radius;
  double from = 0;
  for (const double to : SideCrossings<N>(solid.box, direction, t_max)) {
    const double start = from;
    from = to;
    const NearestSides<N> sides(solid.box, direction, direction * (0.5 * start + 0.5 * to));
    if (max_abs(sides.direction) == 0) continue;  // as far away as at the start; or inside, and then it has been hit
    const SpherePassage<N> passage(sides.direction, sides.center, squared_radius);
    if (passage.depth < -band) continue;
    const double slack = tolerance::ray_end * size / std::sqrt(passage.whole);
    if (passage.exit() < start - slack || passage.enter() > to + slack) continue;
    const bool is_clear = passage.depth > band && passage.enter() > slack && passage.enter() < t_max - slack;
    if (!is_clear) return unsettled<N>();
    if (passage.enter() > to) continue;
    RayFinding<N> result{RayVerdict::hits, {}};
    result.hit.t = std::max(passage.enter(), start);
    result.hit.error = tolerance::rounding * size;
    result.hit.normal = normal_along(passage.spoke(sides.direction), direction, result.hit.error);
    result.hit.point = direction * result.hit.t;
    return result;
  }
  return missed<N>();
}

// ---- Differences with a closed form: of two cores relative to one position, and the sum of the shapes' radii

template <Dim N>
Sphere<N, double> minkowski_difference_of(const Vec<N, double>& a, const Vec<N, double>& b, double radius) {
  return {b - a, radius};
}

template <Dim N>
Capsule<N, double> minkowski_difference_of(const Segment<N, double>& a, const Vec<N, double>& b, double radius) {
  return {b - a.start, b - a.end, radius};
}

template <Dim N>
Capsule<N, double> minkowski_difference_of(const Vec<N, double>& a, const Segment<N, double>& b, double radius) {
  return {b.start - a, b.end - a, radius};
}

template <Dim N>
RoundedBox<N> minkowski_difference_of(const Vec<N, double>& a, const Aabb<N, double>& b, double radius) {
  return {{b.min - a, b.max - a}, radius};
}

template <Dim N>
Aabb<N, double> minkowski_difference_of(const Aabb<N, double>& a, const Aabb<N, double>& b, double) {
  return {b.min - a.max, b.max - a.min};
}

}  // namespace graze::detail
