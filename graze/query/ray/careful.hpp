// SPDX-License-Identifier: MIT
// The precise algorithm of ray_cast.hpp, for every shape and for all rays that its filters leave undecided. Include
// ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/ray/advance.hpp>
#include <graze/query/ray/parts.hpp>
#include <graze/query/ray/simple_shape.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray/verdict_2d.hpp>
#include <graze/query/ray/verdict_box.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

// ---- Any shape

template <class S, class Ask>
RayFinding<dimension_of<S>> find_hit(const S& shape, const Path<dimension_of<S>>& path, RaySide side, const Ask& ask) {
  if (side == RaySide::exit) return exit(shape, path, ask);
  return entry(shape, path, ask);
}

template <Dim N, class T, class Ask>
RayFinding<N> find_hit(const Aabb<N, T>& box, const Path<N>& path, RaySide side, const Ask& ask) {
  RayFinding<N> result = side == RaySide::exit ? exit(box, path, ask) : entry(box, path, ask);
  if (result.verdict == RayVerdict::hits) put_on_surface(result.hit, box);
  return result;
}

template <Dim N, class T, class Ask>
RayFinding<N> find_hit(const AnyShape<N, T>& shape, const Path<N>& path, RaySide side, const Ask& ask);

/// The nearest entry, or the farthest exit; of several equal ones the first part's. After a hit only parts whose box is
/// entered before it matter, but each is evaluated as if it were alone.
template <HasParts Whole, Dim N, class Ask>
RayFinding<N> find_hit_of_parts(const Whole& whole, const Path<N>& path, RaySide side, const Ask& ask) {
  RayFinding<N> best = missed<N>();
  FirstPart first;
  RestOfPath<N> rest(path);
  visit_parts(whole, rest, ByKey(), [&](const auto& part, std::size_t index) {
    const RayFinding<N> found = find_hit(part.shape, path, side, ask);
    const double t = side == RaySide::entry ? found.hit.t : -found.hit.t;
    if (found.verdict == RayVerdict::misses || !first.is_replaced_by(t, index)) return true;
    best = found;
    if (side == RaySide::entry) rest.end_at(found.hit.t);
    return true;
  });
  return best;
}

template <Dim N, class T, class Ask>
RayFinding<N> find_hit(const Compound<N, T>& compound, const Path<N>& path, RaySide side, const Ask& ask) {
  return find_hit_of_parts(compound, path, side, ask);
}

template <Dim N, class T, class Ask>
RayFinding<N> find_hit(const Mesh<N, T>& mesh, const Path<N>& path, RaySide side, const Ask& ask) {
  if (side == RaySide::entry && is_inside(mesh, Vec<N, T>(path.origin))) {
    return {RayVerdict::hits, {0, path.origin}};
  }
  return find_hit_of_parts(mesh, path, side, ask);
}

template <Dim N, class T, class Ask>
RayFinding<N> find_hit(const AnyShape<N, T>& shape, const Path<N>& path, RaySide side, const Ask& ask) {
  return detail::visit([&](const auto& held) { return find_hit(held, path, side, ask); }, shape);
}

// ---- To and from T

/// The normal if the shape has none: against the ray at an entry, along it at an exit.
template <Dim N>
Vec<N, double> default_normal(const Vec<N, double>& direction, RaySide side) {
  return unit_or(side == RaySide::entry ? -direction : direction, Vec<N, double>(0.0));
}

template <Dim N, Scalar T>
[[gnu::always_inline]] inline RayHit<N, T> rounded(const RawHit<N>& hit, double t, const Vec<N, double>& direction,
                                                   RaySide side) {
  const double squared = dot(hit.normal, hit.normal);
  const Vec<N, double> normal = squared > 0x1p-900 && squared < 0x1p900
                                    ? hit.normal / std::sqrt(squared)  // squaring does not underflow
                                    : unit_or(hit.normal, default_normal(direction, side));
  return {static_cast<T>(t) + T(0),  // never minus zero
          Vec<N, T>(hit.point) + T(0), Vec<N, T>(normal) + T(0), hit.status, hit.error};
}

/// The precise algorithm, if it is needed.
template <class S, class Ask>
[[gnu::noinline]] RayFinding<dimension_of<S>> find_carefully(const S& shape, const Path<dimension_of<S>>& path,
                                                             RaySide side, const Ask& ask) {
  const RayFinding<dimension_of<S>> result = find_hit(shape, path, side, ask);
  const bool is_in_time = result.hit.t <= path.t_max && result.hit.t < std::numeric_limits<double>::infinity();
  return side == RaySide::entry || is_in_time ? result : missed<dimension_of<S>>();
}

