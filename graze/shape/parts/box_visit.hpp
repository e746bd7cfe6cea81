// SPDX-License-Identifier: MIT
// BoxTree::visit: the way from the root of a tree to the parts that matter.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/may_matter.hpp>

namespace graze::detail {

/// Of level 0, a part; else a node, whose children are the boxes of one block.
struct PlaceInTree {
  std::uint32_t index;  ///< Within its level.
  std::uint32_t level;

  bool operator==(const PlaceInTree&) const = default;
};

inline constexpr std::size_t most_levels_of_tree = 9;  // of 2^32 boxes

/// A visit to a BoxTree, in one of the orders of may_matter.hpp.
template <class Tree, class MayMatter, class Order>
class BoxVisit;

template <Dim N, class T, class Leaves, template <Dim, class, class> class Tree, class MayMatter, class Order>
class BoxVisit<Tree<N, T, Leaves>, MayMatter, Order> {
 public:
  BoxVisit(const Tree<N, T, Leaves>& tree, const MayMatter& may_matter) : tree_(tree), may_matter_(may_matter) {}

  /// Visits what matters at a place and below.
  template <class Visit>
  [[gnu::always_inline]] void run(PlaceInTree place, const Visit& visit) {
    for (;;) {
      if (!is_visited(place)) {
        if (enter(place)) continue;
      } else if (!visit_at(place, visit)) {
        return;
      }
      if (!take(place)) return;
    }
  }

 private:
  using Contents = std::decay_t<decltype(std::declval<const Leaves&>().contents(0))>;

  static constexpr bool is_by_key = std::is_same_v<Order, ByKey>;
  /// Whether parts are tested themselves, sixteen at once, and not their boxes.
  static constexpr bool tests_contents =
      TestsContents<MayMatter, Contents> || (is_by_key && FindsKeysOfContents<MayMatter, Contents, T>);

  /// Whether the parts at a place are visited without asking for their boxes.
  static bool is_visited(const PlaceInTree& place) { return place.level == 0 || (place.level == 1 && tests_contents); }

  template <class Visit>
  [[gnu::always_inline]] bool visit_at(const PlaceInTree& place, const Visit& visit) const {
    if constexpr (tests_contents) {
      if (place.level == 1) return visit_contents(place, visit);
    }
    return visit(tree_.parts_[place.index], std::size_t{place.index});
  }

  /// Visits the parts of a node of level 1 that may matter, the one with the least key first.
  template <class Visit>
  [[gnu::always_inline]] bool visit_contents(const PlaceInTree& node, const Visit& visit) const {
    const Contents& contents = tree_.leaves_.contents(node.index);
    const LaneMask all = first_lanes(tree_.count_of_children(node));
    const std::size_t first_place = std::size_t{node.index} * row_length;
    if constexpr (TestsContents<MayMatter, Contents>) {
      return for_each_lane(all & may_matter_.lanes(contents), [&](std::uint32_t lane) {
        return visit(tree_.parts_[first_place + lane], first_place + lane);
      });
    } else {
      alignas(64) Row<T> keys;
      const LaneMask lanes = all & may_matter_.lanes(contents, keys);
      if (lanes == 0) return true;
      const auto visit_lane = [&](std::uint32_t lane) {
        const std::size_t place = first_place + lane;
        if constexpr (std::is_invocable_v<Visit, std::uint32_t, std::size_t, T>) {
          return visit(tree_.parts_[place], place, keys[lane]);
        } else {
          return visit(tree_.parts_[place], place);
        }
      };
      const std::uint32_t first = lane_of_least(lanes, keys);
      return visit_lane(first) && for_each_lane(lanes & ~(LaneMask{1} << first), [&](std::uint32_t lane) {
               return !may_matter_.admits(static_cast<double>(keys[lane])) || visit_lane(lane);
             });
    }
  }

  static std::uint32_t lane_of_least(LaneMask lanes, const Row<T>& keys) {
    auto least = static_cast<std::uint32_t>(std::countr_zero(lanes));
    for_each_lane(lanes & (lanes - 1), [&](std::uint32_t lane) {
      least = keys[lane] < keys[least] ? lane : least;
      return true;
    });
    return least;
  }

  /// The children that may matter, and their keys.
  [[gnu::always_inline]] LaneMask lanes_that_matter(const PlaceInTree& node, Row<T>& keys) const {
    const std::size_t count = tree_.count_of_children(node);
    BoxBlock<N, T> buffer;
    const BoxBlock<N, T>& block = tree_.block_of(node, buffer);
    if constexpr (is_by_key && FindsKeysOfLanes<MayMatter, N, T>) {
      return first_lanes(count) & may_matter_.lanes(block, keys);
    } else if constexpr (!is_by_key && TestsLanes<MayMatter, N, T>) {
      return first_lanes(count) & may_matter_.lanes(block);
    } else {
      return lanes_one_by_one(block, count, keys);
    }
  }

  LaneMask lanes_one_by_one(const BoxBlock<N, T>& block, std::size_t count, Row<T>& keys) const {
    LaneMask lanes = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
      bool matters = true;
      if constexpr (is_by_key) {
        const double key = may_matter_.key(block.box(lane));
        keys[lane] = lower_key(key);
        matters = may_matter_.admits(key);
      } else {
        matters = may_matter_(block.box(lane));
      }
      lanes |= (matters ? LaneMask{1} : LaneMask{0}) << lane;
    }
    return lanes;
  }

  /// A key in T that is not greater.
  static T lower_key(double key) {
    constexpr double most = std::numeric_limits<T>::max();
    return round_down<T>(key > most ? most : key);
  }

  /// Goes from a node to the first of its children that may matter; the others wait. False if there is none.
  [[gnu::always_inline]] bool enter(PlaceInTree& place) {
    const PlaceInTree node = place;
    const auto child = [&node](std::uint32_t lane) {
      return PlaceInTree{node.index * static_cast<std::uint32_t>(row_length) + lane, node.level - 1};
    };
    alignas(64) Row<T> keys;
    const LaneMask lanes = lanes_that_matter(node, keys);
    if (lanes == 0) return false;
    auto first = static_cast<std::uint32_t>(std::countr_zero(lanes));
    for_each_lane(lanes & (lanes - 1), [&](std::uint32_t lane) {
      std::uint32_t later = lane;
      if constexpr (is_by_key) {
        const bool is_nearer = keys[lane] < keys[first];
        later = is_nearer ? first : lane;
        first = is_nearer ? lane : first;
        waiting_keys_[count_] = keys[later];
      }
      waiting_[count_++] = child(later);
      return true;
    });
    place = child(first);
    return true;
  }

  /// Goes to the last of the waiting places that still matters. False if there is none.
  [[gnu::always_inline]] bool take(PlaceInTree& place) {
    while (count_ > 0) {
      place = waiting_[--count_];
      if constexpr (is_by_key) {
        if (!may_matter_.admits(static_cast<double>(waiting_keys_[count_]))) continue;
      }
      return true;
    }
    return false;
  }

  static constexpr std::size_t most_waiting =
      most_levels_of_tree * (row_length - 1) + 1;  // each step takes one and adds sixteen

  const Tree<N, T, Leaves>& tree_;
  const MayMatter& may_matter_;
  std::array<PlaceInTree, most_waiting> waiting_;
  std::array<T, most_waiting> waiting_keys_;
  std::size_t count_ = 0;
};

}  // namespace graze::detail
