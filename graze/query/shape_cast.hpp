// SPDX-License-Identifier: MIT
/// @file
/// shape_cast(a, motion, b): when and where a shape that translates along a vector first touches another one.
///
/// What finds it. C: closed form, with GJK for near misses. S: the supports along the plane's normal, a closed form for
/// every convex shape. P: part by part. G: GJK, a few steps. C/G: C in 2D, G in 3D.
///
///                 segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
///     point          C     C    C     C    C    S       S         C        C      C/G       P       G
///     segment       C/G   C/G   C     C    C    S       S         G        C       G        P       G
///     ray                  C    C     C    C    S       S         G        C       G        P       G
///     sphere                    C     C    C    S       S         G        C       G        P       G
///     aabb                            C    C    S       S         G        C       G        P       G
///     obb                                  C    S       S         G        C       G        P       G
///     plane                                     S       S         S        S       S        P       S
///     half-space                                        S         S        S       S        P       S
///     triangle                                                    G        G       G        P       G
///     capsule                                                              C       G        P       G
///     polytope                                                                     G        P       G
///     compound                                                                              P       P
///
/// For a point, the result is that of ray_cast.hpp for the ray from the point along `motion` with t_max = 1, near
/// misses included; so are those at t = 1, where rounding hides whether the point arrives. Any two shapes become a ray
/// from zero and the Minkowski difference b - a: a sphere and a capsule make a capsule, two axis-aligned boxes a box,
/// and segments and boxes a zonotope (see zonotope_cast.hpp), with round edges if one of them is the core of a capsule
/// or a sphere. The set of any two convex shapes has support points.
///
/// Shapes that meet at the start, as relation(a, b) decides, have contact(a, b) as the impact, at t = 0. Later, the
/// normal is that of a plane with a on one side at t and b on the other, and a has moved towards it. Shapes that touch
/// along a face or an edge return one of many points; it is as near to both as closest_points.hpp states. A compound
/// counts as its first part to touch.
///
/// CastOptions::target_distance: the cast stops when the shapes are as near as that, at t = 0 if they are at the start.
/// The point is then the nearest one of b's surface, and the normal points to it from the nearest one of a; shapes that
/// meet at the start have their contact.
///
/// CastOptions::ignore_initial_touch: a touch stops the cast only if the motion approaches it, that is, takes the
/// shapes deeper into each other, by the normal of the contact. At the start this decides about shapes that overlap as
/// well: moving out or sideways is free, moving deeper is an impact at t = 0. A touch on the way is not approached if
/// the shapes then only graze each other, as the next tile of a floor is grazed. With a target distance, the same is
/// meant of shapes that are as near as that. A convex shape that has not been approached is not touched later either.
/// Each part of a compound is decided by itself, so a floor does not hide a wall; of parts that are hit at t = 0 the
/// deepest one counts. A motion approaches a surface if its angle to it is above 2^-40, for float 4 epsilon; so shapes
/// may pass into each other by that share of the motion, plus the error. If no translation separates shapes, nothing
/// approaches them. Planes and half-spaces are decided by the normal alone.
///
/// `error` is a length: at t, before rounding to T, the shapes are at most that far apart, and before t they are
/// nowhere deeper in each other. For closed forms of bounded shapes, and shapes without curved faces, it is a few
/// epsilon of double of the coordinates relative to a or b, the motion's included; for planes, half-spaces, polytopes
/// and users' shapes a few epsilon of the largest coordinate (of T for those that calculate in T); for nearly parallel
/// rays also of where they touch, which may be far away. `status` tells if GJK could not come that near. At a grazing
/// angle t is less exact than the distance. With a target distance, it bounds the deviation of the distance from that,
/// before rounding, and the target counts as a coordinate. Coordinates may be any finite numbers; see range.hpp for
/// sizes that differ by more than a factor of 2^900.
#pragma once

#include <cassert>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/cast/approach.hpp>
#include <graze/query/cast/cast_hit.hpp>
#include <graze/query/cast/moving_parts.hpp>
#include <graze/query/cast/pair_cast.hpp>
#include <graze/query/cast_options.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

/// The default CastOptions. A type of its own, so that plain casts do not calculate with them.
struct NoCastOptions {
  constexpr operator CastOptions() const { return {}; }

  static constexpr NoTarget target_distance{};
};

/// `Options` is CastOptions or NoCastOptions.
template <class A, class B, class Options = NoCastOptions>
std::optional<CastHit<dimension_of<A>>> cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b,
                                                 const Options& options = {});

/// The impact of shapes that are out of range, if there is one; none for others.
template <class A, class B>
auto cast_hit_in_range(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b, const CastOptions& options) {
  constexpr Dim N = dimension_of<A>;
  return answer_in_range<std::optional<CastHit<N>>>(
      [&options](const auto& power, const auto& scaled_a, const auto& scaled_motion, const auto& scaled_b,
                 const auto& scaled_target) {
        const CastOptions scaled_options{options.ignore_initial_touch, max_abs(scaled_target)};
        return resized(cast_hit(scaled_a, scaled_motion, scaled_b, scaled_options), power.inverse());
      },
      a, motion, b, Vec<N, double>(options.target_distance));
}

