// SPDX-License-Identifier: MIT
// Describes what makes a shape invalid, by the kinds of its fields.
#pragma once

#include <cmath>
#include <string_view>

#include <graze/math/rotation.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {
namespace detail {

/// Whether a finite value is valid for a field of this kind.
template <FieldKind kind, class Value>
bool is_accepted_as(const Value& value) {
  bool is_accepted = true;
  if constexpr (kind == FieldKind::direction) is_accepted = max_abs(value) != 0;
  if constexpr (kind == FieldKind::length || kind == FieldKind::half_extents) {
    for_each_number(value, [&](auto number) { is_accepted = is_accepted && number >= 0; });
  }
  if constexpr (kind == FieldKind::axes) is_accepted = orthonormal_error(value) <= tolerance::orthonormal;
  return is_accepted;
}

template <class Value>
bool has_finite_numbers(const Value& value) {
  bool are_finite = true;
  for_each_number(value, [&](auto number) { are_finite = are_finite && std::isfinite(number); });
  return are_finite;
}

/// The defect of a field's value; empty if the value is valid.
template <class Field, class Value>
std::string_view defect_of_field(const Field& field, const Value& value) {
  if constexpr (Field::kind == FieldKind::parts) {
    for (const auto& part : value) {
      if (!defect(part.shape).empty()) return field.refused.view();
    }
  } else if constexpr (Field::kind != FieldKind::hull) {  // a hull is always valid
    if (!has_finite_numbers(value)) return field.not_finite.view();
    if (!is_accepted_as<Field::kind>(value)) return field.refused.view();
  }
  return {};
}

/// The first defect of a shape's fields; fields are checked one by one.
template <Described S>
std::string_view defect_of_fields(const S& shape) {
  std::string_view found;
  for_each_field(shape, [&found](const auto& field, const auto& value) {
    if (found.empty()) found = defect_of_field(field, value);
  });
  return found;
}

}  // namespace detail

/// Empty for valid values. Otherwise the first fault, worded as the rest of a sentence: a number that is not finite, a
/// negative length, a direction of zero length, axes that deviate from orthonormal by more than
/// `tolerance::orthonormal`, or an invalid part.
template <detail::Described S>
std::string_view defect(const S& shape) {
  return detail::defect_of_fields(shape);
}

}  // namespace graze
