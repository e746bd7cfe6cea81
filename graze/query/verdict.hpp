// SPDX-License-Identifier: MIT
/// @file
/// How a gap with a rounding error becomes a verdict.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace graze {

/// Whether two closed sets are apart, touch or overlap. `apart` and `overlapping` are certain. `touching`: the gap, or
/// the depth, is below the rounding error of the calculation (exactly zero where the calculation is exact). Sets
/// overlap if every translation that separates them has a positive length, that is, if the zero vector is inside the
/// Minkowski difference a - b. So a segment through a sphere overlaps it; a segment in a tangent plane of a sphere, or
/// two coplanar triangles in 3D, only touch.
enum class Relation { apart, touching, overlapping };

/// Returns "apart", "touching" or "overlapping".
constexpr std::string_view name_of(Relation relation) {
  if (relation == Relation::apart) return "apart";
  return relation == Relation::touching ? "touching" : "overlapping";
}

namespace detail {

/// The verdict on a gap (negative: a depth) with an error of at most `slack`. NaN is apart.
constexpr Relation verdict_on_gap(double gap, double slack) {
  if (!(gap <= slack)) return Relation::apart;
  return gap < -slack ? Relation::overlapping : Relation::touching;
}

/// The verdict on a squared distance between two cores with a total radius of `reach`; the distance has an error of at
/// most `slack`. Returns touching for overlapping cores if the reach is not above the slack; the cores decide then.
constexpr Relation verdict_on_distance(double distance_squared, double reach, double slack) {
  const double far = reach + slack;
  if (!(distance_squared <= far * far)) return Relation::apart;
  const double near = reach - slack;
  return near > 0 && distance_squared < near * near ? Relation::overlapping : Relation::touching;
}

/// The verdict on a squared distance, or none if it is within `slack`, a generous error bound, of the reach.
constexpr std::optional<Relation> clear_verdict(double distance_squared, double reach, double slack) {
  const Relation verdict = verdict_on_distance(distance_squared, reach, slack);
  if (verdict == Relation::touching) return std::nullopt;
  return verdict;
}

}  // namespace detail
}  // namespace graze
