// SPDX-License-Identifier: MIT
// ray_cast(shape, ray, t_max): where a ray first meets a shape, or where it leaves it; and the same for a segment.
//
// What finds it:
//
//   sphere, capsule, aabb, obb, triangle, polytope in 2D     closed form
//   plane, half-space                                        closed form
//   point, segment, ray                                      closed form
//   polytope in 3D, user's convex shape                      GJK, a few steps
//   compound                                                 part by part
//
// Whether there is a hit is what intersects(shape, ray) says, and for a segment intersects(shape, segment), always: all
// that nearly touches is decided by them. So a ray through the common edge or corner of two triangles hits both. For a
// finite t_max it is what they would say of the path up to there, in double.
//
// The normal points out of the shape, against the ray; on a set without thickness, to the side that the ray comes from.
// A ray that starts in a shape hits it at t = 0, and a ray that runs along a set without thickness where that begins;
// both have the normal against the ray's direction. At an exit the normal points out of the shape with the ray.
//
// `error` is a length: before it is rounded to T, the point is no farther than that from the shape's surface and from
// the ray, and before t the ray is nowhere deeper than that inside the shape. A few epsilon of double of the vectors
// from the origin to the shape and along it, however far from zero, for closed forms; of the largest coordinate for
// planes, half-spaces and what GJK finds (of T for a user's shape that calculates in T), where `status` says if it is
// more. t is as exact as that allows: at a grazing angle the way along the ray is longer. Coordinates of magnitude
// 1e-140 to 1e140, directions of any size; t may overflow or underflow T.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/ray_advance.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/query/ray_sight_box.hpp>
#include <graze/query/ray_sight_flat.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

template <Dim N, class T>
Ray<N, double> seen_from(const Vec<N, double>& origin, const Ray<N, T>& ray) {
  return {wide<N, T>(ray.origin) - origin, wide<N, T>(ray.direction)};
}

/// A shape with a closed form in double that sees it from the ray's origin.
template <class S>
concept HasRaySight = requires(const S& shape, const Vec<dimension_of<S>, double>& v) {
  sight_of(seen_from(v, shape), v, 0.0);
};

template <class S>
concept HasLevelSight = is_a<Plane, S> || is_a<HalfSpace, S>;

// ---- What the path is, as `relation` is asked about it

template <Dim N, class T>
struct AskAboutRay {
  template <class S>
  Relation operator()(const S& shape) const {
    return decide(shape, ray);
  }

  const Ray<N, T>& ray;
};

template <Dim N, class T>
struct AskAboutSegment {
  template <class S>
  Relation operator()(const S& shape) const {
    return decide(shape, segment);
  }

  const Segment<N, T>& segment;
};

/// A ray up to a finite t_max: all of it if it ends behind the shape, or else a segment, from its own origin where the
/// shape can be seen from there.
template <Dim N, class T>
struct AskAboutPart {
  template <class S>
  Relation operator()(const S& shape) const {
    const Vec<N, double> end = path.direction * path.t_max;
    if (!is_finite(end)) return decide(shape, ray);
    if constexpr (Convex<S>) {
      const Vec<N, double> reach = reach_to(ray, shape);
      if (dot(end, path.direction) > dot(reach, path.direction)) return decide(shape, ray);
    }
    if constexpr (HasRaySight<S>) {
      return decide(seen_from(path.origin, shape), Segment<N, double>{Vec<N, double>(0.0), end});
    } else if constexpr (HasLevelSight<S>) {
      return closed_form(shape, Segment<N, double>{path.origin, path.origin + end});
    } else {
      return relation_of_convex(Segment<N, double>{path.origin, path.origin + end}, shape);
    }
  }

  const Ray<N, T>& ray;
  const Path<N>& path;
};

// ---- One simple shape

/// What the shape's closed form says, its points where they belong.
template <class S>
Sighting<dimension_of<S>> sight(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasRaySight<S>) {
    Sighting<N> result = sight_of(seen_from(path.origin, shape), path.direction, path.t_max);
    result.touch.point += path.origin;
    return result;
  } else if constexpr (HasLevelSight<S>) {
    return sight_of_level(shape, path);
  } else if constexpr (N == 2 && is_a<Polytope, S>) {
    Sighting<N> result = sight_of_polygon<scalar_of<S>>(shape.vertices(), sum_abs(path.origin), path);
    result.touch.point += path.origin;
    return result;
  } else {
    return advance_to(shape, path);
  }
}

