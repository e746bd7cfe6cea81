// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pairs/pair_sink.hpp>

namespace graze::detail {

/// Memory that is kept between calls.
class KeptPairSink final : public PairSink {
 public:
  Pair* all(std::size_t count) override {
    pairs_.require(count);
    written_ = std::max(written_, count);
    return pairs_.data();
  }
  std::span<Pair> ahead(std::size_t expected) override {
    if (expected > pairs_.capacity()) pairs_.require(expected + expected / 16);
    written_ = std::max(written_, expected);
    return {pairs_.data(), pairs_.capacity()};
  }
  bool appends() const override { return false; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override { return nullptr; }

  /// The memory held, as far as it has been written to: the system provides pages only then.
  std::size_t bytes() const { return std::min(written_, pairs_.capacity()) * sizeof(Pair); }

 private:
  Buffer<Pair> pairs_;
  std::size_t written_ = 0;  // pairs, at most
};

/// Pairs in a new vector. Clearing its pages may take longer than finding the pairs, so pages are prefaulted in
/// batches, just before they are written, by all threads.
class PairList final : public PairSink {
 public:
  explicit PairList(const Executor& executor) : executor_(executor) {}

  Pair* all(std::size_t count) override;
  Pair* all_in_turns(std::size_t count) override;
  void reach(std::size_t end) override;
  void reach_by_all(std::size_t end) override;
  std::span<Pair> ahead(std::size_t expected) override;
  bool appends() const override { return true; }
  const Pair* append(std::span<const Pair> pairs, std::size_t expected) override;

  /// Returns the list. Its capacity is at most twice its size.
  std::vector<Pair> take();

 private:
  void prefault_to(std::size_t count);

  const Executor& executor_;
  std::vector<Pair> pairs_;
  std::size_t prefaulted_ = 0;  // pairs whose memory is prefaulted
};

}  // namespace graze::detail
