// SPDX-License-Identifier: MIT
// How far a verdict of graze may be from the true one, as relation.hpp documents it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/query/verdict.hpp>

#include "exact/unbounded.hpp"

namespace graze::test {

/// The band in which graze may say touching, in units of the sizes that relation.hpp names: "a few epsilon" of a sum of
/// several lengths, and those of at most three coordinates each.
inline constexpr double verdict_band = 128 * std::numeric_limits<double>::epsilon();

/// Squares of anything smaller leave the range of double.
inline constexpr double least_size = 1e-140;

/// Which size the error of a pair is relative to: the letters in relation.hpp's table. C for point, segment, ray,
/// sphere, aabb, obb, triangle and capsule among themselves.
inline bool is_relative_to_own_size(std::size_t type_a, std::size_t type_b) {
  constexpr std::array<bool, 12> has_closed_form = {true,  true,  true, true, true,  true,
                                                    false, false, true, true, false, false};
  return has_closed_form[type_a] && has_closed_form[type_b];
}

/// What a claim is worth.
enum class Judgement { right, within_band, outside_range, wrong };

/// The gap or depth of a pair of these types, by their places in AnyShape, relative to the size in the documentation.
inline double relative_gap(const ExactVerdict& truth, std::size_t type_a, std::size_t type_b) {
  return std::fabs(truth.gap) / (is_relative_to_own_size(type_a, type_b) ? truth.own_size : truth.largest);
}

/// `truth` with gap and sizes where it differs from the claim. `apart` and `overlapping` are promises: only `touching`
/// may stand for something else.
inline Judgement judge(Relation claim, const ExactVerdict& truth, std::size_t type_a, std::size_t type_b) {
  if (truth.relation == claim) return Judgement::right;
  const bool underflows = truth.relation != Relation::touching && std::fabs(truth.gap) < least_size;
  if (truth.is_nearly_parallel || underflows) return Judgement::outside_range;
  const bool is_within = claim == Relation::touching && relative_gap(truth, type_a, type_b) <= verdict_band;
  return is_within ? Judgement::within_band : Judgement::wrong;
}

}  // namespace graze::test