/// The hit in T, for a direction that is not zero, of a path that ends at `end`: if it misses the shape up to its
/// t_max, by more than rounding, nothing else is evaluated. Most rays take the fast path, on which everything stays in
/// registers: copies of freshly written memory would take longer than the closed forms.
template <class S, class Ask>
[[gnu::always_inline]] inline auto cast_along(const S& shape, const Path<dimension_of<S>>& path, double end,
                                              RaySide side, const Ask& ask) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  using Hit = std::optional<RayHit<N, T>>;
  constexpr bool has_closed_form = HasRayVerdict<S> || HasBoundaryVerdict<S>;
  if constexpr (!HasParts<S> && !is_any_shape<S>) {
    if (side == RaySide::entry && (has_closed_form || path.t_max < end)) {
      if constexpr (HasQuickMiss<S>) {
        if (is_missed(relative_to(path.origin, shape), path)) return Hit();
      }
      RayFinding<N> quick = verdict(shape, path);
      if (quick.verdict == RayVerdict::misses) return Hit();
      // How precisely a capsule's closed form knows the distance depends on the end of the path.
      const bool is_integer = !is_a<Capsule, S> || path.t_max == end;
      if (quick.verdict == RayVerdict::hits && is_integer) {
        if constexpr (!has_closed_form) quick = confirmed(shape, ask, quick);
        if (quick.verdict == RayVerdict::misses) return Hit();
        if constexpr (is_a<Aabb, S>) put_on_surface(quick.hit, shape);
        return Hit(rounded<N, T>(quick.hit, quick.hit.t, path.direction, side));
      }
    }
  }
  const RayFinding<N> found = find_carefully(shape, Path<N>{path.origin, path.direction, end, path.far}, side, ask);
  if (found.verdict == RayVerdict::misses) return Hit();
  return Hit(rounded<N, T>(found.hit, found.hit.t, path.direction, side));
}

/// Shapes of which all lengths are relative to the ray's origin.
template <class S>
inline constexpr bool is_seen_from_ray = is_point<S> || is_core<S> || is_a<Triangle, S>;

/// Shapes whose closed form calculates a size, from which cast_usable_ray knows whether they are in range.
template <class S>
inline constexpr bool is_sized_by_closed_form = is_a<Triangle, S>&& dimension_of<S> == 3;

/// Whether a plane or half-space and points up to a distance from the coordinate origin are of usual size.
template <class S>
bool are_usual_beside(const S& boundary, double distance) {
  using T = scalar_of<S>;
  return is_usual_size<T>(distance + std::fabs(static_cast<double>(boundary.offset))) && has_usual_normal(boundary);
}

/// Whether a ray or segment can be cast at a shape without scaling.
template <class S, Dim N, class T>
[[gnu::always_inline]] inline bool can_be_cast(const S& shape, const Ray<N, T>& ray) {
  if constexpr (is_seen_from_ray<S>) {
    return is_usual_size<T>(sum_abs(farthest_from(ray.origin, shape))) && is_usable(ray.direction);
  } else if constexpr (HasBoundaryVerdict<S>) {
    return are_usual_beside(shape, sum_abs(ray.origin)) && is_usable(ray.direction);
  } else {
    return are_usual(shape, ray);
  }
}
template <class S, Dim N, class T>
[[gnu::always_inline]] inline bool can_be_cast(const S& shape, const Segment<N, T>& segment) {
  const Vec<N, double> edge = wide<N, T>(segment.end) - wide<N, T>(segment.start);
  if constexpr (is_seen_from_ray<S>) {
    return is_usual_size<T>(sum_abs(farthest_from(segment.start, shape)) + sum_abs(edge));
  } else if constexpr (HasBoundaryVerdict<S>) {
    return are_usual_beside(shape, sum_abs(segment.start) + sum_abs(edge));
  } else {
    return are_usual(shape, segment);
  }
}

/// cast(shape, ray, t_max) for a shape and a ray that are out of range; none for others.
template <class S, Dim N, class Cast>
[[gnu::noinline, gnu::cold]] std::optional<std::optional<RayHit<N, double>>> unusual_hit(const S& shape,
                                                                                         const Ray<N, double>& ray,
                                                                                         double t_max,
                                                                                         const Cast& cast) {
  using Hit = std::optional<RayHit<N, double>>;
  return answer_in_range<Hit>(
      [&](const PowerOfTwo& power, const auto& scaled_shape, const auto& scaled_ray) {
        const PowerOfTwo of_t(power.exponent() + unusual_exponent_of(ray.direction));
        Hit hit = cast(scaled_shape, scaled_ray, of_t(t_max));
        if (!hit || !is_finite(hit->point)) return Hit();  // or the point is not representable
        hit->t = std::min(of_t.inverse()(hit->t), t_max);
        hit->point = power.inverse()(hit->point);
        hit->error = power.inverse()(hit->error);
        return hit;
      },
      shape, ray);
}

