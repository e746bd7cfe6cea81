// SPDX-License-Identifier: MIT
// The depth of any two convex shapes, from their support functions alone: GJK if the cores are apart, EPA if they
// overlap. Include contact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/convex.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact/cores.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/relation/convex.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A translated convex shape.
template <Convex S>
struct Shifted {
  const S& shape;
  Vec<dimension_of<S>, double> way;
};

template <Convex S>
Vec<dimension_of<S>, double> support(const Shifted<S>& shifted, const Vec<dimension_of<S>, double>& direction) {
  return wide_support(shifted.shape, direction) + shifted.way;
}

/// Its error is unchanged.
template <Convex S>
inline constexpr double support_error<Shifted<S>> = support_error<S>;

/// Where two cores touch after b has been moved out of a.
template <Convex A, Convex B>
ClosestPair<dimension_of<A>> points_after(const A& a, const B& b, const Vec<dimension_of<A>, double>& way) {
  ClosestPair<dimension_of<A>> pair = closest_of_convex(a, Shifted<B>{b, way}).closest;
  pair.on_b -= way;
  return pair;
}

/// Cores that are apart by more than GJK's resolution. Support points tell how much the gap along the vector between
/// the nearest points falls short of their distance.
template <Convex A, Convex B>
Penetration<dimension_of<A>> penetration_of_convex_apart(const A& a, const B& b, const Radii& radii) {
  constexpr Dim N = dimension_of<A>;
  const ConvexCores<N> cores = closest_of_convex(a, b);
  const double distance = std::sqrt(cores.closest.squared);
  const SeparatingAxis<N> between{unit_or(cores.closest.between, unit_axis<N>(0)), distance};
  Penetration<N> result = widened_along(between, cores.closest, radii);
  result.status = cores.status;
  const double proved = dot(between.normal, wide_support(b, -between.normal) - wide_support(a, between.normal));
  result.error += std::max(0.0, distance - proved) + cores.error;
  return result;
}

/// EPA's result for two cores that overlap, up to GJK's resolution, given GJK's result.
template <class Differences>
EpaResult<Differences::dimension> depth_from(Differences& differences,
                                             const GjkResult<Differences::dimension>& distance) {
  differences.begin_anew();  // as `relation` does, which must give the same verdict
  return epa_on<Differences::dimension>(differences, distance.simplex, EpaOptions{});
}

/// The points of contact: from the face in which EPA ended or, if there is none, from GJK once the cores are separated.
/// EPA, which searches for a depth, may not notice a gap, which can be as large as GJK's upper bound.
template <Convex A, Convex B>
Penetration<dimension_of<A>> penetration_of_depth(const WitnessedDifference<A, B>& differences,
                                                  const GjkResult<dimension_of<A>>& distance,
                                                  const EpaResult<dimension_of<A>>& depth, const Radii& radii) {
  constexpr Dim N = dimension_of<A>;
  const Vec<N, double> way = depth.normal * depth.upper;
  const bool has_face = depth.face.size > 0;
  const ClosestPair<N> pair =
      has_face ? pair_at(differences, depth.face, way) : points_after(differences.a(), differences.b(), way);
  Penetration<N> result = widened_along(SeparatingAxis<N>{depth.normal, -depth.upper}, pair, radii);
  result.status = depth.status;
  result.error += std::max(0.0, depth.upper - depth.lower) + std::max(depth.gap, distance.upper) + depth.resolution;
  if (!has_face) result.error += std::sqrt(pair.squared);
  return result;
}

template <Convex A, Convex B>
Penetration<dimension_of<A>> penetration_of_convex(const A& a, const B& b) {
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const Radii radii{core_radius(a), core_radius(b)};
  WitnessedDifference differences(core_a, core_b);
  const GjkResult<dimension_of<A>> distance = gjk_on(differences, GjkOptions{});
  const bool are_apart = (radii.a > 0 || radii.b > 0) && distance.lower > distance.resolution;
  Penetration<dimension_of<A>> result =
      are_apart ? penetration_of_convex_apart(core_a, core_b, radii)
                : penetration_of_depth(differences, distance, depth_from(differences, distance), radii);
  result.error += tolerance::rounding * (radii.a + radii.b);
  return result;
}

template <class A, class B>
std::optional<Penetration<dimension_of<A>>> penetration(const A& a, const B& b);

/// For shapes that are out of range, if they intersect; none for others.
template <class A, class B>
[[gnu::noinline, gnu::cold]] std::optional<std::optional<Penetration<dimension_of<A>>>> penetration_in_range(
    const A& a, const B& b) {
  using Found = std::optional<Penetration<dimension_of<A>>>;
  return answer_in_range<Found>(
      [](const auto& power, const auto& scaled_a, const auto& scaled_b) -> Found {
        const Found found = penetration(scaled_a, scaled_b);
        return found ? Found(resized(*found, power.inverse())) : std::nullopt;
      },
      a, b);
}

/// The verdict of relation/convex.hpp, and the depth if they intersect. For shapes without radii, the verdict's
/// calculation gives the depth.
template <Convex A, Convex B>
std::optional<Penetration<dimension_of<A>>> penetration_of_convex_if_met(const A& a, const B& b) {
  if (core_radius(a) > 0 || core_radius(b) > 0) {
    if (relation_of_convex(a, b) == Relation::apart) return std::nullopt;
    return penetration_of_convex(a, b);
  }
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  WitnessedDifference differences(core_a, core_b);
  const GjkResult<dimension_of<A>> distance = gjk_on(differences, GjkOptions{0});
  if (!(distance.upper >= 0) || distance.lower > distance.resolution) return std::nullopt;
  const EpaResult<dimension_of<A>> depth = depth_from(differences, distance);
  if (depth.gap > depth.resolution) return std::nullopt;
  return penetration_of_depth(differences, distance, depth, {0, 0});
}

template <Dim N, class T, Convex B>
Penetration<N> penetration_of_convex(const Ray<N, T>& ray, const B& b) {
  return penetration_of_convex(cut_for_depth(ray, b), b);
}

}  // namespace graze::detail
