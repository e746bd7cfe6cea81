// SPDX-License-Identifier: MIT
/// @file
/// closest_points(a, b): the distance of any two shapes, their nearest points, and the direction between them.
///
/// What finds them. C: closed form. S: the supports along the plane's normal, a closed form for every convex shape. P:
/// part by part. G: GJK; for two 3D polytopes first the fast walk of closest/hulls.hpp.
///
///                 segment ray sphere aabb obb plane half-space triangle capsule polytope compound user's
///     point          C     C    C     C    C    S       S         C        C       G        P       G
///     segment        C     C    C     C    C    S       S         C        C       G        P       G
///     ray                  C    C     C    C    C       C         C        C       G        P       G
///     sphere                    C     C    C    S       S         C        C       G        P       G
///     aabb                            C    C    S       S         C        C       G        P       G
///     obb                                  C    S       S         C        C       G        P       G
///     plane                                     C       C         S        S       S        P       S
///     half-space                                        C         S        S       S        P       S
///     triangle                                                    C        C       G        P       G
///     capsule                                                              C       G        P       G
///     polytope                                                                     G        P       G
///     compound                                                                              P       P
///
/// relation(a, b) decides whether the shapes meet: the distance is 0 if and only if they touch or overlap, and then
/// both points are one common point. A round shape is a core (a center or an axis) and a radius; a shape without radius
/// is its own core. The normal points from the nearest point of a's core to that of b's, also if the shapes meet and
/// one of them is round. It is zero if the cores meet, or if planes or half-spaces meet; it may be zero if the gap
/// between the cores is below the error.
///
/// If there are several nearest points, the choice depends only on the shapes. Swapping the arguments swaps the points,
/// negates the normal and changes no bit of anything else. A compound counts as its nearest part, of several the first
/// (for two compounds the pair whose part of the lesser compound comes first, as shape_order.hpp sorts them). Without
/// parts it is infinitely far from everything, and its points are NaN.
///
/// `error` bounds the error of the distance before rounding to T. C: a few epsilon of double of the pair's own size,
/// however far from the origin (for a ray beside something smaller than an ulp of T: of that ulp). S and G: a few
/// epsilon of the largest coordinate (of T for a user's shape that calculates in T). G adds the gap between the bounds
/// that GJK has proved; the status tells if it exceeds 1e-12 of the distance. The points are rounded to T: within half
/// an ulp of their coordinates they lie in their shapes, at the distance from each other. For segments and capsules
/// they are also at the true place, even for nearly parallel segments, where other points are hardly farther apart. For
/// shapes a million times longer than thick that meet, G may return a point that is 1e-9 of their size outside. Any
/// finite coordinates are allowed; see range.hpp for sizes that differ by more than a factor of 2^900. Directions of
/// rays and planes that are parallel up to a few epsilon count as parallel.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest/convex.hpp>
#include <graze/query/closest/hulls.hpp>
#include <graze/query/closest/nearest_faces.hpp>
#include <graze/query/closest/nearest_part.hpp>
#include <graze/query/closest/nearly_parallel.hpp>
#include <graze/query/closest/unbounded.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

// ---- From cores to shapes

/// A common point of two shapes whose cores are this far apart: the middle of what both cover of the segment between.
inline double common_share(double distance, double radius_a, double radius_b) {
  return 0.5 * (std::max(0.0, distance - radius_b) + std::min(distance, radius_a));
}

struct Radii {
  double a;
  double b;
};

/// The result for two shapes, from the nearest points of their cores relative to `reference`.
template <Dim N>
Proximity<N, double> widened(const ClosestPair<N>& cores, const Vec<N, double>& reference, const Radii& radii,
                             Relation relation) {
  const double distance = std::sqrt(cores.squared);
  Proximity<N, double> result;
  result.relation = relation;
  result.normal = unit_or(cores.between, Vec<N, double>(0.0));
  if (relation == Relation::apart) {
    result.distance = std::max(0.0, distance - (radii.a + radii.b));
    result.point_a = reference + (cores.on_a + result.normal * radii.a);
    result.point_b = reference + (cores.on_b - result.normal * radii.b);
    return result;
  }
  result.distance = 0;
  const Vec<N, double> way = result.normal * common_share(distance, radii.a, radii.b);
  result.point_a = result.point_b = reference + (cores.on_a + way);
  return result;
}