/// For two simple shapes that are farther apart than the target.
template <class A, class B, class Target>
std::optional<CastHit<dimension_of<A>>> cast_hit_in_any_order(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                              const B& b, Target target) {
  if constexpr (are_exchanged<A, B>) {
    return exchanged_cast_hit(a, motion, b, target);
  } else {
    if constexpr (are_in_either_order<A, B>) {
      if (!is_in_order(a, b)) return exchanged_cast_hit(a, motion, b, target);
    }
    return cast_hit_in_order(a, motion, b, target);
  }
}

/// The same with the depth.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_up_to(const A& a, const Vec<dimension_of<A>, double>& motion,
                                                       const B& b, double target) {
  auto found = cast_hit_in_any_order(a, motion, b, target);
  if (found && target > 0) found->depth = -target;
  return found;
}

/// For two simple shapes; not for a touch that is not approached. While convex shapes translate, they touch only once.
template <class A, class B>
[[gnu::noinline]] std::optional<CastHit<dimension_of<A>>> cast_hit_approached(
    const A& a, const Vec<dimension_of<A>, double>& motion, const B& b, double target) {
  const auto start = penetration_within(a, b, target);
  auto found = start ? cast_hit_at_start(*start) : cast_hit_up_to(a, motion, b, target);
  if (!found) return found;
  const bool is_near = !start && found->t * sum_abs(motion) <= found->error;
  if ((is_near && !is_shortened(a, motion, b)) || !is_approached(a, motion, b, target, *found)) found.reset();
  return found;
}

/// For a nonzero motion, and for shapes that are farther apart than the target unless the initial touch is ignored.
template <class A, class B, class Options>
std::optional<CastHit<dimension_of<A>>> cast_hit(const A& a, const Vec<dimension_of<A>, double>& motion, const B& b,
                                                 const Options& options) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&](const auto& held) { return cast_hit(held, motion, b, options); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&](const auto& held) { return cast_hit(a, motion, held, options); }, b);
  } else if constexpr (HasParts<A>) {
    return cast_hit_of_parts(a, motion, b, options.target_distance,
                             [&](const auto& part) { return cast_hit(part, motion, b, options); });
  } else if constexpr (HasParts<B>) {
    return cast_hit_of_parts(b, -motion, a, options.target_distance,
                             [&](const auto& part) { return cast_hit(a, motion, part, options); });
  } else {
    if (any_nan(a, b)) return std::nullopt;
    const auto target = options.target_distance;
    if (!are_usual(a, b, motion, Vec<dimension_of<A>, double>(target))) {
      if (const auto rescaled = cast_hit_in_range(a, motion, b, options)) return *rescaled;
    }
    if constexpr (std::is_same_v<Options, NoCastOptions>) {
      return cast_hit_in_any_order(a, motion, b, target);
    } else {
      if (options.ignore_initial_touch) return cast_hit_approached(a, motion, b, target);
      return cast_hit_up_to(a, motion, b, target);
    }
  }
}

/// shape_cast for shapes that need not be valid.
template <class A, class B, class Options = NoCastOptions>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> impact_of(const A& a,
                                                               const Vec<dimension_of<A>, scalar_of<A>>& motion,
                                                               const B& b, const Options& options = {}) {
  using T = scalar_of<A>;
  if (!is_finite(motion)) return std::nullopt;
  if (!CastOptions(options).ignore_initial_touch) {
    const auto contact = penetration_within(a, b, options.target_distance);
    if (contact) return rounded_impact<T>(cast_hit_at_start(*contact));
  }
  if (max_abs(motion) == T(0)) return std::nullopt;
  if (const auto found = cast_hit(a, wide<dimension_of<A>, T>(motion), b, options)) return rounded_impact<T>(*found);
  return std::nullopt;
}

}  // namespace detail

/// The first touch of a valid shape (asserted) that translates by `motion` from t = 0 to t = 1, and a fixed one of the
/// same dimension and number type; none if they do not touch. Touching counts, also at the start and at the end; a zero
/// motion hits what the shape touches already. t is never after the first touch and no earlier than the error explains.
/// Swapping the shapes and reversing the motion moves the point along, negates the normal and changes nothing else. A
/// compound is the union of its parts. Shapes or motions with a NaN touch nothing. For shapes that also rotate:
/// `time_of_impact`.
template <Shape A, SameSpace<A> B>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> shape_cast(const A& a,
                                                                const Vec<dimension_of<A>, scalar_of<A>>& motion,
                                                                const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::impact_of(a, motion, b);
}

/// The same with options: the first moment at which the shapes are as near as the target distance, without what is not
/// approached if that is asked for. See the top of this file. Without options set, the result is the same to the last
/// bit.
template <Shape A, SameSpace<A> B>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> shape_cast(const A& a,
                                                                const Vec<dimension_of<A>, scalar_of<A>>& motion,
                                                                const B& b, CastOptions options) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b) && options.target_distance >= 0);
  if (options == CastOptions{}) return detail::impact_of(a, motion, b);
  return detail::impact_of(a, motion, b, options);
}

GRAZE_DECLARE_INSTANCES(GRAZE_SHAPE_CAST_INSTANCES)

}  // namespace graze
