// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <graze/broad/pairs.hpp>
#include <graze/broad/pairs/dense_search.hpp>
#include <graze/broad/pairs/pair_search.hpp>

namespace graze::detail {

/// All methods and their memory, and the choice between them.
template <Dim N, class T>
class PairMethods {
 public:
  using Boxes = std::span<const Aabb<N, T>>;

  /// The pairs of one set, where `boxes_b` is null, or between two: in the room that is given for them, or in memory of
  /// its own, where they stay until the next call.
  std::span<const Pair> find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, PairSink& room);
  void visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, const PairVisitor& visitor);

  PairMethod last() const { return last_; }

  /// The memory that is held, that of pairs too, and what was needed in passing when they were last sorted.
  std::size_t bytes() const { return tree_.bytes() + dense_.bytes(); }

 private:
  PairMethod last_ = PairMethod::automatic;
  PairSearch<N, T> tree_;
  DenseSearch<N, T> dense_;
};

/// Whether `dense` is likely to be quicker than `tree`, by the number of boxes and a sample of their pairs.
template <Dim N, class T>
bool is_for_dense(std::type_identity_t<std::span<const Aabb<N, T>>> boxes_a,
                  const std::type_identity_t<std::span<const Aabb<N, T>>>* boxes_b, double margin = 0);

}  // namespace graze::detail
