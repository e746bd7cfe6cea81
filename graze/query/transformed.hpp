// SPDX-License-Identifier: MIT
/// @file
/// transformed(shape, pose) and translated(shape, offset) for compounds and variants. `transformed` for other shapes is
/// declared with their types.
#pragma once

#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze {

template <Dim N, class T>
AnyShape<N, T> transformed(const AnyShape<N, T>& shape, const Pose<N, T>& pose);

/// A compound of the transformed parts, in the same order, with new boxes. Axis-aligned boxes become oriented ones.
/// Throws like `transformed` of a polytope.
template <Dim N, class T>
Compound<N, T> transformed(const Compound<N, T>& compound, const Pose<N, T>& pose) {
  std::vector<AnyShape<N, T>> moved;
  moved.reserve(compound.parts.size());
  for (const Part<N, T>& part : compound.parts) moved.push_back(transformed(part.shape, pose));
  return compound_of<N, T>(std::move(moved));
}

/// The image of the shape held under a rigid transform. An axis-aligned box becomes an oriented one. Throws like
/// `transformed` of a polytope.
template <Dim N, class T>
AnyShape<N, T> transformed(const AnyShape<N, T>& shape, const Pose<N, T>& pose) {
  return detail::visit([&pose](const auto& held) -> AnyShape<N, T> { return transformed(held, pose); }, shape);
}

/// The image of the shape held under a translation. Unlike `transformed`, an axis-aligned box stays one. Each
/// coordinate is rounded to T once. Throws like `transformed` of a polytope.
template <Dim N, class T>
AnyShape<N, T> translated(const AnyShape<N, T>& shape, const std::type_identity_t<Vec<N, T>>& offset) {
  if (const auto* const box = std::get_if<Aabb<N, T>>(&shape)) {
    const Vec<N, double> wide_offset = wide<N, T>(offset);
    return Aabb<N, T>{Vec<N, T>(wide<N, T>(box->min) + wide_offset), Vec<N, T>(wide<N, T>(box->max) + wide_offset)};
  }
  if (const auto* const compound = std::get_if<Compound<N, T>>(&shape)) {
    std::vector<AnyShape<N, T>> moved;
    moved.reserve(compound->parts.size());
    for (const Part<N, T>& part : compound->parts) moved.push_back(translated<N, T>(part.shape, offset));
    return compound_of<N, T>(std::move(moved));
  }
  return transformed(shape, Pose<N, T>{.position = offset});
}

}  // namespace graze
