// SPDX-License-Identifier: MIT
// Tried with 4, 6, 10 (the default) and 16 boxes per node: within 5 % of each other.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <geos/geom/Envelope.h>
#include <geos/index/strtree/TemplateSTRtree.h>
#include <geos/version.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

/// The tree is packed in every frame and queried once for each box, in the order of its leaves, where neighbours are
/// adjacent; a million boxes take half of the time of queries in index order. Floats are converted to doubles, exactly.
template <class T>
class StrTree final : public Contestant<2, T> {
 public:
  explicit StrTree(ListMemory memory) : memory_(memory) {}

  std::span<const Pair> find(std::span<const Aabb<2, T>> boxes) override {
    clear(pairs_, memory_);
    geos::index::strtree::TemplateSTRtree<std::uint32_t> tree(10, boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(envelope(boxes[i]), i);
    for (const std::uint32_t i : tree.items()) {
      tree.query(envelope(boxes[i]), [this, i](std::uint32_t hit) {
        if (i < hit) pairs_.push_back({i, hit});
      });
    }
    return pairs_;
  }

 private:
  static geos::geom::Envelope envelope(const Aabb<2, T>& box) {
    return {box.min[0], box.max[0], box.min[1], box.max[1]};
  }

  ListMemory memory_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
void enter_geos(Entrants<N, T>& field) {
  if constexpr (N == 2) {
    for (const ListMemory memory : list_memories) {
      Entrant<N, T> entrant;
      entrant.name = "GEOS STRtree";
      entrant.settings =
          "GEOS " GEOS_VERSION ", in double, packed anew, 10 in a node, queried in the order of its leaves";
      set_list_memory(entrant, memory);
      entrant.prepare = [memory](std::span<const Aabb<N, T>>) { return std::make_unique<StrTree<T>>(memory); };
      field.push_back(std::move(entrant));
    }
  }
}

template void enter_geos(Entrants<2, float>& field);
template void enter_geos(Entrants<2, double>& field);
template void enter_geos(Entrants<3, float>& field);
template void enter_geos(Entrants<3, double>& field);

}  // namespace graze::race
