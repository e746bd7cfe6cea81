// SPDX-License-Identifier: MIT
#include <array>
#include <memory>

#include <nanoflann.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

/// Points in the interface of nanoflann, which prescribes the names.
template <Dim N>
struct Cloud {
  std::vector<Point<N>> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t k, std::size_t axis) const { return points[k][static_cast<Dim>(axis)]; }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds& /*bounds*/) const {
    return false;
  }
};

/// Points only. Tried: leaves of 5 points (slower), 10 and 32.
template <Dim N>
class KdTree {
 public:
  void build(std::span<const Box<N>> boxes) {
    cloud_.points.clear();
    for (const Box<N>& box : boxes) cloud_.points.push_back(box.min);
    tree_ = std::make_unique<Tree>(static_cast<int>(N), cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size));
  }
  double nearest(const Point<N>& point, std::size_t k) const {
    std::array<std::uint32_t, 8> numbers;  // NOLINT(*-member-init): written before they are read, like the next
    std::array<float, 8> distances;        // NOLINT(*-member-init)
    const std::array<float, 3> query = coordinates(point);
    const std::size_t found = tree_->knnSearch(query.data(), k, numbers.data(), distances.data());
    return static_cast<double>(distances[found - 1]);
  }

 private:
  using Metric = nanoflann::L2_Simple_Adaptor<float, Cloud<N>, float, std::uint32_t>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud<N>, static_cast<int>(N), std::uint32_t>;
  static constexpr std::size_t leaf_size = 16;

  static std::array<float, 3> coordinates(const Point<N>& point) {
    std::array<float, 3> all{};
    for (Dim i = 0; i < N; ++i) all[static_cast<std::size_t>(i)] = point[i];
    return all;
  }

  Cloud<N> cloud_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace

template <Dim N>
void enter_nanoflann(Entrants<N>& field) {
  field.push_back(entrant<N, KdTree<N>>("nanoflann", Keeps::points));
}

template void enter_nanoflann(Entrants<2>&);
template void enter_nanoflann(Entrants<3>&);

}  // namespace bench
