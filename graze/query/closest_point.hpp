// SPDX-License-Identifier: MIT
/// @file
/// closest_point(shape, point): the point of a shape nearest to a given one. If a solid contains the point, it is the
/// point itself.
///
///     point, segment, ray, sphere, aabb, obb, plane, half-space, triangle, capsule  closed form
///     polytope in 2D                                                                closed form
///     polytope in 3D, user's convex shape                                           GJK, until the right face is found
///     compound                                                                      its nearest part (the first)
///
/// contains(shape, closest_point(shape, point)) always holds: if rounding to T would leave a solid, the result moves
/// inward. The error is at most a few ulp of T of the largest coordinate of point and shape, with two exceptions. Next
/// to corners of a triangle or polytope that are sharper than about 20 degrees there may be no point of T that is both
/// inside and near; there the error can be larger by the ratio of the shape's length to its thickness. For a curved
/// user's shape, GJK's distance is within 1e-12 of the least distance, but the point may be off by up to 1e-6 of the
/// distance.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/closest/surface_point_convex.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

/// Whether SurfacePoint::inner is within the shape's thickness of the surface point.
template <class S>
inline constexpr bool inner_is_near = false;
template <Dim N, class T>
inline constexpr bool inner_is_near<Sphere<N, T>> = true;
template <Dim N, class T>
inline constexpr bool inner_is_near<Capsule<N, T>> = true;
template <Dim N, class T>
inline constexpr bool inner_is_near<Obb<N, T>> = true;
template <Dim N, class T>
inline constexpr bool inner_is_near<HalfSpace<N, T>> = true;

/// The nearest point of T. Not inlined, because GCC 12 at -O3 would merge the rounding with the test whether a sphere
/// contains the result, and test a different point.
template <Scalar T, Dim N>
[[gnu::noinline]] Vec<N, T> nearest_of(const Vec<N, double>& point) {
  return Vec<N, T>(point);
}

/// One step of T's rounding at a point.
template <Scalar T, Dim N>
double step_at(const Vec<N, double>& point) {
  return static_cast<double>(std::numeric_limits<T>::epsilon()) * max_abs(point);
}

/// The first point towards `inner`, in steps that double, that the shape contains; `inner` itself if there is none.
template <Shape S>
PointOf<S> settled_inwards(const S& shape, const SurfacePoint<dimension_of<S>>& at) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const Vec<N, double> inward = at.inner - at.point;
  const double first = std::max(step_at<T>(at.point), step_at<T>(at.inner)) / max_abs(inward);
  for (double share = first; share > 0 && share < 1; share *= 2) {
    const PointOf<S> candidate = nearest_of<T>(at.point + inward * share);
    if (holds(shape, candidate)) return candidate;
  }
  return nearest_of<T>(at.inner);
}

/// The nearest point of a grid around `center` with this step that the shape contains.
template <Shape S>
std::optional<PointOf<S>> settled_around(const S& shape, const Vec<dimension_of<S>, double>& center, double step) {
  constexpr Dim N = dimension_of<S>;
  constexpr int around = N == 2 ? 9 : 27;
  std::optional<PointOf<S>> best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < around; ++i) {
    Vec<N, double> way;
    int digits = i;
    for (Dim k = 0; k < N; ++k, digits /= 3) way[k] = digits % 3 - 1;
    const PointOf<S> candidate = nearest_of<scalar_of<S>>(center + way * step);
    const Vec<N, double> off = wide<N, scalar_of<S>>(candidate) - center;
    if (!(dot(off, off) < least) || !holds(shape, candidate)) continue;
    least = dot(off, off);
    best = candidate;
  }
  return best;
}

/// Whether a shape contains the point of T nearest to one of its surface points.
template <Shape S>
bool holds_rounded(const S& shape, const SurfacePoint<dimension_of<S>>&, const PointOf<S>& rounded) {
  return holds(shape, rounded);
}

/// In float, rounding takes at most one eighth of the tolerance, and the error of calculating in double from afar less.
template <class T>
bool holds_rounded(const Triangle<3, T>& triangle, const SurfacePoint<3>& at, const Vec<3, T>& rounded) {
  const double reach = tolerance::surface<T> * largest_coordinate(triangle);
  if (std::is_same_v<T, float> && tolerance::rounding * at.distance <= 0.5 * reach) return true;
  return is_on(triangle, rounded);
}

/// A point of T that the shape contains, near a surface point whose rounded value the shape does not contain. A first
/// result calculated from far away is improved by a second query from there.
template <Shape S>
[[gnu::noinline]] PointOf<S> settled_nearby(const S& shape, SurfacePoint<dimension_of<S>> first) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  if constexpr (inner_is_near<S>) {
    return settled_inwards(shape, first);
  } else {
    const SurfacePoint<N> second = surface_point(shape, first.point);
    const PointOf<S> again = nearest_of<T>(second.point);
    if (!has_inside<S> || holds(shape, again)) return again;
    for (const double steps : {1.0, 2.0, 4.0}) {
      const auto candidate = settled_around(shape, second.point, steps * step_at<T>(second.point));
      if (candidate) return *candidate;
    }
    return settled_inwards(shape, second);
  }
}

