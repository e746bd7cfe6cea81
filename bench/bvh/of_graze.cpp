// SPDX-License-Identifier: MIT
#include <limits>

#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

template <Dim N, class Index>
class OneByOne {
 public:
  explicit OneByOne(Index index = Index()) : empty_(index), index_(std::move(index)) {}

  void build(std::span<const Box<N>> boxes) {
    index_ = empty_;
    keys_.clear();
    keys_.reserve(boxes.size());
    for (const Box<N>& box : boxes) keys_.push_back(index_.insert(box));
  }
  void move(std::span<const Box<N>> boxes, const Share& share) {
    for (std::size_t k = share.first; k < boxes.size(); k += share.step) index_.update(keys_[k], boxes[k]);
  }
  template <class Visit>
  void query(const Box<N>& region, const Visit& visit) const {
    index_.query(region, [&visit](const graze::Key& key) { visit(std::size_t{key.index}); });
  }
  double first_hit(const Ray<N>& ray) const {
    double first = std::numeric_limits<double>::infinity();
    index_.ray_cast(ray, [&first](const graze::Key&, double t) {
      first = t;
      return false;
    });
    return first;
  }
  double nearest(const Point<N>& point, std::size_t k) const {
    return index_.nearest(point, k).back().distance_squared;
  }

 protected:
  /// Inserts into an empty index, so that the indices of keys are the numbers of boxes.
  void build_at_once(std::span<const Box<N>> boxes) {
    index_ = empty_;
    keys_ = index_.assign(boxes, graze::serial_executor());
  }

 private:
  Index empty_;
  Index index_;
  std::vector<graze::Key> keys_;
};

template <Dim N>
struct WithMargin : OneByOne<N, graze::Bvh<N>> {
  WithMargin() : OneByOne<N, graze::Bvh<N>>(graze::Bvh<N>({.margin = 0.2})) {}
};

template <Dim N>
struct AtOnce : OneByOne<N, graze::Bvh<N>> {
  void build(std::span<const Box<N>> boxes) { this->build_at_once(boxes); }
};

}  // namespace

template <Dim N>
void enter_graze(Entrants<N>& field) {
  field.push_back(entrant<N, AtOnce<N>>("Bvh, built at once", Keeps::both));
  field.push_back(entrant<N, OneByOne<N, graze::Bvh<N>>>("Bvh, one by one", Keeps::both));
  field.push_back(entrant<N, WithMargin<N>>("Bvh, margin 0.2"));
  field.push_back(entrant<N, OneByOne<N, graze::Orthtree<N>>>(N == 2 ? "QuadTree" : "Octree"));
  field.push_back(entrant<N, OneByOne<N, graze::Grid<N>>>("Grid"));
  for (Entrant<N>& entrant : field) entrant.is_graze = true;
  field[0].is_judged = field[1].is_judged = true;
}

template void enter_graze(Entrants<2>&);
template void enter_graze(Entrants<3>&);

}  // namespace bench
