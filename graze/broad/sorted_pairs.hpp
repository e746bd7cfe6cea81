// SPDX-License-Identifier: MIT
/// @file
/// All overlapping pairs in order, without storing all of them.
#pragma once

#include <cstddef>
#include <span>

#include <graze/broad/pairs.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// Passes the pairs of `overlapping_pairs(boxes, options)`, ascending by a, then b, to a visitor in blocks; it returns
/// false to stop. Memory grows with the boxes, not with the pairs: at most 2^22 pairs, or 8 per box, are held at a
/// time. The first pairs come before all are found. Up to that number it takes about twice the time of
/// `overlapping_pairs`; beyond it, boxes are searched range by range. Throws like `overlapping_pairs`.
template <Dim N, class T>
GRAZE_EXPORT void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit,
                                     const PairOptions& options = {});

namespace detail {

/// Holds at most `most` pairs at a time, or twice the number of boxes if that is more.
template <Dim N, class T>
GRAZE_EXPORT void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit,
                                     const PairOptions& options, std::size_t most);

}  // namespace detail

}  // namespace graze
