// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// One shape of a compound, and a box around it by which queries skip the part.
template <Dim N, class T = float>
struct Part {
  AnyShape<N, T> shape;
  Aabb<N, T> box;
};

/// The union of its parts, which it owns; compounds may be parts. Without parts it is valid and touches nothing.
/// Make one with `compound_of(shapes)` from query/bounds.hpp, which calculates the boxes.
template <Dim N, class T = float>
struct Compound {
  std::vector<Part<N, T>> parts;
};

template <Dim N, class T>
std::string_view defect(const Compound<N, T>& compound) {
  for (const Part<N, T>& part : compound.parts) {
    if (!defect(part.shape).empty()) return "has a part that is not valid";
  }
  return "";
}

}  // namespace graze
