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
    set_boxes(boxes);
    size_when_built_ = size_of_boxes();
  }

  /// A tree of other boxes for the same parts, in the same order as long as its boxes are not much larger, relative to
  /// the whole, than when it was built; then in a new one. All boxes are finite.
  PartTree refitted(std::span<const Aabb<N, T>> boxes, const Aabb<N, T>& whole, bool has_usual_lengths) const {
    if (!unbounded_.empty()) return PartTree(boxes, whole, has_usual_lengths);
    PartTree result = *this;
    result.bounds_ = whole;
    result.has_usual_lengths_ = has_usual_lengths;
    result.set_boxes(boxes);
    constexpr double most_growth = 1.5;
    if (!(result.size_of_boxes() <= most_growth * size_when_built_)) return PartTree(boxes, whole, has_usual_lengths);
    return result;
  }

  /// The box around all parts.
  const Aabb<N, T>& bounds() const { return bounds_; }
  /// Whether no length of a part needs scaling; see query/scaling/range.hpp.
  bool has_usual_lengths() const { return has_usual_lengths_; }

  /// The mean size of the boxes around four others, relative to the whole: how much a query that meets a place visits.
  double size_of_boxes() const {
    const double all = sum_abs(wide<N, T>(bounds_.max) * 0.5 - wide<N, T>(bounds_.min) * 0.5);
    double sum = 0;
    const std::size_t end = boxes_.size();
    for (std::size_t i = first_of_level_[1]; i < end; ++i) {
      sum += sum_abs(wide<N, T>(boxes_[i].max) * 0.5 - wide<N, T>(boxes_[i].min) * 0.5) / all;
    }
    return end > first_of_level_[1] && all > 0 ? sum / static_cast<double>(end - first_of_level_[1]) : 0;
  }

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
    if (may_matter(boxes_.back())) waiting.places[waiting.count++] = root();
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

  /// Calls visit(part of this tree, part of the other) until it returns false: for each pair whose boxes, and every two
  /// boxes around them, may_touch(box, box of the other) accepts. Returns whether all were visited.
  template <class MayTouch, class Visit>
  bool visit_pairs(const PartTree& other, const MayTouch& may_touch, const Visit& visit) const {
    return visit_pairs<false>(other, may_touch, visit);
  }

  /// The same for pairs of two different parts of this tree, each once and in any order.
  template <class MayTouch, class Visit>
  bool visit_own_pairs(const MayTouch& may_touch, const Visit& visit) const {
    return visit_pairs<true>(*this, may_touch, visit);
  }

 private:
  static constexpr std::uint32_t width = 4;
  static constexpr std::size_t most_levels = 17;                              // of 2^32 boxes
  static constexpr std::size_t most_waiting = most_levels * (width - 1) + 1;  // each step takes one and adds four

  struct Place {
    std::uint32_t index;  ///< Within its level.
    std::uint32_t level;

    bool operator==(const Place&) const = default;
  };

  template <bool is_self, class MayTouch, class Visit>
  bool visit_pairs(const PartTree& other, const MayTouch& may_touch, const Visit& visit) const {
    for (std::size_t i = 0; i < unbounded_.size(); ++i) {
      for (std::size_t j = is_self ? i + 1 : 0; j < other.unbounded_.size(); ++j) {
        if (!visit(unbounded_[i], other.unbounded_[j])) return false;
      }
      for (const std::uint32_t part : other.parts_) {
        if (!visit(unbounded_[i], part)) return false;
      }
    }
    for (const std::uint32_t part : is_self ? std::span<const std::uint32_t>() : parts_) {
      for (const std::uint32_t unbounded : other.unbounded_) {
        if (!visit(part, unbounded)) return false;
      }
    }
    if (parts_.empty() || other.parts_.empty()) return true;
    return visit_pairs_below<is_self>(root(), other, other.root(), may_touch, visit);
  }

  const Aabb<N, T>& box_at(const Place& place) const { return boxes_[first_of_level_[place.level] + place.index]; }
  std::size_t size_of_level(std::size_t level) const { return first_of_level_[level + 1] - first_of_level_[level]; }

  Place root() const { return {0, static_cast<std::uint32_t>(height_)}; }

  /// Descends in the tree that is higher at its place, so that boxes of about one size meet.
  template <bool is_self, class MayTouch, class Visit>
  bool visit_pairs_below(const Place& place, const PartTree& other, const Place& place_of_other,
                         const MayTouch& may_touch, const Visit& visit) const {
    const bool is_same = is_self && place == place_of_other;
    if (!is_same && !may_touch(box_at(place), other.box_at(place_of_other))) return true;
    if (place.level == 0 && place_of_other.level == 0) {
      return is_same || visit(parts_[place.index], other.parts_[place_of_other.index]);
    }
    const bool goes_down_here = place.level >= place_of_other.level;
    const std::uint32_t end = goes_down_here ? end_of_children(place) : other.end_of_children(place_of_other);
    for (std::uint32_t i = (goes_down_here ? place : place_of_other).index * width; i < end; ++i) {
      const Place child{i, (goes_down_here ? place : place_of_other).level - 1};
      if (is_same) {
        for (std::uint32_t j = i; j < end; ++j) {
          if (!visit_pairs_below<is_self>(child, other, {j, child.level}, may_touch, visit)) return false;
        }
      } else if (!visit_pairs_below<is_self>(goes_down_here ? child : place, other,
                                             goes_down_here ? place_of_other : child, may_touch, visit)) {
        return false;
      }
    }
    return true;
  }

  std::uint32_t end_of_children(const Place& parent) const {
    return static_cast<std::uint32_t>(
        std::min<std::size_t>((parent.index + std::size_t{1}) * width, size_of_level(parent.level - 1)));
  }

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
    const std::uint32_t end = end_of_children(parent);
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

  void set_boxes(std::span<const Aabb<N, T>> boxes) {
    boxes_.clear();
    height_ = 0;
    for (const std::uint32_t part : parts_) boxes_.push_back(boxes[part]);
    add_levels();
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
  double size_when_built_ = 0;
};

}  // namespace graze::detail
