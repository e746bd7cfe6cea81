// SPDX-License-Identifier: MIT
/// @file
/// Contact points of many candidate pairs, after the broad phase.
#pragma once

#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// The contact points of two shapes of a sequence.
template <Dim N, class T = float>
struct PairContact {
  Pair pair;                ///< Indices of the two shapes.
  Manifold<N, T> manifold;  ///< The normal points from pair.a to pair.b; at least one point.

  friend bool operator==(const PairContact&, const PairContact&) = default;
};

/// manifold(shapes[pair.a], shapes[pair.b]) for the candidates whose shapes intersect (touching counts), in their
/// order, with the results of single calls on any executor. Candidates that do not touch cost little more than with
/// `touching_pairs`, oriented boxes in 3D up to 1.5x. Shapes must be valid, as for `manifold`. Throws std::out_of_range
/// if an index of a pair is not below the number of shapes. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
GRAZE_EXPORT std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>> shapes,
                                                     std::span<const Pair> candidates,
                                                     const TouchOptions& options = {});

/// The overload for a vector, from which a span's template arguments cannot be deduced.
template <class Any>
requires detail::is_any_shape<Any>
auto contacts(const std::vector<Any>& shapes, std::span<const Pair> candidates, const TouchOptions& options = {}) {
  return contacts<dimension_of<Any>, scalar_of<Any>>(std::span<const Any>(shapes), candidates, options);
}

namespace detail {

/// Two shapes, and the place for their manifold from a to b, which must be default-constructed.
template <Dim N, class T>
struct ShapesToContact {
  ShapePair<N, T> shapes;
  Manifold<N, T>* manifold;
};

/// Writes manifold(*a, *b) of each pair, bit for bit, in the calling thread. All must touch; this is not tested again
/// for oriented boxes in 3D. Allocates nothing.
template <Dim N, class T>
GRAZE_EXPORT void contacts_of(std::span<const ShapesToContact<N, T>> pairs);

}  // namespace detail
}  // namespace graze
