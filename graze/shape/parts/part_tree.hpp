// SPDX-License-Identifier: MIT
// A static tree over the boxes of a compound's parts, built once and never changed.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// For `PartTree::visit`: boxes in any order.
struct InAnyOrder {};

/// For `PartTree::visit`: boxes by may_matter.key(box), the least first; NaN for a box that does not matter. If
/// may_matter accepts less by now, may_matter.admits(key) tells whether a box still matters.
struct ByKey {};

/// A tree of four children per node without pointers: level 0 holds the boxes of the parts, sorted so that neighbours
/// in space are neighbours in the list; each box of the level above is around the next four. Boxes that are not finite
/// are not in the tree.
template <Dim N, class T>
class PartTree {
 public:
  /// The box of each part, large enough that a part which it does not let a query reach cannot matter to that query,
  /// and the box around the whole compound, and whether none of its lengths needs scaling.
  PartTree(std::span<const Aabb<N, T>> boxes, const Aabb<N, T>& whole, bool has_usual_lengths)
      : bounds_(whole), has_usual_lengths_(has_usual_lengths) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const bool is_bounded = is_finite(boxes[i].min) && is_finite(boxes[i].max);
      (is_bounded ? parts_ : unbounded_).push_back(i);
    }
    std::vector<Vec<N, double>> centers;
    centers.reserve(boxes.size());
    for (const Aabb<N, T>& box : boxes) {
      centers.push_back(wide<N, T>(box.min) * 0.5 + wide<N, T>(box.max) * 0.5);
    }
    sort(centers, parts_);
    for (const std::uint32_t part : parts_) boxes_.push_back(boxes[part]);
    add_levels();
  }

  /// The box around all parts.
  const Aabb<N, T>& bounds() const { return bounds_; }
  /// Whether no length of a part needs scaling; see query/scaling/range.hpp.
  bool has_usual_lengths() const { return has_usual_lengths_; }

  /// The box around the boxes in the tree.
  Aabb<N, T> around() const { return boxes_.empty() ? Aabb<N, T>::nothing() : boxes_.back(); }

  /// The parts that are not in the tree, in order.
  std::span<const std::uint32_t> unbounded() const { return unbounded_; }

  /// Calls visit(index of a part) until it returns false: for each part in the tree whose box, and every box around it,
  /// may_matter(box) accepts. Of the boxes in a node, those with the least order(box) come first, or InAnyOrder or
  /// ByKey. `may_matter` may accept less from call to call.
  template <class MayMatter, class Order, class Visit>
  void visit(const MayMatter& may_matter, const Order& order, const Visit& visit) const {
    if (parts_.empty()) return;
    Waiting waiting;
    if (may_matter(boxes_.back())) waiting.places[waiting.count++] = {0, static_cast<std::uint32_t>(height_)};
    if constexpr (std::is_same_v<Order, ByKey>) waiting.keys[0] = may_matter.key(boxes_.back());
    while (waiting.count > 0) {
      const Place place = waiting.places[--waiting.count];
      if constexpr (std::is_same_v<Order, ByKey>) {
        if (!may_matter.admits(waiting.keys[waiting.count])) continue;
      } else if constexpr (!std::is_same_v<Order, InAnyOrder>) {
        if (!may_matter(box_at(place))) continue;
      }
      if (place.level == 0) {
        if (!visit(parts_[place.index])) return;
      } else {
        add_children(place, may_matter, order, waiting);
      }
    }
  }

 private:
  static constexpr std::uint32_t width = 4;
  static constexpr std::size_t most_levels = 17;                              // of 2^32 boxes
  static constexpr std::size_t most_waiting = most_levels * (width - 1) + 1;  // each step takes one and adds four

  struct Place {
    std::uint32_t index;  ///< Within its level.
    std::uint32_t level;
  };

  const Aabb<N, T>& box_at(const Place& place) const { return boxes_[first_of_level_[place.level] + place.index]; }
  std::size_t size_of_level(std::size_t level) const { return first_of_level_[level + 1] - first_of_level_[level]; }

  /// The boxes that are still to be visited, the next one last, and their keys.
  struct Waiting {
    std::array<Place, most_waiting> places;
    std::array<double, most_waiting> keys;
    std::size_t count = 0;
  };

  /// Puts the children that may matter on top of the places that wait, the first of the order at the very top.
  template <class MayMatter, class Order>
  void add_children(const Place& parent, const MayMatter& may_matter, const Order& order, Waiting& waiting) const {
    const std::uint32_t level = parent.level - 1;
    const std::uint32_t begin = parent.index * width;
    const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(begin + width, size_of_level(level)));
    const std::size_t bottom = waiting.count;
    for (std::uint32_t index = begin; index < end; ++index) {
      const Place child{index, level};
      const Aabb<N, T>& box = box_at(child);
      double key = 0;
      if constexpr (std::is_same_v<Order, ByKey>) {
        key = may_matter.key(box);
        if (!may_matter.admits(key)) continue;
      } else {
        if (!may_matter(box)) continue;
        if constexpr (!std::is_same_v<Order, InAnyOrder>) key = order(box);
      }
      std::size_t place = waiting.count++;
      if constexpr (!std::is_same_v<Order, InAnyOrder>) {
        for (; place > bottom && waiting.keys[place - 1] < key; --place) {
          waiting.keys[place] = waiting.keys[place - 1];
          waiting.places[place] = waiting.places[place - 1];
        }
        waiting.keys[place] = key;
      }
      waiting.places[place] = child;
    }
  }

  /// Sorts the parts so that every block of 4, 16, 64, ... is compact: by halving blocks along the axis on which their
  /// centers differ most.
  static void sort(const std::vector<Vec<N, double>>& centers, std::span<std::uint32_t> parts) {
    if (parts.size() <= width) return;
    std::size_t block = width;
    while (block * width < parts.size()) block *= width;
    const std::size_t blocks = (parts.size() + block - 1) / block;
    const std::size_t middle = (blocks + 1) / 2 * block;
    const Dim axis = longest_axis(centers, parts);
    const auto is_before = [&centers, axis](std::uint32_t a, std::uint32_t b) {
      const double of_a = centers[a][axis];
      const double of_b = centers[b][axis];
      return of_a != of_b ? of_a < of_b : a < b;
    };
    std::nth_element(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(middle), parts.end(), is_before);
    sort(centers, parts.first(middle));
    sort(centers, parts.subspan(middle));
  }

  static Dim longest_axis(const std::vector<Vec<N, double>>& centers, std::span<const std::uint32_t> parts) {
    Aabb<N, double> around = Aabb<N, double>::nothing();
    for (const std::uint32_t part : parts) around.grow(centers[part]);
    const Vec<N, double> size = around.half_extents();
    Dim longest = 0;
    for (Dim i = 1; i < N; ++i) {
      if (size[i] > size[longest]) longest = i;
    }
    return longest;
  }

  void add_levels() {
    std::size_t begin = 0;
    first_of_level_[1] = boxes_.size();
    while (boxes_.size() - begin > 1) {
      const std::size_t end = boxes_.size();
      for (; begin < end; begin += width) {
        Aabb<N, T> around = boxes_[begin];
        for (std::size_t i = begin + 1; i < std::min(begin + width, end); ++i) around.grow(boxes_[i]);
        boxes_.push_back(around);
      }
      begin = end;
      ++height_;
      first_of_level_[height_ + 1] = boxes_.size();
    }
  }

  Aabb<N, T> bounds_;
  bool has_usual_lengths_;
  std::vector<std::uint32_t> parts_;      ///< In the order of level 0.
  std::vector<std::uint32_t> unbounded_;  ///< Parts without a finite box.
  std::vector<Aabb<N, T>> boxes_;         ///< Level by level; the root comes last.
  std::array<std::size_t, most_levels + 1> first_of_level_{};
  std::size_t height_ = 0;
};

}  // namespace graze::detail