/// A surface point, up to an error, as a point of T that the shape contains.
template <Shape S>
[[gnu::always_inline]] inline PointOf<S> settled(const S& shape, const SurfacePoint<dimension_of<S>>& first) {
  const PointOf<S> rounded = nearest_of<scalar_of<S>>(first.point);
  return holds_rounded(shape, first, rounded) ? rounded : settled_nearby(shape, first);
}

// ---- The results

/// The result for an empty compound.
template <Dim N, class T>
Vec<N, T> nowhere() {
  return Vec<N, T>(std::numeric_limits<T>::quiet_NaN());
}

/// ask(shape, point) of rescaled shapes if a number is out of range, otherwise `found` as a point of T.
template <Shape S, class Ask>
[[gnu::noinline, gnu::cold]] PointOf<S> point_in_range_or(SurfacePoint<dimension_of<S>> found, const S& shape,
                                                          const PointOf<S>& point, const Ask& ask) {
  const auto answer = answer_in_range<PointOf<S>>(
      [&ask](const auto& power, const auto& scaled_shape, const auto& scaled_point) {
        return power.inverse()(ask(scaled_shape, scaled_point));
      },
      shape, point);
  return answer ? *answer : settled(shape, found);
}

template <Shape S>
[[gnu::always_inline]] inline PointOf<S> closest_point_of(const S& shape, const PointOf<S>& point) {
  using T = scalar_of<S>;
  const auto ask = [](const auto& scaled_shape, const auto& scaled_point) {
    return closest_point_of(scaled_shape, scaled_point);
  };
  const auto p = wide<dimension_of<S>, T>(point);
  if constexpr (has_inside<S>) {
    const Containment found = contained(shape, point);
    if (found.is_inside) {
      return is_usual_measure<T>(found.measure) ? point : point_in_range_or({p, p}, shape, point, ask);
    }
  }
  const auto at = surface_point(shape, p);
  return is_usual_measure<T>(at.measure) ? settled(shape, at) : point_in_range_or(at, shape, point, ask);
}

/// Exact.
template <Dim N, class T>
Vec<N, T> closest_point_of(const Aabb<N, T>& box, const Vec<N, T>& point) {
  return clamp(point, box.min, box.max);
}

template <Dim N, class T>
Vec<N, T> closest_point_of(const Compound<N, T>& compound, const Vec<N, T>& point);
template <Dim N, class T>
Vec<N, T> closest_point_of(const Mesh<N, T>& mesh, const Vec<N, T>& point);

template <Dim N, class T>
Vec<N, T> closest_point_of(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return detail::visit([&point](const auto& held) { return closest_point_of(held, point); }, shape);
}

template <Dim N, class T>
Vec<N, T> closest_point_of(const Compound<N, T>& compound, const Vec<N, T>& point) {
  if (is_held(compound, point)) return point;
  const DecidingPart found = deciding_part(compound, point);
  return found.index != DecidingPart::no_part ? closest_point_of(part_of(compound, found.index), point)
                                              : nowhere<N, T>();
}

/// That of the nearest face, which is faster to find with a `guess`; the point itself if the mesh contains it.
template <Dim N, class T>
Vec<N, T> closest_point_of_mesh(const Mesh<N, T>& mesh, const Vec<N, T>& point, std::size_t& guess) {
  if (is_inside(mesh, point)) return point;
  const DecidingPart found = deciding_part(mesh, point, guess);
  guess = found.index;
  if (found.index == DecidingPart::no_part) return nowhere<N, T>();
  if (is_on_face(mesh, point, found.distance)) return point;
  return closest_point_of(mesh.triangle(found.index), point);
}

template <Dim N, class T>
Vec<N, T> closest_point_of(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  std::size_t guess = DecidingPart::no_part;
  return closest_point_of_mesh(mesh, point, guess);
}

}  // namespace detail

/// The nearest point of a valid shape (asserted) to a point; the point itself if a solid contains it. If there are
/// several, the choice depends only on the arguments. For a compound without parts, or a mesh without
/// faces, every coordinate is NaN.
template <Shape S, PointIn<S> P = PointOf<S>>
P closest_point(const S& shape, const P& point) {
  assert(detail::is_accepted(shape));
  return detail::closest_point_of(shape, point);
}

GRAZE_DECLARE_INSTANCES(GRAZE_CLOSEST_POINT_INSTANCES)

}  // namespace graze
