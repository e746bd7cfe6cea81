// SPDX-License-Identifier: MIT
// Boost.Geometry's R-tree. Queries are fastest with nodes of 8, packing with nodes of 32. Also tried: nodes of 16,
// which is in between; insertion one by one with linear splits (queries take two to three times as long) and with the
// splits of the R*-tree (five times as long to build; queries take two thirds of the time, still slower than the packed
// tree).
#include <algorithm>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <graze/query/distance_squared.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

namespace geometry = boost::geometry;

template <Dim N>
using Corner = geometry::model::point<float, N, geometry::cs::cartesian>;

template <Dim N>
Corner<N> corner(const Point<N>& p) {
  if constexpr (N == 2) {
    return {p.x, p.y};
  } else {
    return {p.x, p.y, p.z};
  }
}

/// Packed if it is built from all boxes, by the range constructor. `Kept` is the stored value: a box or a point.
template <Dim N, class Kept, class Parameters>
class RTree {
 public:
  void build(std::span<const Box<N>> boxes) {
    take(boxes);
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) entries.push_back(entry(k));
    tree_ = Tree(entries);
  }
  void move(std::span<const Box<N>> boxes, const Share& share) {
    for (std::size_t k = share.first; k < boxes.size(); k += share.step) {
      tree_.remove(entry(k));
      boxes_[k] = boxes[k];
      tree_.insert(entry(k));
    }
  }
  template <class Visit>
  void query(const Box<N>& region, const Visit& visit) const {
    const auto give = [&visit](const Entry& entry) { visit(std::size_t{entry.second}); };
    tree_.query(
        geometry::index::intersects(geometry::model::box<Corner<N>>(corner<N>(region.min), corner<N>(region.max))),
        boost::make_function_output_iterator(give));
  }
  double nearest(const Point<N>& point, std::size_t k) const {
    double farthest = 0;
    const auto keep = [&](const Entry& entry) {
      farthest = std::max(farthest, graze::distance_squared(point, boxes_[entry.second]));
    };
    tree_.query(geometry::index::nearest(corner<N>(point), static_cast<unsigned>(k)),
                boost::make_function_output_iterator(keep));
    return farthest;
  }

 protected:
  void insert_each(std::span<const Box<N>> boxes) {
    take(boxes);
    tree_ = Tree();
    for (std::size_t k = 0; k < boxes.size(); ++k) tree_.insert(entry(k));
  }

 private:
  using Entry = std::pair<Kept, std::uint32_t>;
  using Tree = geometry::index::rtree<Entry, Parameters>;

  void take(std::span<const Box<N>> boxes) { boxes_.assign(boxes.begin(), boxes.end()); }
  Entry entry(std::size_t k) const {
    if constexpr (std::is_same_v<Kept, Corner<N>>) {
      return {corner<N>(boxes_[k].min), static_cast<std::uint32_t>(k)};
    } else {
      return {{corner<N>(boxes_[k].min), corner<N>(boxes_[k].max)}, static_cast<std::uint32_t>(k)};
    }
  }

  std::vector<Box<N>> boxes_;
  Tree tree_;
};

template <Dim N, class Parameters>
using Packed = RTree<N, geometry::model::box<Corner<N>>, Parameters>;

template <Dim N, class Parameters>
using OfPoints = RTree<N, Corner<N>, Parameters>;

template <Dim N, class Parameters>
struct Inserted : Packed<N, Parameters> {
  void build(std::span<const Box<N>> boxes) { this->insert_each(boxes); }
};

}  // namespace

template <Dim N>
void enter_boost(Entrants<N>& field) {
  using geometry::index::linear;
  using geometry::index::quadratic;
  field.push_back(entrant<N, Packed<N, linear<8>>>("Boost, packed by 8"));
  field.push_back(entrant<N, Packed<N, linear<32>>>("Boost, packed by 32"));
  field.push_back(entrant<N, Inserted<N, quadratic<16>>>("Boost, one by one"));
  field.push_back(entrant<N, OfPoints<N, linear<8>>>("Boost, packed points", Keeps::points));
}

template void enter_boost(Entrants<2>&);
template void enter_boost(Entrants<3>&);

}  // namespace bench
