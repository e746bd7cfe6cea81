// SPDX-License-Identifier: MIT
// Tried with cutoffs of 10, 100, 1,000, 4,000, 16,000 and of 3, 4 and 8 times the square root of n, on boxes and on
// pointers to them: values and 4 sqrt(n) are the fastest, from a thousand to a million boxes.
#define CGAL_LINKED_WITH_TBB  // defined by CGAL's support target for oneTBB
#include <array>              // missing in CGAL
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/task_arena.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

/// The interface that CGAL requires of a box. Its own Box_d draws ids from a counter shared by all threads; an index
/// costs less.
template <Dim N, class T>
struct NumberedBox {
  using NT = T;
  using ID = std::uint32_t;

  Aabb<N, T> box;
  std::uint32_t index = 0;

  static int dimension() { return N; }
  ID id() const { return index; }
  T min_coord(int axis) const { return box.min[axis]; }
  T max_coord(int axis) const { return box.max[axis]; }
};

/// A streamed segment tree (Zomorodian and Edelsbrunner 2000) that reorders the boxes, so they are copied in every
/// frame. Sets smaller than the cutoff are swept. The default of 10 takes three times as long.
template <Dim N, class T>
class SegmentTree final : public Contestant<N, T> {
 public:
  explicit SegmentTree(ListMemory memory) : memory_(memory) {}

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) override {
    clear(pairs_, memory_);
    numbered_.resize(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) numbered_[i] = {boxes[i], i};
    const auto cutoff = static_cast<std::ptrdiff_t>(4 * std::sqrt(boxes.size()));
    CGAL::box_self_intersection_d(
        numbered_.begin(), numbered_.end(),
        [this](const auto& a, const auto& b) { pairs_.push_back(ascending(a.index, b.index)); }, cutoff,
        CGAL::Box_intersection_d::CLOSED);
    return pairs_;
  }

 private:
  ListMemory memory_;
  std::vector<NumberedBox<N, T>> numbered_;
  std::vector<Pair> pairs_;
};

/// The same with CGAL's Parallel_tag, which copies the boxes four more times and always divides the work into 16 tasks.
/// Each thread has a list of its own; the lists are concatenated.
template <Dim N, class T>
class ParallelSegmentTree final : public Contestant<N, T> {
 public:
  ParallelSegmentTree(ListMemory memory, std::size_t threads) : memory_(memory), arena_(static_cast<int>(threads)) {}

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) override {
    clear(pairs_, memory_);
    for (std::vector<Pair>& list : lists_) clear(list, memory_);
    numbered_.resize(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) numbered_[i] = {boxes[i], i};
    const auto cutoff = static_cast<std::ptrdiff_t>(4 * std::sqrt(boxes.size()));
    arena_.execute([&] {
      CGAL::box_self_intersection_d<CGAL::Parallel_tag>(
          numbered_.begin(), numbered_.end(),
          [this](const auto& a, const auto& b) { lists_.local().push_back(ascending(a.index, b.index)); }, cutoff,
          CGAL::Box_intersection_d::CLOSED);
    });
    for (const std::vector<Pair>& list : lists_) pairs_.insert(pairs_.end(), list.begin(), list.end());
    return pairs_;
  }

 private:
  ListMemory memory_;
  tbb::task_arena arena_;
  std::vector<NumberedBox<N, T>> numbered_;
  tbb::enumerable_thread_specific<std::vector<Pair>> lists_;
  std::vector<Pair> pairs_;
};

template <Dim N, class T>
void enter_with(Entrants<N, T>& field, ListMemory memory, std::size_t threads) {
  Entrant<N, T> entrant;
  entrant.name = "CGAL box_self_intersection_d";
  entrant.settings = "CGAL " CGAL_VERSION_STR ", boxes by value, cutoff 4 sqrt(n)";
  set_list_memory(entrant, memory);
  entrant.threads = threads;
  if (threads > 1) entrant.name += ", " + std::to_string(threads) + " threads";
  entrant.prepare = [memory, threads](std::span<const Aabb<N, T>>) -> std::unique_ptr<Contestant<N, T>> {
    if (threads > 1) return std::make_unique<ParallelSegmentTree<N, T>>(memory, threads);
    return std::make_unique<SegmentTree<N, T>>(memory);
  };
  field.push_back(std::move(entrant));
}

}  // namespace

template <Dim N, class T>
void enter_cgal(Entrants<N, T>& field, std::size_t threads) {
  for (const ListMemory memory : list_memories) enter_with(field, memory, 1);
  if (threads == 1) return;
  for (const ListMemory memory : list_memories) enter_with(field, memory, threads);
}

template void enter_cgal(Entrants<2, float>& field, std::size_t threads);
template void enter_cgal(Entrants<2, double>& field, std::size_t threads);
template void enter_cgal(Entrants<3, float>& field, std::size_t threads);
template void enter_cgal(Entrants<3, double>& field, std::size_t threads);

}  // namespace graze::race
