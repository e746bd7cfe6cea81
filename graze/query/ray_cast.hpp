// SPDX-License-Identifier: MIT
/// @file
/// ray_cast(shape, ray, t_max): where a ray or a segment first meets a shape, or where it leaves the shape.
///
/// What finds it:
///
///     sphere, capsule, aabb, obb, triangle, polytope in 2D     closed form
///     plane, half-space                                        closed form
///     point, segment, ray                                      closed form
///     polytope in 3D                                           the face that the ray passes, found among the corners
///     user's convex shape in 3D                                GJK, a few steps; also for rays in a triangle's plane,
///                                                              nearly along a capsule's axis, from inside a polytope
///                                                              in 3D, or nearly at its edges
///     compound                                                 part by part
///     mesh                                                     face by face
///
/// Filters, in query/ray/filter, decide most rays: the closed form with plain sums, or in float. Close cases are left
/// to the careful calculation, query/ray/careful.hpp.
///
/// There is a hit if and only if intersects(shape, ray), or for a segment intersects(shape, segment), is true: it
/// decides near misses, which then hit where the ray comes nearest. So a ray through the common edge or corner of two
/// triangles hits both. A finite t_max hides hits beyond it and changes nothing else: ray_cast(shape, ray, t_max) is
/// ray_cast(shape, ray), to the bit, if that has t <= t_max, and otherwise none.
///
/// The normal points out of the shape, against the ray; on a set without thickness, to the side from which the ray
/// comes. A ray that starts in a shape hits it at t = 0; a ray that runs along a set without thickness hits it where
/// the set begins. Both have the normal against the ray's direction. At an exit the normal points out of the shape,
/// along the ray.
///
/// `error` is a length: before rounding to T, the point is at most that far from the shape's surface and from the ray,
/// and before t the ray is nowhere deeper than that inside the shape. For closed forms it is a few epsilon of double of
/// the vectors from the origin to the shape and along it, however far from zero; for planes, half-spaces, 3D polytopes
/// and GJK it is a few epsilon of the largest coordinate (of T for a user's shape that calculates in T), and `status`
/// tells if it is more. The error of t is larger at a grazing angle, where the way along the ray is longer. Coordinates
/// and directions may be any finite numbers; see range.hpp for sizes that differ by more than a factor of 2^900. t may
/// overflow or underflow T.
#pragma once

#include <cassert>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/ray/careful.hpp>
#include <graze/query/ray/filters.hpp>
#include <graze/query/ray/parts.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

template <class S>
concept HoldsAnyShape = std::is_same_v<S, AnyShape<dimension_of<S>, scalar_of<S>>>;

/// For rays that a filter leaves open, perhaps only because the ray ends there; then the whole ray is clear.
template <class S, Dim N, class T>
[[gnu::noinline]] std::optional<RayHit<N, T>> first_hit_of_unclear(const S& shape, const Ray<N, T>& ray, T t_max) {
  constexpr T forever = std::numeric_limits<T>::infinity();
  if (t_max < forever) {
    const auto whole = quick_cast(shape, ray, forever);
    if (whole.verdict() == RayVerdict::hits) {
      std::optional<RayHit<N, T>> hit = whole.hit();
      if (is_after(hit, t_max)) hit.reset();
      return hit;
    }
  }
  return cast_ray(shape, ray, t_max, RaySide::entry);
}

template <class S, Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const S& shape, const Ray<N, T>& ray, T t_max);

/// The first hit, after filters if there are any.
template <class S, Dim N, class T>
[[gnu::always_inline]] inline std::optional<RayHit<N, T>> first_hit_in_range(const S& shape, const Ray<N, T>& ray,
                                                                             T t_max) {
  const auto rescaled =
      hit_in_range(shape, ray, t_max, [](const auto& scaled_shape, const auto& scaled_ray, T scaled_t) {
        return first_hit(scaled_shape, scaled_ray, scaled_t);
      });
  if (rescaled) return *rescaled;
  if constexpr (HasQuickCast<S>) {
    return first_hit_of_unclear(shape, ray, t_max);
  } else {
    return cast_ray(shape, ray, t_max, RaySide::entry);
  }
}

/// The first hit of a ray that no filter decides.
template <class S, Dim N, class T>
[[gnu::noinline]] std::optional<RayHit<N, T>> careful_first_hit(const S& shape, const Ray<N, T>& ray, T t_max) {
  return first_hit_in_range(shape, ray, t_max);
}

