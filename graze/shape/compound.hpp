// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {

/// A shape and a box around it; defined in any_shape.hpp.
template <Dim N, class T>
struct Part;

/// The union of its parts, which it owns; parts may be compounds. Without parts it is valid and touches nothing. Use
/// `compound_of(shapes)` from query/bounds.hpp, which calculates the boxes.
template <Dim N, class T = float>
struct Compound {
  std::vector<Part<N, T>> parts;  ///< In any order; the order decides ties between parts.
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Compound<N, T>> = Description("compound",
                                                                   field::parts("parts", &Compound<N, T>::parts));
}  // namespace detail

}  // namespace graze

// AnyShape and Compound are one recursive definition in two files: a compound's parts are any shapes.
#include <graze/shape/any_shape.hpp>  // IWYU pragma: export
