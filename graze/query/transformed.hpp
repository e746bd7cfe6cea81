// SPDX-License-Identifier: MIT
// transformed(shape, pose) for shapes that hold other shapes; simple shapes have it beside their definition.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

template <Dim N, class T>
AnyShape<N, T> transformed(const AnyShape<N, T>& shape, const Pose<N, T>& pose);

template <Dim N, class T>
Compound<N, T> transformed(const Compound<N, T>& compound, const Pose<N, T>& pose) {
  std::vector<AnyShape<N, T>> moved;
  moved.reserve(compound.parts.size());
  for (const Part<N, T>& part : compound.parts) moved.push_back(transformed(part.shape, pose));
  return compound_of<N, T>(std::move(moved));
}

/// The image under a rigid motion. An axis-aligned box becomes an oriented one.
template <Dim N, class T>
AnyShape<N, T> transformed(const AnyShape<N, T>& shape, const Pose<N, T>& pose) {
  return std::visit([&pose](const auto& held) -> AnyShape<N, T> { return transformed(held, pose); }, shape);
}

}  // namespace graze
