// SPDX-License-Identifier: MIT
// Whether shapes that touch, at the start of a cast or on its way, are moved into each other. Include shape_cast.hpp.
//
// While one convex shape translates past another, their signed distance is a convex function of time. So a shape that
// does not go deeper at first never does. A touch is harmless if some plane separates the shapes and contains the
// motion. The normal of a contact need not be that plane's: a box that slides along a floor of two boxes touches the
// second one at its edge, and of the planes through that edge the normal may be that of a side. Seen along the motion,
// the shapes are projections onto a plane (in 2D, onto a line) that stay where they are. There is such a plane if and
// only if the projections do not overlap.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/impact.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// The projection of a 3D shape onto a plane with these unit vectors as axes. `Number` is the number type of its
/// supports.
template <Scalar Number>
struct Silhouette {
  const ConvexView<3>& view;
  Vec<3, double> right;
  Vec<3, double> up;
};

template <Scalar Number>
Vec<2, double> support(const Silhouette<Number>& silhouette, const Vec<2, double>& direction) {
  const Vec<3, double> point = silhouette.view.support(silhouette.right * direction.x + silhouette.up * direction.y);
  return {dot(point, silhouette.right), dot(point, silhouette.up)};
}

}  // namespace graze::detail

namespace graze {
template <Scalar Number>
struct ShapeTraits<detail::Silhouette<Number>> : Space<2, double> {};
}  // namespace graze

namespace graze::detail {

template <>
inline constexpr double support_error<Silhouette<float>> = tolerance::convex_in<float>;

/// A core that passes another one; of a ray, its beginning and its unit direction.
template <Dim N>
struct Passing {
  ConvexView<N> view;
  Vec<N, double> ahead = Vec<N, double>(0.0);  ///< Zero unless it is a ray.
};

/// Whether two cores inflated by radii, the sum of which is given, overlap by at most `slack` as a moves along the line
/// of `motion` in either direction. In 2D one of the two normals of the line must separate them; one along which a ray
/// leads does not, even if the ray crosses the other core far away. Number is that of the supports, T that of the
/// shapes.
template <Scalar Number, Scalar T>
bool do_pass(const Passing<2>& a, const Vec<2, double>& motion, const Passing<2>& b, double radius, double slack) {
  const Vec<2, double> across = unit_or(perpendicular(motion / max_abs(motion)), Vec<2, double>(0.0));
  for (const Vec<2, double>& normal : {across, -across}) {
    if (dot(a.ahead, normal) > tolerance::approach<T> || -dot(b.ahead, normal) > tolerance::approach<T>) continue;
    const Vec<2, double> on_a = a.view.support(normal);
    const Vec<2, double> on_b = b.view.support(-normal);
    const double resolution = tolerance::convex_in<Number> * std::max(max_abs(on_a), max_abs(on_b));
    if (dot(normal, on_b) - dot(normal, on_a) >= radius - slack - resolution) return true;
  }
  return false;
}

template <Scalar Number, Scalar T>
bool do_pass(const Passing<3>& a, const Vec<3, double>& motion, const Passing<3>& b, double radius, double slack) {
  const Vec<3, double> along = motion / max_abs(motion);
  Dim least = 0;
  for (Dim i = 1; i < 3; ++i) {
    if (std::fabs(along[i]) < std::fabs(along[least])) least = i;
  }
  const Vec<3, double> right = unit_or(cross(along, unit_axis<3>(least)), Vec<3, double>(0.0));
  const Vec<3, double> up = unit_or(cross(along, right), Vec<3, double>(0.0));
  const Silhouette<Number> seen_a{a.view, right, up};
  const Silhouette<Number> seen_b{b.view, right, up};
  Difference differences(seen_a, seen_b);
  const GjkResult<2> gap = gjk_on(differences, GjkOptions{});
  if (gap.lower > gap.resolution) return gap.upper >= radius - slack - gap.resolution;
  const EpaResult<2> depth = epa_on<2>(differences, gap.simplex, EpaOptions{});
  return depth.upper + radius <= slack + depth.resolution;
}

/// The unit direction of a ray; zero for others.
template <class S>
Vec<dimension_of<S>, double> ahead_of(const S& shape) {
  const Vec<dimension_of<S>, double> zero(0.0);
  if constexpr (is_ray<S>) {
    return unit_or(wide<dimension_of<S>, scalar_of<S>>(shape.direction), zero);
  } else {
    return zero;
  }
}

/// A core; of a ray, the part up to beyond a point.
template <class S>
decltype(auto) core_near(const S& shape, const Vec<dimension_of<S>, double>& point, double beyond) {
  if constexpr (is_ray<S>) {
    constexpr Dim N = dimension_of<S>;
    const Vec<N, double> origin = reference(shape);
    return Segment<N, double>{origin, origin + ahead_of(shape) * (sum_abs(point - origin) + beyond)};
  } else {
    return core(shape);
  }
}

/// Whether a motion shortens the distance of convex shapes that are apart, by more than rounding explains. The cast of
/// shapes that only rounding keeps apart, or farther apart than the target, is a hit at the start even if the motion
/// leads away, and then its normal is not that between the shapes.
template <class A, class B>
bool is_shortened(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b) {
  return dot(proximity(a, b).normal, motion) > tolerance::approach<scalar_of<A>> * sum_abs(motion);
}

/// Whether the motion takes two shapes deeper into each other than rounding explains (or nearer, if they are as near as
/// the target): from where they touch, at the start or later.
template <class A, class B>
bool is_approached(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b, double target,
                   const CastHit<dimension_of<A>>& touch) {
  constexpr Dim N = dimension_of<A>;
  const double slack = tolerance::approach<scalar_of<A>> * sum_abs(motion);
  if (!(dot(touch.normal, motion) > slack)) return false;
  if constexpr (is_plane_or_half_space<A> || is_plane_or_half_space<B>) {
    return true;
  } else {
    const double beyond = 2 * sum_abs(motion) + target;
    const auto& core_a = core_near(a, touch.point, beyond);
    const auto& core_b = core_near(b, touch.point, beyond);
    const double radius = core_radius(a) + core_radius(b) + target;
    using Number = SupportNumber<std::decay_t<decltype(core_a)>, std::decay_t<decltype(core_b)>>;
    return !do_pass<Number, scalar_of<A>>(Passing<N>{ConvexView<N>(core_a), ahead_of(a)}, motion,
                                          Passing<N>{ConvexView<N>(core_b), ahead_of(b)}, radius, slack + touch.error);
  }
}

}  // namespace graze::detail
