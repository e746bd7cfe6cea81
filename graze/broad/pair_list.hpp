// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/buffer.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/pair_room.hpp>

namespace graze::detail {

/// Room that is kept from call to call.
class KeptPairRoom final : public PairRoom {
 public:
  Pair* all(std::size_t count) override {
    pairs_.require(count);
    return pairs_.data();
  }
  bool appends() const override { return false; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override { return nullptr; }

  /// The memory that is held.
  std::size_t bytes() const { return pairs_.bytes(); }

 private:
  Buffer<Pair> pairs_;
};

/// Room in a list that is made anew. To have the system clear its pages may take longer than to find the pairs: they
/// are asked for many at a time, just before they are written, by as many threads as there are.
class PairList final : public PairRoom {
 public:
  explicit PairList(const Executor& executor) : executor_(executor) {}

  Pair* all(std::size_t count) override;
  Pair* all_in_turns(std::size_t count) override;
  void reach(std::size_t end) override;
  bool appends() const override { return true; }
  const Pair* append(std::span<const Pair> pairs, std::size_t expected) override;

  /// The list, which is given away. It has at most twice the capacity that it needs.
  std::vector<Pair> take();

 private:
  void populate_to(std::size_t count);

  const Executor& executor_;
  std::vector<Pair> pairs_;
  std::size_t populated_ = 0;  // so many pairs' memory
};

}  // namespace graze::detail