template <class S, Dim N, class T>
[[gnu::always_inline]] inline std::optional<RayHit<N, T>> first_hit(const S& shape, const Ray<N, T>& ray, T t_max) {
  if constexpr (HasQuickCast<S>) {
    const auto quick = quick_cast(shape, ray, t_max);
    if (quick.verdict() == RayVerdict::misses) return std::nullopt;
    if (quick.verdict() == RayVerdict::hits) return quick.hit();
    return careful_first_hit(shape, ray, t_max);
  } else {
    return first_hit_in_range(shape, ray, t_max);
  }
}

template <Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const Compound<N, T>& compound, const Ray<N, T>& ray, T t_max);
template <Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const Mesh<N, T>& mesh, const Ray<N, T>& ray, T t_max);

template <Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const AnyShape<N, T>& shape, const Ray<N, T>& ray, T t_max) {
  return detail::visit([&](const auto& held) { return first_hit(held, ray, t_max); }, shape);
}

/// The parts that may be met by the rest of a path, which `visit` may shorten, in about the order in which it meets
/// them.
template <HasParts Whole, Dim N, class Visit>
void visit_parts_along(const Whole& whole, const Path<N>& path, const RestOfPath<N>& rest, const Visit& visit) {
  if (is_usable(path.direction)) {
    visit_parts(whole, rest, ByKey(), visit);
  } else {
    visit_parts(whole, AnyPart(), visit);
  }
}

/// The nearest hit of the parts, of several the first part's; remember(part, index) is called for each that is the
/// nearest so far. After a hit, only parts with their box before it matter, but each is tested as if it were alone.
template <HasParts Whole, Dim N, class T, class Remember>
std::optional<RayHit<N, T>> first_hit_of_parts(const Whole& whole, const Ray<N, T>& ray, T t_max,
                                               const Remember& remember) {
  std::optional<RayHit<N, T>> best;
  FirstPart first;
  const Path<N> path{wide<N, T>(ray.origin), wide<N, T>(ray.direction), latest_t(t_max)};
  RestOfPath<N> rest(path);
  const auto visit = [&](const auto& part, std::size_t index) {
    const std::optional<RayHit<N, T>> found = first_hit(part.shape, ray, t_max);
    if (!found || !first.is_replaced_by(static_cast<double>(found->t), index)) return true;
    best = found;
    remember(part, index);
    rest.end_at(latest_t(found->t));
    return true;
  };
  visit_parts_along(whole, path, rest, visit);
  return best;
}

template <Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const Compound<N, T>& compound, const Ray<N, T>& ray, T t_max) {
  return first_hit_of_parts(compound, ray, t_max, [](const Part<N, T>&, std::size_t) {});
}

/// A hit of a mesh, and the face that is hit.
template <Dim N, class T>
struct HitFace {
  std::optional<RayHit<N, T>> hit;
  std::size_t index = no_face;
  Triangle<N, T> face{};
};

/// A ray that starts inside a solid hits no face, but what is inside.
template <Dim N, class T>
HitFace<N, T> first_hit_of_mesh(const Mesh<N, T>& mesh, const Ray<N, T>& ray, T t_max) {
  HitFace<N, T> found;
  if (is_inside(mesh, ray.origin)) {
    const RawHit<N> at_start{0, wide<N, T>(ray.origin)};
    if (t_max >= T(0)) found.hit = rounded<N, T>(at_start, 0, wide<N, T>(ray.direction), RaySide::entry);
    return found;
  }
  found.hit = first_hit_of_parts(mesh, ray, t_max, [&](const FacePart<N, T>& face, std::size_t index) {
    found.index = index;
    found.face = face.shape;
  });
  return found;
}

template <Dim N, class T>
std::optional<RayHit<N, T>> first_hit(const Mesh<N, T>& mesh, const Ray<N, T>& ray, T t_max) {
  return first_hit_of_mesh(mesh, ray, t_max).hit;
}

/// Where a ray leaves a shape for good.
template <class S, Dim N, class T>
[[gnu::noinline]] std::optional<RayHit<N, T>> last_hit(const S& shape, const Ray<N, T>& ray, T t_max) {
  const auto rescaled =
      hit_in_range(shape, ray, t_max, [](const auto& scaled_shape, const auto& scaled_ray, T scaled_t) {
        return last_hit(scaled_shape, scaled_ray, scaled_t);
      });
  if (rescaled) return *rescaled;
  if constexpr (HoldsAnyShape<S>) {
    return detail::visit([&](const auto& held) { return cast_ray(held, ray, t_max, RaySide::exit); }, shape);
  } else {
    return cast_ray(shape, ray, t_max, RaySide::exit);
  }
}

