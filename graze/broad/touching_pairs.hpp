// SPDX-License-Identifier: MIT
/// @file
/// The exact test of many candidate pairs, after the broad phase.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// Options of `relations`, `touching_pairs` and `contacts`.
struct TouchOptions {
  const Executor* executor = nullptr;  ///< Runs parallel work; nullptr means default_executor().
};

/// relation(shapes[pair.a], shapes[pair.b]) for every pair, in their order, with the results of single calls. Vector
/// instructions in the shapes' own type decide clear cases of spheres, boxes, oriented boxes and capsules; all others
/// are decided one by one in double. Shapes must be valid, as for `relation`. Throws std::out_of_range if an index of a
/// pair is not below the number of shapes. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
GRAZE_EXPORT std::vector<Relation> relations(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> pairs,
                                             const TouchOptions& options = {});

/// The candidates whose shapes intersect (touching counts), in their order. Shapes and errors as for `relations`.
template <Dim N, class T>
GRAZE_EXPORT std::vector<Pair> touching_pairs(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                              const TouchOptions& options = {});

/// The overload for shapes of one type, which avoids sorting by type: Sphere, Aabb, Obb or Capsule.
template <class S>
GRAZE_EXPORT std::vector<Pair> touching_pairs(std::span<const S> shapes, std::span<const Pair> candidates,
                                              const TouchOptions& options = {});

/// The overload for a vector, from which a span's template arguments cannot be deduced.
template <class S>
std::vector<Pair> touching_pairs(const std::vector<S>& shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options = {}) {
  return touching_pairs(std::span<const S>(shapes), candidates, options);
}

namespace detail {

/// Pointers to two shapes.
template <Dim N, class T>
struct ShapePair {
  const AnyShape<N, T>* a;
  const AnyShape<N, T>* b;
};

/// Writes the relations of the pairs to `out`, which has room for them; runs in the calling thread.
template <Dim N, class T>
GRAZE_EXPORT void relations_of(std::span<const ShapePair<N, T>> pairs, Relation* out);

}  // namespace detail
}  // namespace graze
