// SPDX-License-Identifier: MIT
// Tried with 4, 6, 8, 12 and 16 boxes per node, and built with -march=native: 8 without is the fastest.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/version.hpp>

#include "contestant.hpp"

namespace graze::race {
namespace {

namespace geometry = boost::geometry;

/// The R-tree has no query for pairs: it is packed in every frame and queried once for each box. Queries are in the
/// order of its leaves, where neighbours are adjacent; a million boxes take 0.6 of the time of queries in index order.
template <Dim N, class T>
class PackedTree final : public Contestant<N, T> {
 public:
  explicit PackedTree(ListMemory memory) : memory_(memory) {}

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) override {
    clear(pairs_, memory_);
    entries_.resize(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      entries_[i] = {{corner(boxes[i].min), corner(boxes[i].max)}, i};
    }
    const Tree tree(entries_);
    for (const Entry& entry : tree) {
      const auto add = [this, i = entry.second](const Entry& hit) {
        if (i < hit.second) pairs_.push_back({i, hit.second});
      };
      tree.query(geometry::index::intersects(entry.first), boost::make_function_output_iterator(add));
    }
    return pairs_;
  }

 private:
  using Point = geometry::model::point<T, N, geometry::cs::cartesian>;
  using Entry = std::pair<geometry::model::box<Point>, std::uint32_t>;
  // A packed tree never uses its splitting rule.
  using Tree = geometry::index::rtree<Entry, geometry::index::linear<8>>;

  static Point corner(const Vec<N, T>& v) {
    Point point;
    geometry::set<0>(point, v[0]);
    geometry::set<1>(point, v[1]);
    if constexpr (N == 3) geometry::set<2>(point, v[2]);
    return point;
  }

  ListMemory memory_;
  std::vector<Entry> entries_;
  std::vector<Pair> pairs_;
};

template <Dim N, class T>
void enter_with(Entrants<N, T>& field, ListMemory memory) {
  Entrant<N, T> entrant;
  entrant.name = "Boost.Geometry rtree";
  entrant.settings = "Boost " + std::to_string(BOOST_VERSION / 100'000) + "." +
                     std::to_string(BOOST_VERSION / 100 % 1000) +
                     ", packed anew, 8 in a node, queried in the order of its leaves";
  set_list_memory(entrant, memory);
  entrant.prepare = [memory](std::span<const Aabb<N, T>>) { return std::make_unique<PackedTree<N, T>>(memory); };
  field.push_back(std::move(entrant));
}

}  // namespace

template <Dim N, class T>
void enter_boost(Entrants<N, T>& field) {
  for (const ListMemory memory : list_memories) enter_with(field, memory);
}

template void enter_boost(Entrants<2, float>& field);
template void enter_boost(Entrants<2, double>& field);
template void enter_boost(Entrants<3, float>& field);
template void enter_boost(Entrants<3, double>& field);

}  // namespace graze::race
