// SPDX-License-Identifier: MIT
/// @file
/// All overlapping pairs of many boxes.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// How pairs are found. The result does not depend on it. Sizes and clusters are no reason to choose: in the tree,
/// boxes much larger than most are kept in separate blocks, and dense regions are sorted more finely.
enum class PairMethod {
  automatic,    ///< `dense` or `tree`, depending on the number of boxes and on how many pairs of a sample overlap.
  brute_force,  ///< Every box against every other in a plain double loop: the reference for the other methods.
  dense,        ///< All pairs with vector instructions: best for hundreds of boxes, or if most overlap.
  tree,         ///< A tree of blocks of neighbouring boxes, traversed against itself block by block.
};

/// The name of a method as the command line spells it.
GRAZE_EXPORT std::string_view name_of(PairMethod method);

/// The method with this name, or none.
GRAZE_EXPORT std::optional<PairMethod> pair_method_named(std::string_view name);

/// All methods, in the order of the enumeration.
GRAZE_EXPORT std::span<const PairMethod> all_pair_methods();

/// The order of the returned pairs.
enum class PairOrder {
  sorted,  ///< Ascending by a, then b.
  any,     ///< As they are found: faster. The same on every machine for the same calls.
};

/// Options of `overlapping_pairs` and its siblings.
struct PairOptions {
  const Executor* executor = nullptr;   ///< Runs parallel work; nullptr means default_executor().
  PairOrder order = PairOrder::sorted;  ///< Ignored by visitors.
  /// Every box is first grown by this much on every side, in the boxes' own arithmetic; at least 0.
  double margin = 0;
  PairMethod method = PairMethod::automatic;  ///< Affects only the time.
};

/// Every pair of boxes that share a point (touching counts), once, with a < b. Exact. Boxes may be infinite; a box that
/// contains nothing (min above max) overlaps none. Throws std::invalid_argument if a coordinate is NaN, naming the box,
/// or if the margin is negative, infinite or NaN, and std::length_error beyond 2^32 - 1 boxes. Instantiated for 2D and
/// 3D, float and double. `visit_overlapping_pairs` needs less memory; a PairFinder is faster for boxes that move.
template <Dim N, class T>
GRAZE_EXPORT std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options = {});

/// Every pair of a box of one sequence (index a) and a box of another (index b) that share a point. Otherwise as for
/// one sequence.
template <Dim N, class T>
GRAZE_EXPORT std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a,
                                                 std::span<const Aabb<N, T>> boxes_b, const PairOptions& options = {});

/// The overload for a vector, from which a span's template arguments cannot be deduced.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes, const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes), options);
}

/// The overload for two vectors. Their allocator is deduced so that options in braces are not taken for a second
/// sequence.
template <Dim N, class T, class Allocator>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes_a,
                                    const std::vector<Aabb<N, T>, Allocator>& boxes_b,
                                    const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes_a), std::span<const Aabb<N, T>>(boxes_b), options);
}

/// Receives a block of pairs; returns false to stop.
using PairVisitor = std::function<bool(std::span<const Pair>)>;

/// Passes the pairs of `overlapping_pairs` to a visitor in blocks instead of storing them: memory does not grow with
/// their number. They come in the order in which they are found, whatever options.order is. The executor's threads find
/// them; the visitor is called only from the calling thread. Throws like `overlapping_pairs`, and what the visitor
/// throws.
template <Dim N, class T>
GRAZE_EXPORT void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit,
                                          const PairOptions& options = {});

/// The pairs of a box of one sequence (index a) and a box of another (index b), passed to a visitor in blocks.
template <Dim N, class T>
GRAZE_EXPORT void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                          const PairVisitor& visit, const PairOptions& options = {});

/// `overlapping_pairs` for boxes that move: keeps its memory and what it knows of the boxes' positions from frame to
/// frame, which saves time while their number stays the same and they move little. The pairs depend only on the boxes
/// of the call; so does their order if it is `sorted`, but not if it is `any`. One thread at a time.
template <Dim N, class T = float>
class GRAZE_EXPORT PairFinder {
 public:
  /// Creates a finder that has seen no boxes.
  PairFinder();
  ~PairFinder();
  /// Takes over memory and pairs; `other` can then only be assigned to or destroyed.
  PairFinder(PairFinder&& other) noexcept;
  /// Takes over memory and pairs; `other` can then only be assigned to or destroyed.
  PairFinder& operator=(PairFinder&& other) noexcept;

  /// As `overlapping_pairs`. The pairs are valid until the next call.
  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes, const PairOptions& options = {});
  /// The pairs between two sequences, valid until the next call.
  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairOptions& options = {});

  /// As `visit_overlapping_pairs`. Invalidates the pairs that `find` returned.
  void visit(std::span<const Aabb<N, T>> boxes, const PairVisitor& visitor, const PairOptions& options = {});
  /// The pairs between two sequences, passed to a visitor in blocks.
  void visit(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b, const PairVisitor& visitor,
             const PairOptions& options = {});

  /// The method that the last call used; `automatic` only before the first call.
  PairMethod method() const;

  /// Memory in use, plus what sorting boxes and pairs temporarily needed last, in bytes, without the pairs themselves.
  /// Lists with spare capacity count as far as they were written.
  std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