/// The same, for shapes and rays of any kind.
template <class S, Dim N, class T, class Cast>
[[gnu::always_inline]] inline std::optional<std::optional<RayHit<N, T>>> hit_in_range(
    const S& shape, const Ray<N, T>& ray, T t_max, [[maybe_unused]] const Cast& cast) {
  if constexpr (can_leave_range<S> && !is_sized_by_closed_form<S>) {
    if (!can_be_cast(shape, ray)) return unusual_hit(shape, ray, t_max, cast);
  }
  return std::nullopt;
}

template <class S, Dim N, class T>
[[gnu::always_inline]] inline std::optional<RayHit<N, T>> cast_ray(const S& shape, const Ray<N, T>& ray, T t_max,
                                                                   RaySide side);

/// The hit of a shape that is sized by its closed form, if it and the ray are out of range; none for others.
template <class S, Dim N>
[[gnu::noinline, gnu::cold]] std::optional<std::optional<RayHit<N, double>>> unusual_hit_of_sized(
    const S& shape, const Ray<N, double>& ray, double t_max, RaySide side) {
  return unusual_hit(shape, ray, t_max, [side](const auto& scaled_shape, const auto& scaled_ray, double scaled_t) {
    return cast_ray(scaled_shape, scaled_ray, scaled_t, side);
  });
}

/// The precise algorithm for a ray. Not inlined, so that the fast path does not share stack memory with it.
template <class S, Dim N, class T>
[[gnu::noinline]] std::optional<RayHit<N, T>> cast_usable_ray(const S& shape, const Ray<N, T>& ray, double t_max,
                                                              RaySide side) {
  constexpr double forever = std::numeric_limits<double>::infinity();
  // A plane parallel to a ray, up to rounding, is not met, although the ray may cross it far away.
  const Path<N> path{wide<N, T>(ray.origin), wide<N, T>(ray.direction), HasBoundaryVerdict<S> ? forever : t_max};
  if constexpr (can_leave_range<S> && is_sized_by_closed_form<S>) {
    const auto seen = relative_to(ray.origin, shape);
    const double size = largest_corner(seen);
    constexpr double no_product_overflows = 0x1p200;
    // A miss is certain even if products underflow: TriangleBesidePath::least_band.
    if (side == RaySide::entry && size < no_product_overflows && is_missed(seen, path)) return std::nullopt;
    if (!is_usual_size<T>(size)) {
      const auto rescaled = unusual_hit_of_sized(shape, ray, t_max, side);
      if (rescaled) return *rescaled;
    }
  }
  return cast_along(shape, path, forever, side, AskAboutRay<N, T>{ray});
}

/// For a direction that cannot be squared.
template <class S, Dim N>
[[gnu::noinline, gnu::cold]] std::optional<RayHit<N, double>> cast_unusable_ray(const S& shape,
                                                                                const Ray<N, double>& ray, double t_max,
                                                                                RaySide side) {
  if constexpr (is_sized_by_closed_form<S>) {
    if (const auto rescaled = unusual_hit_of_sized(shape, ray, t_max, side)) return *rescaled;
  }
  const Usable<N, double> usable(ray);
  auto hit = cast_usable_ray(shape, usable.ray, usable.to_usable(t_max), side);
  if (hit) hit->t = usable.from_usable(hit->t);
  if (is_after(hit, t_max)) hit.reset();
  return hit;
}

template <class S, Dim N, class T>
[[gnu::always_inline]] inline std::optional<RayHit<N, T>> cast_ray(const S& shape, const Ray<N, T>& ray, T t_max,
                                                                   RaySide side) {
  if (!(t_max >= T(0)) || std::isnan(numbers_of(ray))) return std::nullopt;
  if constexpr (std::is_same_v<T, double>) {
    if (!is_usable(ray.direction)) return cast_unusable_ray(shape, ray, t_max, side);
  }
  auto hit = cast_usable_ray(shape, ray, latest_t(t_max), side);
  if (is_after(hit, t_max)) hit.reset();
  return hit;
}

}  // namespace graze::detail