/// Where an unclear path touches, now that it is known to.
template <class S>
[[gnu::noinline]] Touch<dimension_of<S>> find_touch(const S& shape, const Path<dimension_of<S>>& path,
                                                    const Sighting<dimension_of<S>>& unclear) {
  if constexpr (Convex<S>) {
    if (!unclear.is_touch_known) {
      if constexpr (HasRaySight<S>) {
        const auto seen = seen_from(path.origin, shape);
        Touch<dimension_of<S>> touch = advance_to(seen, {path.origin - path.origin, path.direction, path.t_max}).touch;
        touch.point += path.origin;
        return touch;
      } else {
        return advance_to(shape, path).touch;
      }
    }
  }
  return unclear.touch;
}

template <class S, class Ask>
std::optional<Touch<dimension_of<S>>> entry_touch(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask) {
  const Sighting<dimension_of<S>> seen = sight(shape, path);
  if (seen.sight == Sight::misses) return std::nullopt;
  if (seen.sight == Sight::hits) return seen.touch;
  if (ask(shape) == Relation::apart) return std::nullopt;
  return find_touch(shape, path, seen);
}

/// A power of two that t can not reach before the path has left the shape; exact, so that turning the path round is.
template <class S>
double beyond(const S& shape, const Path<dimension_of<S>>& path) {
  constexpr Dim N = dimension_of<S>;
  const Ray<N, double> ray{path.origin, path.direction};
  const Aabb<N, scalar_of<S>> box = bounds(shape);
  const Vec<N, double> reach =
      reach_to(ray, Aabb<N, double>{wide<N, scalar_of<S>>(box.min), wide<N, scalar_of<S>>(box.max)});
  int exponent = 0;
  (void)std::frexp(max_abs(reach) / max_abs(path.direction), &exponent);
  return std::ldexp(1.0, exponent + 1);
}

/// The exit is the entry of the path turned round, from where it has left the shape.
template <class S, class Ask>
std::optional<Touch<dimension_of<S>>> exit_touch(const S& shape, const Path<dimension_of<S>>& path, const Ask& ask) {
  constexpr Dim N = dimension_of<S>;
  if constexpr (HasRaySight<S>) {
    const auto seen = seen_from(path.origin, shape);
    const double last = beyond(seen, {Vec<N, double>(0.0), path.direction, path.t_max});
    const Path<N> back{path.direction * last, -path.direction, last};
    auto touch = entry_touch(seen, back, [&](const auto&) { return ask(shape); });
    if (touch) {
      touch->t = last - touch->t;
      touch->point += path.origin;
    }
    return touch;
  } else {
    const double last = beyond(shape, path);
    auto touch = entry_touch(shape, Path<N>{path.origin + path.direction * last, -path.direction, last}, ask);
    if (touch) touch->t = last - touch->t;
    return touch;
  }
}

/// Never left: where a path leaves for good is then infinitely far away.
template <Dim N>
Touch<N> never() {
  return {std::numeric_limits<double>::infinity()};
}

/// A path meets a plane once, and leaves it there, but for one that runs along it.
template <Dim N, class T, class Ask>
std::optional<Touch<N>> exit_touch(const Plane<N, T>& plane, const Path<N>& path, const Ask& ask) {
  std::optional<Touch<N>> touch = entry_touch(plane, path, ask);
  if (touch && is_along(plane, path)) return never<N>();
  if (touch) touch->normal = -touch->normal;
  return touch;
}

/// A half-space is left if the path climbs, and never if not.
template <Dim N, class T, class Ask>
std::optional<Touch<N>> exit_touch(const HalfSpace<N, T>& solid, const Path<N>& path, const Ask& ask) {
  if (ask(solid) == Relation::apart) return std::nullopt;
  const Vec<N, double> normal = wide<N, T>(solid.normal);
  if (!(dot(normal, path.direction) > 0) || is_along(boundary(solid), path)) return never<N>();
  Touch<N> touch = touch_of_plane(boundary(solid), path);
  touch.normal = normal;
  return touch;
}

