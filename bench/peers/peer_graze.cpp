// SPDX-License-Identifier: MIT
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/pairs.hpp>

#include "contestant.hpp"

namespace graze::race {
namespace {

/// Keeps nothing between frames, not even memory: the simplest way to use graze.
template <Dim N, class T>
class FreeFunction final : public Contestant<N, T> {
 public:
  FreeFunction(std::shared_ptr<const Executor> executor, PairOrder order)
      : executor_(std::move(executor)), order_(order) {}

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) override {
    PairOptions options;
    options.executor = executor_.get();
    options.order = order_;
    pairs_ = overlapping_pairs(boxes, options);
    return pairs_;
  }

 private:
  std::shared_ptr<const Executor> executor_;
  PairOrder order_;
  std::vector<Pair> pairs_;
};

template <Dim N, class T>
class Finder final : public Contestant<N, T> {
 public:
  Finder(std::shared_ptr<const Executor> executor, PairOrder order) : executor_(std::move(executor)), order_(order) {}

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) override {
    PairOptions options;
    options.executor = executor_.get();
    options.order = order_;
    return finder_.find(boxes, options);
  }

 private:
  std::shared_ptr<const Executor> executor_;
  PairOrder order_;
  PairFinder<N, T> finder_;
};

template <Dim N, class T>
void enter_with(Entrants<N, T>& field, std::size_t threads) {
  using Boxes = std::span<const Aabb<N, T>>;
  const std::shared_ptr<const Executor> executor = limited_executor(threads);
  const auto enter = [&](const std::string& name, const std::string& settings, auto prepare) {
    Entrant<N, T> entrant;
    entrant.name = threads == 1 ? name : name + ", " + std::to_string(threads) + " threads";
    entrant.settings = settings;
    entrant.side = Side::graze;
    entrant.threads = threads;
    entrant.keeps = !name.starts_with("graze overlapping_pairs");
    entrant.prepare = prepare;
    field.push_back(std::move(entrant));
  };
  enter("graze overlapping_pairs", "the defaults: method chosen from the data, pairs sorted, new list",
        [executor](Boxes) { return std::make_unique<FreeFunction<N, T>>(executor, PairOrder::sorted); });
  enter("graze overlapping_pairs, any order", "the same, pairs as they are found",
        [executor](Boxes) { return std::make_unique<FreeFunction<N, T>>(executor, PairOrder::any); });
  enter("graze PairFinder", "memory, and the order of boxes while it is useful, kept between frames, pairs sorted",
        [executor](Boxes) { return std::make_unique<Finder<N, T>>(executor, PairOrder::sorted); });
  enter("graze PairFinder, any order", "the same, pairs as they are found",
        [executor](Boxes) { return std::make_unique<Finder<N, T>>(executor, PairOrder::any); });
}

}  // namespace

template <Dim N, class T>
void enter_graze(Entrants<N, T>& field, std::size_t threads) {
  enter_with(field, 1);
  if (threads > 1) enter_with(field, threads);
}

template void enter_graze(Entrants<2, float>& field, std::size_t threads);
template void enter_graze(Entrants<2, double>& field, std::size_t threads);
template void enter_graze(Entrants<3, float>& field, std::size_t threads);
template void enter_graze(Entrants<3, double>& field, std::size_t threads);

}  // namespace graze::race
