// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <graze/broad/pairs.hpp>
#include <graze/broad/pairs/dense_search.hpp>
#include <graze/broad/pairs/pair_search.hpp>

namespace graze::detail {

/// All methods with their memory, and the choice between them.
template <Dim N, class T>
class PairMethods {
 public:
  using Boxes = std::span<const Aabb<N, T>>;

  /// The pairs within one set if `boxes_b` is null, otherwise between two. They are written to `room` or to memory of
  /// this object, where they are valid until the next call.
  std::span<const Pair> find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, PairSink& room);
  void visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options, const PairVisitor& visitor);

  PairMethod last() const { return last_; }

  /// The memory held, including pairs and the temporary memory of the last sort, in bytes.
  std::size_t bytes() const { return tree_.bytes() + dense_.bytes(); }

 private:
  PairMethod last_ = PairMethod::automatic;
  PairSearch<N, T> tree_;
  DenseSearch<N, T> dense_;
};

/// Whether `dense` is likely to be faster than `tree`, estimated from the number of boxes and a sample of their pairs.
template <Dim N, class T>
bool is_for_dense(std::type_identity_t<std::span<const Aabb<N, T>>> boxes_a,
                  const std::type_identity_t<std::span<const Aabb<N, T>>>* boxes_b, double margin = 0);

}  // namespace graze::detail