/// A ray on the same line is left at its origin, or never if it runs the same way; any other where it is met.
template <Dim N, class T, class Ask>
std::optional<Touch<N>> exit_touch(const Ray<N, T>& target, const Path<N>& path, const Ask& ask) {
  std::optional<Touch<N>> touch = entry_touch(target, path, ask);
  if (!touch) return std::nullopt;
  touch->normal = -touch->normal;
  const Vec<3, double> d = direction_of(Ray<N, double>{path.origin, path.direction});
  const Vec<3, double> e = direction_of(target);
  const double lengths = std::sqrt(length_squared(d) * length_squared(e));
  if (std::sqrt(length_squared(accurate_cross(d, e))) > tolerance::rounding * lengths) return touch;
  if (dot(d, e) > 0) return never<N>();
  const Sighting<N> origin = sight_of(wide<N, T>(target.origin) - path.origin, path.direction, path.t_max);
  return Touch<N>{origin.touch.t, wide<N, T>(target.origin), Vec<N, double>(0.0), touch->error};
}

/// A box's own coordinates, where the point is on a side or was rounded out of the box.
template <Dim N, class T>
void put_on_surface(Touch<N>& touch, const Aabb<N, T>& box) {
  const Vec<N, double> min = wide<N, T>(box.min);
  const Vec<N, double> max = wide<N, T>(box.max);
  for (Dim i = 0; i < N; ++i) {
    const double side = touch.normal[i];
    touch.point[i] = side < 0 ? min[i] : side > 0 ? max[i] : std::clamp(touch.point[i], min[i], max[i]);
  }
}

// ---- Any shape

template <class S, class Ask>
std::optional<Touch<dimension_of<S>>> find_hit(const S& shape, const Path<dimension_of<S>>& path, RaySide side,
                                               const Ask& ask) {
  std::optional<Touch<dimension_of<S>>> touch =
      side == RaySide::entry ? entry_touch(shape, path, ask) : exit_touch(shape, path, ask);
  if constexpr (is_a<Aabb, S>) {
    if (touch) put_on_surface(*touch, shape);
  }
  return touch;
}

template <Dim N, class T, class Ask>
std::optional<Touch<N>> find_hit(const AnyShape<N, T>& shape, const Path<N>& path, RaySide side, const Ask& ask);

/// Whether the path passes a part's box by far. The box of an unbounded part is never passed.
template <Dim N, class T>
bool passes_by(const Aabb<N, T>& box, const Path<N>& path) {
  if (!is_finite(box.min) || !is_finite(box.max)) return false;
  return touch_of_box(seen_from(path.origin, box), path.direction, path.t_max).sight == Sight::misses;
}

/// The nearest entry, or the farthest exit; of several the first part's. Once a part is hit, only what comes before
/// that is of interest.
template <Dim N, class T, class Ask>
std::optional<Touch<N>> find_hit(const Compound<N, T>& compound, const Path<N>& path, RaySide side, const Ask& ask) {
  std::optional<Touch<N>> best;
  Path<N> rest = path;
  for (const Part<N, T>& part : compound.parts) {
    if (passes_by(touching_bounds(part.box), rest)) continue;
    const std::optional<Touch<N>> touch = find_hit(part.shape, rest, side, ask);
    if (!touch) continue;
    if (best && !(side == RaySide::entry ? touch->t < best->t : touch->t > best->t)) continue;
    best = touch;
    if (side == RaySide::entry) rest.t_max = touch->t;
  }
  return best;
}

template <Dim N, class T, class Ask>
std::optional<Touch<N>> find_hit(const AnyShape<N, T>& shape, const Path<N>& path, RaySide side, const Ask& ask) {
  return std::visit([&](const auto& held) { return find_hit(held, path, side, ask); }, shape);
}

// ---- To and from T

/// A direction that can be squared, and how many times as long it is: a power of two, so that nothing is rounded.
template <Dim N, class T>
struct Usable {
  explicit Usable(const Ray<N, T>& given) : ray(given) {
    if constexpr (std::is_same_v<T, double>) {
      const double size = max_abs(given.direction);
      if (size > 0x1p-400 && size < 0x1p400) return;
      int exponent = 0;
      (void)std::frexp(size, &exponent);
      for (Dim i = 0; i < N; ++i) ray.direction[i] = std::ldexp(given.direction[i], -exponent);
      scale = std::ldexp(1.0, -exponent / 2);
      rest = std::ldexp(1.0, -exponent - (-exponent / 2));
    }
  }

  /// The same place in units of the usable direction, and back: in two steps, since the scale may be beyond a double.
  double to_usable(double t) const { return t / scale / rest; }
  double from_usable(double t) const { return t * scale * rest; }

  Ray<N, T> ray;
  double scale = 1;
  double rest = 1;
};

