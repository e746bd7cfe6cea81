// SPDX-License-Identifier: MIT
// All overlapping pairs of many boxes at once.
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
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// How pairs are found. The answer never depends on it. Sizes and clusters are no reason to choose: within the tree,
/// boxes much larger than most stand in blocks of their own, and crowds are sorted more finely.
enum class PairMethod {
  automatic,    ///< `dense` or `tree`, by the number of boxes, and by how many of a sample of their pairs overlap.
  brute_force,  ///< Every box against every other in a plain double loop: the oracle of the rest.
  dense,        ///< The same by vectors: the best for hundreds of boxes, or where most overlap.
  tree,         ///< Blocks of neighbouring boxes in a tree that is met with itself, block by block.
};

/// The name of a method, as the command line spells it.
std::string_view name_of(PairMethod method);

/// The method of that name, if there is one.
std::optional<PairMethod> pair_method_named(std::string_view name);

/// All methods, in the order of the enumeration.
std::span<const PairMethod> all_pair_methods();

/// In which order pairs are given.
enum class PairOrder {
  sorted,  ///< Ascending by a, then b.
  any,     ///< As they are found: quicker, and the same on every machine for the same calls.
};

struct PairOptions {
  const Executor* executor = nullptr;  ///< Who runs parallel work; none means default_executor().
  PairOrder order = PairOrder::sorted;
  double margin = 0;  ///< Every box is first grown by this much on every side, in the boxes' own arithmetic; >= 0.
  PairMethod method = PairMethod::automatic;
};

/// Every pair of boxes that share a point (touching counts), once, with a < b. Comparisons are exact. Infinite boxes
/// are welcome, boxes that contain nothing (min above max) overlap none. Throws std::invalid_argument when a coordinate
/// is NaN, naming the box, or the margin is negative, infinite or NaN, std::length_error beyond 2^32 - 1 boxes.
/// Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options = {});

/// Every pair of a box of one set (index a) and a box of another (index b) that share a point.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                    const PairOptions& options = {});

/// The same for a vector, whose type deduces where a span's does not.
template <Dim N, class T>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes, const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes), options);
}

// The allocator is deduced so that options in braces are not taken for a second set.
template <Dim N, class T, class Allocator>
std::vector<Pair> overlapping_pairs(const std::vector<Aabb<N, T>>& boxes_a,
                                    const std::vector<Aabb<N, T>, Allocator>& boxes_b,
                                    const PairOptions& options = {}) {
  return overlapping_pairs(std::span<const Aabb<N, T>>(boxes_a), std::span<const Aabb<N, T>>(boxes_b), options);
}

/// Takes pairs by the block; false asks for no more.
using PairVisitor = std::function<bool(std::span<const Pair>)>;

/// The same pairs, given to a visitor by the block instead of stored: what is held at a time does not grow with their
/// number. They come in the order in which they are found, whatever options.order says; the executor's threads find
/// them, the visitor is called from this thread alone.
template <Dim N, class T>
void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit,
                             const PairOptions& options = {});

template <Dim N, class T>
void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairVisitor& visit, const PairOptions& options = {});

/// overlapping_pairs for boxes that move: keeps its memory from frame to frame, and where the boxes lie, which it does
/// not have to find out again while as many have moved a little. The pairs depend on the boxes of the call alone; so
/// does their order if it is `sorted`, and on the calls before if it is `any`.
template <Dim N, class T = float>
class PairFinder {
 public:
  PairFinder();
  ~PairFinder();
  PairFinder(PairFinder&& other) noexcept;
  PairFinder& operator=(PairFinder&& other) noexcept;

  /// As overlapping_pairs. The pairs stay until the next call.
  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes, const PairOptions& options = {});
  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairOptions& options = {});

  /// As visit_overlapping_pairs. What an earlier call has found is lost.
  void visit(std::span<const Aabb<N, T>> boxes, const PairVisitor& visitor, const PairOptions& options = {});
  void visit(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b, const PairVisitor& visitor,
             const PairOptions& options = {});

  /// The method that the last call used: never `automatic`, unless there was no call.
  PairMethod method() const;

  /// The memory that is held, and what was needed in passing when boxes and pairs were last sorted, in bytes, without
  /// the pairs themselves. Lists that have room to spare count as far as they have been written to.
  std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