/// The result for cores that meet, or whose gap is so small that `relation` returns touching: a shape without radius is
/// its core, so the point is on it.
template <Dim N>
Proximity<N, double> widened_meeting(const ClosestPair<N>& cores, const Vec<N, double>& reference, const Radii& radii,
                                     Relation relation) {
  const bool is_core_of_one = (radii.a > 0) != (radii.b > 0);
  const double share = !is_core_of_one ? 0.5 : radii.a > 0 ? 1.0 : 0.0;
  return meeting_at<N>(reference + (cores.on_a + cores.between * share), relation);
}

// ---- Closed forms of bounded shapes and rays

template <class S>
inline constexpr bool is_ray = false;
template <Dim N, class T>
inline constexpr bool is_ray<Ray<N, T>> = true;

template <Dim N, class T>
const Ray<N, T>& core(const Ray<N, T>& ray) {
  return ray;
}
template <Dim N, class T>
double core_radius(const Ray<N, T>&) {
  return 0;
}

/// The stored point that becomes the origin for a pair.
template <Dim N, class T>
Vec<N, double> reference(const Ray<N, T>& ray) {
  return wide<N, T>(ray.origin);
}
template <Dim N, class T>
Vec<N, double> reference(const Triangle<N, T>& triangle) {
  return wide<N, T>(triangle.a);
}

template <Dim N, class T>
Vec<N, double> relative_to(const Vec<N, double>& origin, const Vec<N, T>& point) {
  return wide<N, T>(point) - origin;
}

/// A shape whose core has the features of cores/features.hpp.
template <class S>
concept HasSimpleCore = is_ray<S> || requires(const S& shape, const Vec<dimension_of<S>, double>& origin) {
  relative_to(origin, core(shape));
};

/// A core in double. A ray is cut where it has passed the other shape.
template <class Core, class Other>
auto local_beside(const Vec<dimension_of<Core>, double>& origin, const Core& core, const Other& other) {
  if constexpr (is_ray<Core>) {
    const Vec<dimension_of<Core>, double> start = reference(core) - origin;
    return Segment<dimension_of<Core>, double>{start, start + reach_to(core, bounds(other))};
  } else {
    return relative_to(origin, core);
  }
}

/// The nearest points of two cores that are apart, relative to `origin`; nearly parallel segments in 3D are used as
/// stored.
template <class CoreA, class CoreB, class LocalA, class LocalB>
ClosestPair<dimension_of<CoreA>> closest_of_cores(const CoreA& a, const CoreB& b, const LocalA& local_a,
                                                  const LocalB& local_b,
                                                  const Vec<dimension_of<CoreA>, double>& origin) {
  if constexpr (dimension_of<CoreA> == 3 && is_a<Segment, CoreA> && is_a<Segment, CoreB>) {
    using T = scalar_of<CoreA>;
    const auto stored = [](const Segment<3, T>& segment) {
      return Segment<3, double>{wide<3, T>(segment.start), wide<3, T>(segment.end)};
    };
    if (const auto nearest = closest_of_nearly_parallel(stored(a), stored(b), origin)) return *nearest;
  }
  return closest_of_apart(local_a, local_b, size_around_zero(local_a) + size_around_zero(local_b));
}

/// If round shapes meet, their cores may still be apart.
template <HasSimpleCore A, HasSimpleCore B>
Proximity<dimension_of<A>, double> proximity_of_simple(const A& a, const B& b, Relation relation) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const Radii radii{core_radius(a), core_radius(b)};
  const bool is_decided = relation == Relation::apart || (radii.a == 0 && radii.b == 0);
  const Relation of_cores = is_decided ? relation : decide(core_a, core_b);
  const Vec<N, double> origin = reference(core_a);
  const auto local_a = local_beside(origin, core_a, core_b);
  const auto local_b = local_beside(origin, core_b, core_a);
  const double size = size_around_zero(local_a) + size_around_zero(local_b);
  Proximity<N, double> result =
      of_cores == Relation::apart
          ? widened(closest_of_cores(core_a, core_b, local_a, local_b, origin), origin, radii, relation)
          : widened_meeting(closest_of_meeting(local_a, local_b, size), origin, radii, relation);
  result.error = tolerance::rounding * (size + (radii.a + radii.b));
  return result;
}

