// SPDX-License-Identifier: MIT
// The image of a shape under a rigid transform, by the kinds of its fields.
#pragma once

#include <cstddef>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/shape.hpp>

namespace graze {
namespace detail {

/// A field's value after its shape has moved.
template <FieldKind kind, Dim N, class T, class S, class Value>
Value transformed_field([[maybe_unused]] const S& shape, const Value& value, const Pose<N, T>& pose) {
  if constexpr (kind == FieldKind::point) {
    return transformed<N, T>(value, pose);
  } else if constexpr (kind == FieldKind::direction || kind == FieldKind::axes) {
    return rotated<N, T>(value, pose);
  } else if constexpr (kind == FieldKind::corners) {
    Value moved;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = transformed<N, T>(value[i], pose);
    return moved;
  } else if constexpr (kind == FieldKind::offset) {
    const Vec<N, T> normal = rotated<N, T>(shape.normal, pose);
    return static_cast<T>(static_cast<double>(value) + dot(wide<N, T>(normal), wide<N, T>(pose.position)));
  } else {
    return value;
  }
}

}  // namespace detail

/// The image of a shape under a rigid transform, rounded to the shape's number type. Lengths are unchanged.
template <detail::Described S>
S transformed(const S& shape, const Pose<dimension_of<S>, scalar_of<S>>& pose) {
  return detail::with_fields_changed(shape, [&]<class Field>(const Field&, const auto& value) {
    return detail::transformed_field<Field::kind>(shape, value, pose);
  });
}

}  // namespace graze
