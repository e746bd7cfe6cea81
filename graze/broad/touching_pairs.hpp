// SPDX-License-Identifier: MIT
// The exact test of many candidate pairs at once, after the broad phase.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

struct TouchOptions {
  const Executor* executor = nullptr;  ///< Who runs parallel work; none means default_executor().
};

/// relation(shapes[pair.a], shapes[pair.b]) of every pair, in their order: the same answers as one call each. Pairs of
/// spheres, boxes, oriented boxes and capsules are settled by vectors of the shapes' own type where they clearly touch
/// or do not, all others one by one in double. Shapes must be valid, as for `relation`. Throws std::out_of_range when a
/// pair names a shape that is not there. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
std::vector<Relation> relations(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> pairs,
                                const TouchOptions& options = {});

/// Those of the candidates whose shapes intersect (touching counts), in their order. Errors as above.
template <Dim N, class T>
std::vector<Pair> touching_pairs(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options = {});

/// The same for shapes of one type, which need not be sorted by kind first: Sphere, Aabb, Obb or Capsule.
template <class S>
std::vector<Pair> touching_pairs(std::span<const S> shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options = {});

/// The same for a vector, whose type deduces where a span's does not.
template <class S>
std::vector<Pair> touching_pairs(const std::vector<S>& shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options = {}) {
  return touching_pairs(std::span<const S>(shapes), candidates, options);
}

namespace detail {

/// Two shapes wherever they are kept.
template <Dim N, class T>
struct ShapePair {
  const AnyShape<N, T>* a;
  const AnyShape<N, T>* b;
};

/// Their relations, found by the calling thread. `out` has room for as many.
template <Dim N, class T>
void relations_of(std::span<const ShapePair<N, T>> pairs, Relation* out);

}  // namespace detail
}  // namespace graze
