// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/parts.hpp>

namespace graze {

/// The union of its parts, which it owns; parts may be compounds. Without parts it is valid and touches nothing. Use
/// `compound_of(shapes)` from query/bounds.hpp, which calculates the boxes and, for many parts, builds a tree of them.
template <Dim N, class T = float>
struct Compound {
  Parts<N, T> parts;  ///< In any order; the order decides ties between parts.
};

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Compound<N, T>> = Description("compound",
                                                                   field::parts("parts", &Compound<N, T>::parts));
}  // namespace detail

}  // namespace graze

// AnyShape and Compound are one recursive definition in two files: a compound's parts are any shapes.
#include <graze/shape/any_shape.hpp>  // IWYU pragma: export