template <Dim N>
Vec<N, double> unit_of(const Vec<N, double>& direction) {
  return unit_or(direction, Vec<N, double>(0.0));
}

template <Dim N, Scalar T>
RayHit<N, T> rounded(const Touch<N>& touch, double t, const Vec<N, double>& against) {
  return {static_cast<T>(t) + T(0),  // never minus zero
          Vec<N, T>(touch.point) + T(0), Vec<N, T>(unit_or(touch.normal, against)) + T(0), touch.status, touch.error};
}

/// The hit of a path whose direction is not zero. An exit is looked for along the whole line, to be known for the last.
template <class S, class Ask>
std::optional<Touch<dimension_of<S>>> hit_on_path(const S& shape, const Path<dimension_of<S>>& path, RaySide side,
                                                  const Ask& ask) {
  if (side == RaySide::entry) return find_hit(shape, path, side, ask);
  Path<dimension_of<S>> whole = path;
  whole.t_max = std::numeric_limits<double>::infinity();
  auto touch = find_hit(shape, whole, side, ask);
  if (touch && (touch->t > path.t_max || std::isinf(touch->t))) return std::nullopt;
  return touch;
}

template <Dim N>
Vec<N, double> default_normal(const Vec<N, double>& direction, RaySide side) {
  return unit_of<N>(side == RaySide::entry ? -direction : direction);
}

}  // namespace detail

/// The space that a shape lives in, for the arguments that go with it.
template <Shape S>
using RayIn = Ray<dimension_of<S>, scalar_of<S>>;
template <Shape S>
using SegmentIn = Segment<dimension_of<S>, scalar_of<S>>;
template <Shape S>
using RayHitOn = RayHit<dimension_of<S>, scalar_of<S>>;

/// Where a valid ray (asserted) first meets a valid shape (asserted), or leaves it for good, at a t from 0 to t_max;
/// none if it does not. A ray that starts in the shape has its first point there, t = 0; one that never leaves, as in a
/// half-space, has no exit. The direction has any length but zero, and t is in units of it. A compound is the union of
/// its parts; its exit is the last of theirs. A negative t_max has no hits. The cheaper sibling is `intersects`.
template <Shape S>
std::optional<RayHitOn<S>> ray_cast(const S& shape, const RayIn<S>& ray,
                                    scalar_of<S> t_max = std::numeric_limits<scalar_of<S>>::infinity(),
                                    RayOptions options = {}) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  assert(detail::is_valid_if_known(shape) && is_valid(ray));
  if (!is_valid(ray) || !(t_max >= T(0))) return std::nullopt;
  const detail::Usable<N, T> usable(ray);
  const detail::Path<N> path{wide<N, T>(ray.origin), wide<N, T>(usable.ray.direction),
                             usable.to_usable(static_cast<double>(t_max))};
  const auto touch = std::isinf(t_max)
                         ? detail::hit_on_path(shape, path, options.side, detail::AskAboutRay<N, T>{usable.ray})
                         : detail::hit_on_path(shape, path, options.side, detail::AskAboutPart<N, T>{usable.ray, path});
  if (!touch) return std::nullopt;
  const double t = std::min(usable.from_usable(touch->t), static_cast<double>(t_max));
  return detail::rounded<N, T>(*touch, t, detail::default_normal(path.direction, options.side));
}

/// The same for a segment from its start, at t = 0, to its end, at t = 1. If the ends are equal, a hit is an entry with
/// a normal of zero.
template <Shape S>
std::optional<RayHitOn<S>> ray_cast(const S& shape, const SegmentIn<S>& segment, RayOptions options = {}) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  assert(detail::is_valid_if_known(shape) && is_valid(segment));
  if (!is_valid(segment)) return std::nullopt;
  const detail::AskAboutSegment<N, T> ask{segment};
  const Vec<N, double> start = wide<N, T>(segment.start);
  const Vec<N, double> edge = wide<N, T>(segment.end) - start;
  if (max_abs(edge) == 0) {
    if (options.side == RaySide::exit || ask(shape) == Relation::apart) return std::nullopt;
    return detail::rounded<N, T>(detail::Touch<N>{0, start}, 0, edge);
  }
  const auto touch = detail::hit_on_path(shape, detail::Path<N>{start, edge, 1}, options.side, ask);
  if (!touch) return std::nullopt;
  return detail::rounded<N, T>(*touch, touch->t, detail::default_normal(edge, options.side));
}

}  // namespace graze
