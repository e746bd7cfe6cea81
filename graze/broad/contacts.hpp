// SPDX-License-Identifier: MIT
// Where the shapes of many candidate pairs touch, after the broad phase.
#pragma once

#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// Where two shapes of a sequence touch.
template <Dim N, class T = float>
struct PairContact {
  Pair pair;
  Manifold<N, T> manifold;  ///< From the first to the second.

  friend bool operator==(const PairContact&, const PairContact&) = default;
};

/// manifold(shapes[pair.a], shapes[pair.b]) of those candidates whose shapes intersect (touching counts), in their
/// order: the same answers as one call each, whoever runs them. What does not touch costs little more than with
/// `touching_pairs`, oriented boxes in space up to half as much again. Shapes must be valid, as for `manifold`. Throws
/// std::out_of_range when a pair names a shape that is not there. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                        const TouchOptions& options = {});

/// The same for a vector. (A span's type does not deduce from one, nor N and T from AnyShape.)
template <class Any>
requires detail::is_any_shape<Any>
auto contacts(const std::vector<Any>& shapes, std::span<const Pair> candidates, const TouchOptions& options = {}) {
  return contacts<dimension_of<Any>, scalar_of<Any>>(std::span<const Any>(shapes), candidates, options);
}

namespace detail {

/// Two shapes, and where their manifold from a to b goes, which must be as it is made.
template <Dim N, class T>
struct ShapesToContact {
  ShapePair<N, T> shapes;
  Manifold<N, T>* manifold;
};

/// Writes manifold(*a, *b) of each two, bit for bit, in the calling thread. All must touch, which is not asked again of
/// oriented boxes in space. Takes no memory from the heap.
template <Dim N, class T>
void contacts_of(std::span<const ShapesToContact<N, T>> pairs);

}  // namespace detail
}  // namespace graze
