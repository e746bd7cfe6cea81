// SPDX-License-Identifier: MIT
// How a calculated gap, known up to rounding, becomes a verdict.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

namespace graze {

/// How two closed sets lie to each other. `apart` and `overlapping` are certain; `touching` means that the gap, or the
/// depth, is zero within the rounding of the calculation (exactly zero where the calculation is exact). Overlapping is
/// meant as depth: every translation that parts the two has some length, or: the zero vector is inside the set of
/// differences a - b. So a segment through a sphere overlaps it; a segment in a sphere's tangent plane, or two
/// triangles of one plane in 3D, only touch.
enum class Relation { apart, touching, overlapping };

/// "apart", "touching", "overlapping".
constexpr std::string_view name_of(Relation relation) {
  if (relation == Relation::apart) return "apart";
  return relation == Relation::touching ? "touching" : "overlapping";
}

namespace detail {

/// The verdict on a gap (negative: a depth) that may be off by `slack`. NaN is apart: nonsense touches nothing.
constexpr Relation verdict_on_gap(double gap, double slack) {
  if (!(gap <= slack)) return Relation::apart;
  return gap < -slack ? Relation::overlapping : Relation::touching;
}

/// The verdict on a squared distance between two cores that are each widened, by `reach` in all; the distance may be
/// off by `slack`. Says touching for deeply crossing cores when the reach is not above the slack: ask the cores then.
constexpr Relation verdict_on_distance(double distance_squared, double reach, double slack) {
  const double far = reach + slack;
  if (!(distance_squared <= far * far)) return Relation::apart;
  const double near = reach - slack;
  return near > 0 && distance_squared < near * near ? Relation::overlapping : Relation::touching;
}

/// The verdict on a squared distance, unless `slack`, which is taken generously, leaves it open.
constexpr std::optional<Relation> clear_verdict(double distance_squared, double reach, double slack) {
  const Relation verdict = verdict_on_distance(distance_squared, reach, slack);
  if (verdict == Relation::touching) return std::nullopt;
  return verdict;
}

}  // namespace detail
}  // namespace graze
