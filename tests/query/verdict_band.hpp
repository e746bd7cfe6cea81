// SPDX-License-Identifier: MIT
// The permitted difference between a verdict and the truth, as documented in relation.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/query/verdict.hpp>

#include "exact/certificate.hpp"
#include "exact/verdict.hpp"

namespace graze::test {

/// The band in which graze may say touching, relative to the sizes that relation.hpp names: "a few epsilon" of a sum of
/// several lengths of up to three coordinates each.
inline constexpr double verdict_band = 128 * std::numeric_limits<double>::epsilon();

/// Squares of anything smaller leave the range of double.
inline constexpr double least_size = 1e-140;

/// Which size the error of a pair is relative to: the letters in relation.hpp's table. C for pairs of point, segment,
/// ray, sphere, aabb, obb, triangle and capsule.
inline bool is_relative_to_own_size(std::size_t type_a, std::size_t type_b) {
  constexpr std::array has_closed_form = {true,  true, true, true,  true,  true, false,
                                          false, true, true, false, false, false};
  static_assert(has_closed_form.size() == shape_type_names.size());
  return has_closed_form[type_a] && has_closed_form[type_b];
}

/// The assessment of a verdict.
enum class Judgement { right, within_band, outside_range, wrong };

/// The index of rays in AnyShape.
inline constexpr std::size_t ray_type = 2;

/// The size that the documentation names for a pair of these types, by their indices in AnyShape. If it is the largest
/// coordinate, those of a ray near the other shape count, which are at most its origin's and the pair's own size
/// together.
inline double documented_size(double own_size, double largest, std::size_t type_a, std::size_t type_b) {
  if (is_relative_to_own_size(type_a, type_b)) return own_size;
  return type_a == ray_type || type_b == ray_type ? std::max(own_size, largest) : largest;
}

/// The gap or depth of such a pair relative to that size.
inline double relative_gap(const ExactVerdict& truth, std::size_t type_a, std::size_t type_b) {
  return std::fabs(truth.gap) / documented_size(truth.own_size, truth.largest, type_a, type_b);
}

/// `truth` with gap and sizes where it differs from the claim. `apart` and `overlapping` are guaranteed: only
/// `touching` may replace another verdict.
inline Judgement judge(Relation claim, const ExactVerdict& truth, std::size_t type_a, std::size_t type_b) {
  if (truth.relation == claim) return Judgement::right;
  const bool underflows = truth.relation != Relation::touching && std::fabs(truth.gap) < least_size;
  if (truth.is_nearly_parallel || underflows) return Judgement::outside_range;
  const bool is_within = claim == Relation::touching && relative_gap(truth, type_a, type_b) <= verdict_band;
  return is_within ? Judgement::within_band : Judgement::wrong;
}

/// A claim that was judged.
struct Finding {
  Judgement judgement;
  Relation truth;
  double relative_gap;  ///< At least the true one, as above; 0 if the claim is right.
};

/// A certificate's assessment of a claim: none if it leaves the relation open, or proves the claim wrong, or nearly so;
/// then the oracle must decide.
inline std::optional<Finding> finding(Relation claim, const GapBounds& proved, std::size_t type_a, std::size_t type_b) {
  const std::optional<Relation> truth = proved.relation();
  if (!truth) return std::nullopt;
  if (*truth == claim) return Finding{Judgement::right, claim, 0};
  if (claim != Relation::touching || proved.may_be_parallel) return std::nullopt;
  const double gap = *truth == Relation::apart ? proved.high : -proved.low;
  const double relative = gap / documented_size(proved.own_size, proved.largest, type_a, type_b);
  // Gaps that may be below the smallest size are not judged by it; bounds without a finite number prove nothing.
  if (!(gap > 1e10 * least_size) || !(relative <= verdict_band)) return std::nullopt;
  return Finding{Judgement::within_band, *truth, relative};
}

}  // namespace graze::test
