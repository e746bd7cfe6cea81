// SPDX-License-Identifier: MIT
// All overlapping pairs in order, without holding all of them.
#pragma once

#include <cstddef>
#include <span>

#include <graze/broad/pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// The pairs of `overlapping_pairs(boxes, options)`, ascending by a, then b, given to a visitor by the block; false
/// asks for no more. Memory grows with the boxes, not with the pairs: at most 2^22 of these, or 8 for each box, are
/// held at a time. Pairs begin to come before all are found. Up to that number it takes about twice the time of
/// `overlapping_pairs`; beyond, boxes are searched range by range. Throws like `overlapping_pairs`.
template <Dim N, class T>
void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit, const PairOptions& options = {});

namespace detail {

/// The same with at most `most` pairs at a time, or twice the boxes if that is more.
template <Dim N, class T>
void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit, const PairOptions& options,
                        std::size_t most);

}  // namespace detail

}  // namespace graze
