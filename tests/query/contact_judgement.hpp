// SPDX-License-Identifier: MIT
// Finds errors of a contact: compares its depth with the oracle's, and checks the overlap that is left when b has moved
// by the depth along the normal, according to the contract of contact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/parting.hpp"
#include "exact/verdict.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// The errors of one answer, in units of epsilon of T times the size that contact.hpp names for the pair.
struct ContactErrors {
  Judgement judgement = Judgement::right;  ///< Never `within_band`: that is for touching alone.
  double depth = 0;                        ///< Of the depth, rounded to T.
  double left = 0;                         ///< The overlap left when b has moved by depth along the normal.
};

/// The largest rotation of a normal by rounding to T, in epsilon of T: half an ulp of each coordinate.
inline constexpr double normal_rounding = 2;

/// `truth` with gap and sizes.
template <Dim N, class T>
ContactErrors contact_errors(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const ExactVerdict& truth,
                             const std::optional<Contact<N, T>>& found) {
  ContactErrors errors;
  const double size = documented_size(truth.own_size, truth.largest, a.index(), b.index());
  const bool underflows = truth.relation != Relation::touching && std::fabs(truth.gap) < least_size;
  if (truth.is_nearly_parallel || !(size > least_size) || underflows) {
    errors.judgement = Judgement::outside_range;
    return errors;
  }
  const auto expect = [&errors](bool holds) {
    if (!holds) errors.judgement = Judgement::wrong;
  };
  if (!found) {
    expect(truth.relation == Relation::apart);
    return errors;
  }
  expect(truth.relation != Relation::apart || truth.gap <= verdict_band * size);
  const double depth = std::max(0.0, -truth.gap);
  const auto given = static_cast<double>(found->depth);
  expect(std::isinf(depth) == std::isinf(given));
  if (std::isinf(depth) || std::isinf(given)) return errors;
  const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  const double bound =
      found->error + epsilon * std::fabs(given) + static_cast<double>(std::numeric_limits<T>::denorm_min());
  expect(std::fabs(given - depth) <= bound);
  errors.depth = std::fabs(given - depth) / (epsilon * size);
  const Vec<N, double> normal(found->normal);
  expect(std::fabs(std::sqrt(dot(normal, normal)) - 1) <= normal_rounding * epsilon);
  const double allowed = bound + normal_rounding * epsilon * truth.own_size;
  if (const std::optional<double> left = overlap_after<N, T>(a, b, normal * given, allowed / 2)) {
    expect(*left <= allowed);
    errors.left = *left / (epsilon * size);
  }
  return errors;
}

}  // namespace graze::test