/// For axis-aligned boxes only the gaps are calculated, wherever the boxes are.
template <Dim N, class T>
Proximity<N, double> proximity_of_simple(const Aabb<N, T>& a, const Aabb<N, T>& b, Relation relation) {
  const Vec<N, double> zero(0.0);
  const ClosestPair<N> pair = closest_of_boxes(relative_to(zero, a), relative_to(zero, b));
  Proximity<N, double> result = relation == Relation::apart ? widened(pair, zero, {0, 0}, relation)
                                                            : widened_meeting(pair, zero, {0, 0}, relation);
  result.error = tolerance::rounding * sum_abs(pair.between);
  return result;
}

/// Two rays have their own closed form: neither can be cut before their nearest points are known.
template <Dim N, class T>
Proximity<N, double> proximity_of_rays(const Ray<N, T>& a, const Ray<N, T>& b, Relation relation) {
  const ClosestPair<3> in_space = closest_of_rays(a, b);
  const ClosestPair<N> pair{Vec<N, double>(in_space.on_a), Vec<N, double>(in_space.on_b),
                            Vec<N, double>(in_space.between), in_space.squared};
  const Vec<N, double> origin = wide<N, T>(a.origin);
  Proximity<N, double> result = relation == Relation::apart ? widened(pair, origin, {0, 0}, relation)
                                                            : widened_meeting(pair, origin, {0, 0}, relation);
  result.error = tolerance::rounding * sum_abs(wide<N, T>(b.origin) - origin);
  return result;
}

// ---- Everything else that is convex

/// What `relation` cannot resolve: it may have used larger parts of the shapes than the nearest points did.
template <Convex A, Convex B>
double resolution_of_convex(const A& a, const B& b) {
  const auto largest = [](const auto& box) {
    return static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
  };
  return std::max(support_error<A>, support_error<B>) * std::max(largest(bounds(a)), largest(bounds(b)));
}

template <Convex A, Convex B>
Proximity<dimension_of<A>, double> proximity_of_convex(const A& a, const B& b, Relation relation) {
  constexpr Dim N = dimension_of<A>;
  const Radii radii{core_radius(a), core_radius(b)};
  const ConvexCores<N> cores = closest_of_convex(core(a), core(b));
  const bool has_radius = radii.a > 0 || radii.b > 0;
  const bool are_apart =
      relation == Relation::apart || (has_radius && cores.closest.squared > cores.error * cores.error);
  const Vec<N, double> zero(0.0);
  Proximity<N, double> result =
      are_apart ? widened(cores.closest, zero, radii, relation) : widened_meeting(cores.closest, zero, radii, relation);
  if (relation == Relation::apart) result.status = cores.status;
  result.error = cores.error + tolerance::rounding * (radii.a + radii.b);
  if (relation == Relation::touching) result.error = std::max(result.error, resolution_of_convex(a, b));
  return result;
}

template <Dim N, class T, Convex B>
Proximity<N, double> proximity_of_convex(const Ray<N, T>& ray, const B& b, Relation relation) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  return proximity_of_convex(Segment<N, double>{origin, origin + reach_to(ray, bounds(b))}, b, relation);
}

// ---- Any two shapes

template <class S>
inline constexpr bool is_plane_or_half_space = is_a<Plane, S> || is_a<HalfSpace, S>;

/// Two simple shapes whose nearest points GJK finds; it must start in range.
template <class A, class B>
inline constexpr bool is_found_by_support = !is_plane_or_half_space<A> && !is_plane_or_half_space<B> &&
                                            !(is_ray<A> && is_ray<B>)&&!(HasSimpleCore<A> && HasSimpleCore<B>);

