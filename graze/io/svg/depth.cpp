// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include <graze/io/svg/depth.hpp>

namespace graze::io::svg {
namespace {

constexpr std::size_t most_comparisons = 30'000'000;
constexpr std::size_t most_orders = 4'000'000;

/// `first` must be painted before `second`.
struct Order {
  std::uint32_t first;
  std::uint32_t second;
};

/// The 2D bounds of a 3D box as seen.
Aabb<2, double> shadow(const Aabb<3, double>& box, const View<3>& view) {
  const Vec<3, double> half = box.half_extents();
  const Vec<2, double> reach(dot(half, abs(view.right)), dot(half, abs(view.up)));
  return Aabb<2, double>::from_center(seen(box.center(), view), reach);
}

/// How far `back` lies behind `front`: the widest gap along an axis; negative if they overlap along all axes.
double gap_behind(const Aabb<3, double>& back, const Aabb<3, double>& front, const Vec<3, double>& viewer) {
  double widest = -std::numeric_limits<double>::infinity();
  for (Dim i = 0; i < 3; ++i) {
    if (viewer[i] > 0) widest = std::max(widest, front.min[i] - back.max[i]);
    if (viewer[i] < 0) widest = std::max(widest, back.min[i] - front.max[i]);
  }
  return widest;
}

class DepthOrder {
 public:
  DepthOrder(std::span<const Layered> things, const View<3>& view)
      : things_(things), view_(view), viewer_(to_viewer(view)), by_depth_(things.size()), rank_(things.size()) {
    std::vector<double> depths;
    depths.reserve(things.size());
    for (const Layered& thing : things) depths.push_back(dot(thing.box.center(), viewer_));
    std::iota(by_depth_.begin(), by_depth_.end(), std::uint32_t{0});
    std::stable_sort(by_depth_.begin(), by_depth_.end(),
                     [&depths](std::uint32_t a, std::uint32_t b) { return depths[a] < depths[b]; });
    for (std::uint32_t i = 0; i < by_depth_.size(); ++i) rank_[by_depth_[i]] = i;
  }

  std::vector<std::size_t> order() {
    if (!find_orders()) orders_.clear();
    return sorted();
  }

 private:
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const Layered& one = things_[a];
    const Layered& other = things_[b];
    if (one.sheet && !other.sheet) return is_under(*one.sheet, other.box);
    if (other.sheet && !one.sheet) return !is_under(*other.sheet, one.box);
    if (!one.sheet) {
      const double forth = gap_behind(one.box, other.box, viewer_);
      const double back = gap_behind(other.box, one.box, viewer_);
      if (forth != back) return forth > back;
    }
    return rank_[a] < rank_[b];
  }

  /// True if the box's center lies on the viewer's side of the sheet.
  bool is_under(const Plane<3, double>& sheet, const Aabb<3, double>& box) const {
    const Plane<3, double> unit = unit_plane(sheet);
    const double height = dot(unit.normal, box.center()) - unit.offset;
    return dot(unit.normal, viewer_) >= 0 ? height >= 0 : height <= 0;
  }

  /// All pairs that overlap on screen, found by a sweep from left to right; false if there are too many.
  bool find_orders() {
    std::vector<Aabb<2, double>> shadows;
    shadows.reserve(things_.size());
    for (const Layered& thing : things_) shadows.push_back(shadow(thing.box, view_));
    std::vector<std::uint32_t> from_left(by_depth_);
    std::stable_sort(from_left.begin(), from_left.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return shadows[a].min.x < shadows[b].min.x; });
    std::vector<std::uint32_t> open;
    std::size_t comparisons = 0;
    for (const std::uint32_t next : from_left) {
      std::erase_if(open, [&](std::uint32_t other) { return shadows[other].max.x < shadows[next].min.x; });
      comparisons += open.size();
      if (comparisons > most_comparisons) return false;
      for (const std::uint32_t other : open) {
        if (!boxes_overlap(shadows[other], shadows[next])) continue;
        if (orders_.size() == most_orders) return false;
        orders_.push_back(is_before(other, next) ? Order{other, next} : Order{next, other});
      }
      open.push_back(next);
    }
    return true;
  }

  /// Topological sort (Kahn 1962); of the items without predecessors the farthest comes first.
  std::vector<std::size_t> sorted() {
    std::sort(orders_.begin(), orders_.end(), [](const Order& a, const Order& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    std::vector<std::size_t> waiting_for(things_.size(), 0);
    for (const Order& relation : orders_) ++waiting_for[relation.second];
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready;  // ranks
    for (std::uint32_t i = 0; i < things_.size(); ++i) {
      if (waiting_for[i] == 0) ready.push(rank_[i]);
    }
    std::vector<bool> done(things_.size(), false);
    std::vector<std::size_t> result;
    result.reserve(things_.size());
    std::uint32_t farthest = 0;
    while (result.size() < things_.size()) {
      while (done[by_depth_[farthest]]) ++farthest;
      std::uint32_t next = by_depth_[farthest];  // breaks a cycle if nothing is ready
      if (!ready.empty()) {
        next = by_depth_[ready.top()];
        ready.pop();
        if (done[next]) continue;
      }
      done[next] = true;
      result.push_back(next);
      const auto [first, last] = std::equal_range(orders_.begin(), orders_.end(), Order{next, 0},
                                                  [](const Order& a, const Order& b) { return a.first < b.first; });
      for (auto relation = first; relation != last; ++relation) {
        if (--waiting_for[relation->second] == 0) ready.push(rank_[relation->second]);
      }
    }
    return result;
  }

  std::span<const Layered> things_;
  View<3> view_;
  Vec<3, double> viewer_;
  std::vector<std::uint32_t> by_depth_;  ///< Items from far to near, by their centers.
  std::vector<std::uint32_t> rank_;      ///< The position of each item in `by_depth_`.
  std::vector<Order> orders_;
};

}  // namespace

std::vector<std::size_t> back_to_front(std::span<const Layered> things, const View<3>& view) {
  return DepthOrder(things, view).order();
}

}  // namespace graze::io::svg
