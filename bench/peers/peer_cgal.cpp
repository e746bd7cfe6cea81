// SPDX-License-Identifier: MIT
// Tried with cutoffs of 10, 100, 1,000, 4,000, 16,000 and of 3, 4 and 8 times the root of n, on boxes and on pointers
// to them: values and 4 sqrt(n) are the quickest, from a thousand boxes to a million.
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

#include "contestant.hpp"

namespace graze::race {
namespace {

/// What CGAL asks of a box. Its own Box_d draws numbers from a counter shared by all threads; an index costs less.
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

/// A streamed segment tree (Zomorodian and Edelsbrunner 2000) over boxes that it moves about: they are copied anew in
/// every frame. Sets smaller than the cutoff are swept. With the default, 10, it takes three times as long.
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

template <Dim N, class T>
void enter_with(Entrants<N, T>& field, ListMemory memory) {
  Entrant<N, T> entrant;
  entrant.name = "CGAL box_self_intersection_d";
  entrant.settings = "CGAL " CGAL_VERSION_STR ", boxes by value, cutoff 4 sqrt(n)";
  set_list_memory(entrant, memory);
  entrant.prepare = [memory](std::span<const Aabb<N, T>>) { return std::make_unique<SegmentTree<N, T>>(memory); };
  field.push_back(std::move(entrant));
}

}  // namespace

template <Dim N, class T>
void enter_cgal(Entrants<N, T>& field) {
  for (const ListMemory memory : list_memories) enter_with(field, memory);
}

template void enter_cgal(Entrants<2, float>& field);
template void enter_cgal(Entrants<2, double>& field);
template void enter_cgal(Entrants<3, float>& field);
template void enter_cgal(Entrants<3, double>& field);

}  // namespace graze::race
