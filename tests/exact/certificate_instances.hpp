// SPDX-License-Identifier: MIT
// The definitions behind certificate.hpp, for the files that instantiate them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "exact/body.hpp"
#include "exact/certificate.hpp"
#include "exact/enclosed.hpp"
#include "exact/hull_certificate.hpp"
#include "exact/level_certificate.hpp"
#include "parts_of.hpp"

namespace graze::test {

template <std::size_t N>
bool is_level_form(const Body<N>& body) {
  return body.form == BodyForm::plane || body.form == BodyForm::solid;
}

/// Whether the claim is proved, or is `touching` and gap or depth are known well.
inline bool is_enough(const GapBounds& bounds, Relation claim) {
  const std::optional<Relation> truth = bounds.relation();
  if (!truth || *truth == claim) return truth.has_value();
  constexpr double well_known = 3e-14;
  const double gap = *truth == Relation::apart ? bounds.high : -bounds.low;
  return claim == Relation::touching && gap <= well_known * std::max(bounds.own_size, bounds.largest);
}

template <std::size_t N>
GapBounds body_bounds(const Body<N>& a, const Body<N>& b, Relation claim) {
  if (a.form == BodyForm::not_seen || b.form == BodyForm::not_seen) return {};
  if (is_level_form(a) && is_level_form(b)) return bounds_of_levels(a, b);
  if (is_level_form(b)) return body_bounds(b, a, claim);
  if (is_level_form(a)) return b.form == BodyForm::ray ? bounds_over_level_of_ray(a, b) : bounds_over_level(a, b);
  const GapBounds quick = HullCertificate<N, double>(a, b).bounds(claim);
  return is_enough(quick, claim) ? quick : HullCertificate<N, long double>(a, b).bounds(claim);
}

/// If any two parts overlap, the whole does; the gap is that of the nearest or deepest parts.
template <Dim N, class T>
GapBounds bounds_of_parts(const Compound<N, T>& compound, const AnyShape<N, T>& shape, Relation claim) {
  GapBounds whole{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false, false, 0, 0};
  for (const Part<N, T>& part : compound.parts) {
    const GapBounds of_part = gap_bounds<N, T>(part.shape, shape, claim);
    whole.low = std::min(whole.low, of_part.low);
    whole.high = std::min(whole.high, of_part.high);
    whole.is_overlapping = whole.is_overlapping || of_part.is_overlapping;
    whole.may_be_parallel = whole.may_be_parallel || of_part.may_be_parallel;
    whole.own_size = std::max(whole.own_size, of_part.own_size);
    whole.largest = std::max(whole.largest, of_part.largest);
    if (claim != Relation::overlapping || !whole.is_overlapping) continue;
    whole.low = -std::numeric_limits<double>::infinity();
    return whole;
  }
  return whole;
}

template <Dim N, class T>
GapBounds gap_bounds(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Relation claim) {
  if (const auto parts = parts_of<N, T>(a)) return bounds_of_parts<N, T>(*parts, b, claim);
  if (const auto parts = parts_of<N, T>(b)) return bounds_of_parts<N, T>(*parts, a, claim);
  return body_bounds(detail::visit(BodyMaker<N, T>(), a), std::visit(BodyMaker<N, T>(), b), claim);
}

}  // namespace graze::test