/// The exit of a mesh is that of one of its faces, to the bit.
template <Dim N, class T>
HitFace<N, T> last_hit_of_mesh(const Mesh<N, T>& mesh, const Ray<N, T>& ray, T t_max) {
  HitFace<N, T> found;
  found.hit = last_hit(mesh, ray, t_max);
  if (!found.hit) return found;
  const Path<N> path{wide<N, T>(ray.origin), wide<N, T>(ray.direction), latest_t(t_max)};
  visit_parts_along(mesh, path, RestOfPath<N>(path), [&](const FacePart<N, T>& face, std::size_t index) {
    if (index < found.index && last_hit(face.shape, ray, t_max) == found.hit) {
      found.index = index;
      found.face = face.shape;
    }
    return true;
  });
  return found;
}

}  // namespace detail

/// A ray with the dimension and number type of a shape.
template <Shape S>
using RayIn = Ray<dimension_of<S>, scalar_of<S>>;
/// A segment with the dimension and number type of a shape.
template <Shape S>
using SegmentIn = Segment<dimension_of<S>, scalar_of<S>>;
/// A hit with the dimension and number type of a shape.
template <Shape S>
using RayHitOn = RayHit<dimension_of<S>, scalar_of<S>>;

/// Where a valid ray (asserted) first meets a valid shape (asserted), or leaves it for good, at a t from 0 to t_max;
/// none if it does not. The direction may have any nonzero length, which is the unit of t. A ray that starts in the
/// shape enters at t = 0; one that never leaves, as in a half-space, has no exit. A compound is the union of its parts;
/// its exit is the last of theirs. A negative t_max has no hits. `intersects` is cheaper if only the yes or no matters.
template <Shape S>
std::optional<RayHitOn<S>> ray_cast(const S& shape, const RayIn<S>& ray,
                                    scalar_of<S> t_max = std::numeric_limits<scalar_of<S>>::infinity(),
                                    RayOptions options = {}) {
  assert(detail::is_valid_if_known(shape) && is_valid(ray));
  return options.side == RaySide::entry ? detail::first_hit(shape, ray, t_max) : detail::last_hit(shape, ray, t_max);
}

/// The same query for a segment: t is 0 at its start and 1 at its end. If the ends are equal, a hit has a normal of
/// zero, and there is no exit.
template <Shape S>
std::optional<RayHitOn<S>> ray_cast(const S& shape, const SegmentIn<S>& segment, RayOptions options = {}) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  assert(detail::is_valid_if_known(shape) && is_valid(segment));
  if constexpr (detail::can_leave_range<S>) {
    if (!detail::can_be_cast(shape, segment)) {
      using Hit = std::optional<RayHitOn<S>>;
      const auto rescaled = detail::answer_in_range<Hit>(
          [options](const auto& power, const auto& scaled_shape, const auto& scaled_segment) {
            Hit hit = ray_cast(scaled_shape, scaled_segment, options);
            if (!hit) return hit;
            hit->point = power.inverse()(hit->point);
            hit->error = power.inverse()(hit->error);
            return hit;
          },
          shape, segment);
      if (rescaled) return *rescaled;
    }
  }
  const detail::AskAboutSegment<N, T> ask{segment};
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> edge = wide<N, T>(segment.end) - start;
  if (max_abs(edge) == 0) {
    if (options.side == RaySide::exit || ask(shape) == Relation::apart) return std::nullopt;
    return detail::rounded<N, T>({0, start}, 0, edge, options.side);
  }
  return detail::cast_along(shape, detail::Path<N>{start, edge, 1, sum_abs(edge)}, 1, options.side, ask);
}

/// The same for a mesh, and the face that is hit; of several at the same t the one with the least index. A ray through
/// a common edge or corner of faces hits them, so none passes between two faces that share it. A ray that starts inside
/// a solid hits no face, but enters at t = 0.
template <Shape S>
requires detail::is_mesh<S> std::optional<MeshHit<dimension_of<S>, scalar_of<S>>> ray_cast(
    const S& mesh, const RayIn<S>& ray, scalar_of<S> t_max = std::numeric_limits<scalar_of<S>>::infinity(),
    RayOptions options = {}) {
  assert(is_valid(ray));
  const auto found = options.side == RaySide::entry ? detail::first_hit_of_mesh(mesh, ray, t_max)
                                                    : detail::last_hit_of_mesh(mesh, ray, t_max);
  if (!found.hit) return std::nullopt;
  MeshHit<dimension_of<S>, scalar_of<S>> hit{*found.hit};
  if (found.index == no_face) return hit;
  hit.face = found.index;
  hit.barycentric = detail::barycentric_of(found.face, hit.point);
  return hit;
}

GRAZE_DECLARE_INSTANCES(GRAZE_RAY_CAST_INSTANCES)

}  // namespace graze