/// For two simple shapes in the order of AnyShape.
template <class A, class B>
Proximity<dimension_of<A>, double> proximity_in_order(const A& a, const B& b, Relation relation) {
  if constexpr (is_plane_or_half_space<A> && is_plane_or_half_space<B>) {
    return proximity_of_half_spaces(a, b, relation);
  } else if constexpr (is_ray<A> && is_plane_or_half_space<B>) {
    return proximity_of_ray(a, b, relation);
  } else if constexpr (is_plane_or_half_space<B>) {
    return exchanged(proximity_to_half_space(b, a, relation));
  } else if constexpr (is_plane_or_half_space<A>) {
    return proximity_to_half_space(a, b, relation);
  } else if constexpr (is_ray<A> && is_ray<B>) {
    return proximity_of_rays(a, b, relation);
  } else if constexpr (HasSimpleCore<A> && HasSimpleCore<B>) {
    return proximity_of_simple(a, b, relation);
  } else {
    return proximity_of_convex(a, b, relation);
  }
}

template <class A, class B>
Proximity<dimension_of<A>, double> proximity(const A& a, const B& b, SimplexCache<dimension_of<A>>* cache = nullptr);

/// Whether a result was calculated from numbers in range. Axis-aligned boxes that meet have an error of zero, and that
/// of planes does not reveal how long their normals are.
template <class A, class B>
bool is_in_range(const Proximity<dimension_of<A>, double>& found, const A& a, const B& b) {
  if constexpr (is_plane_or_half_space<A> && is_plane_or_half_space<B>) return are_usual(a, b);
  if (is_usual_error<scalar_of<A>>(found.error)) return has_usual_normal(a) && has_usual_normal(b);
  if constexpr (is_a<Aabb, A> && is_a<Aabb, B>) return found.point_a == found.point_b;
  return false;
}

/// Replaces the result for shapes that are out of range. The verdict stays, because it may have used numbers that
/// differ too much in size.
template <class A, class B>
[[gnu::noinline, gnu::cold]] bool put_in_range(Proximity<dimension_of<A>, double>& found, Relation relation, const A& a,
                                               const B& b) {
  const auto rescaled = answer_in_range<Proximity<dimension_of<A>, double>>(
      [](const auto& power, const auto& scaled_a, const auto& scaled_b) {
        return resized(proximity(scaled_a, scaled_b), power.inverse());
      },
      a, b);
  if (!rescaled) return false;
  found = *rescaled;
  found.relation = relation;
  if (relation != Relation::apart) {
    found.distance = 0;
    found.point_b = found.point_a;
  }
  return true;
}

/// With the error that the verdict leaves: overlapping is certain, but `relation` returns touching for shapes with a
/// gap below the rounding of its longest calculations, which is a few times the one here.
template <class A, class B>
[[gnu::always_inline]] inline Proximity<dimension_of<A>, double> proximity_in_order(const A& a, const B& b) {
  constexpr double slack_of_touching = tolerance::coarse / tolerance::rounding;
  const Relation relation = decide(a, b);
  if constexpr (is_found_by_support<A, B>) {
    Proximity<dimension_of<A>, double> result;
    if (!are_usual(a, b) && put_in_range(result, relation, a, b)) return result;
  }
  Proximity<dimension_of<A>, double> result = proximity_in_order(a, b, relation);
  if (!is_in_range(result, a, b) && put_in_range(result, relation, a, b)) return result;
  if (relation == Relation::touching) result.error *= slack_of_touching;
  if (relation == Relation::overlapping) result.error = 0;
  return result;
}

/// The nearest part, of several the first; parts whose boxes are farther away beyond rounding are skipped.
template <HasParts Whole, class S>
Proximity<dimension_of<S>, double> proximity_of_parts(const Whole& whole, const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const Aabb<N, T> box = touching_bounds(shape);
  NearestPart<N> best;
  const MayBeNearest<N, T> may_be_nearest{box, best};
  const auto visit = [&](const auto& part, std::size_t index) {
    if (!best.is_decided_before(index)) best.add(proximity(part.shape, shape), index);
    return true;
  };
  visit_parts(whole, may_be_nearest, ByKey(), PartVisitor<Whole>(visit));
  if (best.nearest().relation == Relation::apart) {
    if (const auto point = point_inside(whole, shape)) return proximity_inside(wide<N, T>(*point));
  }
  return best.nearest();
}

template <Dim N, class T>
Proximity<N, double> proximity_of_meshes(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  const auto found = proximity_of_meshes(
      a, b, [](const Triangle<N, T>& face_a, const Triangle<N, T>& face_b) { return proximity(face_a, face_b); });
  Proximity<N, double> result = found ? *found : proximity_of_parts(a, b);
  if (result.relation == Relation::touching) result.relation = decide(a, b);
  return result;
}

/// Without a branch on the order, which would be mispredicted half of the time.
template <class S>
bool find_proximity_of_hulls_in_any_order(const S& a, const S& b, SimplexCache<3>* cache,
                                          Proximity<3, double>& result) {
  const bool is_exchanged = !is_in_order(a, b);
  const S& first = is_exchanged ? b : a;
  const S& second = is_exchanged ? a : b;
  return find_proximity_of_hulls(first, second, {cache, is_exchanged}, result);
}
template <class A, class B>
bool find_proximity_of_hulls_in_any_order(const A& a, const B& b, SimplexCache<3>* cache,
                                          Proximity<3, double>& result) {
  if constexpr (are_in_either_order<A, B>) {
    if (!is_in_order(a, b)) return find_proximity_of_hulls(b, a, {cache, true}, result);
  }
  return find_proximity_of_hulls(a, b, {cache, false}, result);
}

template <class A, class B>
Proximity<dimension_of<A>, double> proximity(const A& a, const B& b,
                                             [[maybe_unused]] SimplexCache<dimension_of<A>>* cache) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&](const auto& held) { return proximity(held, b, cache); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&](const auto& held) { return proximity(a, held, cache); }, b);
  } else if constexpr (is_mesh<A> && is_mesh<B>) {
    return is_in_order(a, b) ? proximity_of_meshes(a, b) : exchanged(proximity_of_meshes(b, a));
  } else if constexpr (HasParts<A> && HasParts<B>) {
    return is_in_order(a, b) ? proximity_of_parts(a, b) : exchanged(proximity_of_parts(b, a));
  } else if constexpr (HasParts<A>) {
    return proximity_of_parts(a, b);
  } else if constexpr (HasParts<B>) {
    return exchanged(proximity_of_parts(b, a));
  } else if constexpr (are_exchanged<A, B>) {
    return exchanged(proximity(b, a, cache));
  } else {
    if constexpr (HullInSpace<A> && HullInSpace<B>) {
      Proximity<3, double> result;
      const bool is_usual = is_usual_size<scalar_of<A>>(std::max(size_of_hull(a), size_of_hull(b)));
      if (is_usual && find_proximity_of_hulls_in_any_order(a, b, cache, result)) return result;
    }
    const auto ask = [](const auto& first, const auto& second) { return proximity_in_order(first, second); };
    return answer_in_order(a, b, ask, [](const auto& found) { return exchanged(found); });
  }
}

}  // namespace detail

/// The nearest points and the distance of two valid shapes (asserted) of the same dimension and number type. See the
/// top of this file for ties, special cases and errors. `distance` returns the distance alone; `intersects` is cheaper
/// if only the yes or no matters.
template <Shape A, SameSpace<A> B>
Proximity<dimension_of<A>, scalar_of<A>> closest_points(const A& a, const B& b) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::rounded<scalar_of<A>>(detail::proximity(a, b));
}

/// The same result, found faster for two 3D polytopes, posed ones included, that have moved little since the last call
/// with this cache. Of several nearest points others may be returned. Other pairs leave the cache unchanged.
template <Shape A, SameSpace<A> B>
Proximity<dimension_of<A>, scalar_of<A>> closest_points(const A& a, const B& b, SimplexCache<dimension_of<A>>& cache) {
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  return detail::rounded<scalar_of<A>>(detail::proximity(a, b, &cache));
}

GRAZE_DECLARE_INSTANCES(GRAZE_CLOSEST_POINTS_INSTANCES)

}  // namespace graze
