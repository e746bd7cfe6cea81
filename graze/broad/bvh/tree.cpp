// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/bvh/build_kernels.hpp>
#include <graze/broad/bvh/bvh_kernels.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {
namespace {

/// Reserves space for one more; doubles the capacity if there is none.
template <class Value>
void reserve_one_more(std::vector<Value>& values) {
  if (values.size() == values.capacity()) values.reserve(2 * values.size() + 1);
}

/// The generation of these slots if all have the same, as they usually do after a bulk insertion.
std::optional<std::uint32_t> same_generation(std::span<const std::uint32_t> slots,
                                             std::span<const std::uint32_t> generations) {
  if (generations.empty()) return std::nullopt;
  const std::uint32_t first = generations[slots[0]];
  std::uint32_t others = 0;
  if (are_in_a_row(slots)) {
    for (const std::uint32_t generation : generations.subspan(slots[0], slots.size())) others |= generation ^ first;
  } else {
    for (const std::uint32_t slot : slots) others |= generations[slot] ^ first;
  }
  return others == 0 ? std::optional(first) : std::nullopt;
}

}  // namespace

template <Dim N, class T>
void require_boxes(std::span<const Aabb<N, T>> boxes) {
  std::size_t k = 0;
  while ((k += build_kernels<N, T>().finite(boxes.data() + k, boxes.size() - k)) < boxes.size()) {
    require_box(boxes[k]);
    ++k;
  }
}

template void require_boxes(std::span<const Aabb<2, float>>);
template void require_boxes(std::span<const Aabb<3, float>>);
template void require_boxes(std::span<const Aabb<2, double>>);
template void require_boxes(std::span<const Aabb<3, double>>);

template <Dim N, class T>
BvhTree<N, T>::BvhTree(double margin) : margin_(margin) {
  if (!(margin >= 0) || std::isinf(margin)) {
    throw std::invalid_argument("Bvh: margin is " + std::to_string(margin) + "; it must be finite and not negative");
  }
}

template <Dim N, class T>
void BvhTree<N, T>::insert(std::uint32_t slot, const Box& box, std::uint32_t generation) {
  note_leaf_nodes();
  if (slot >= boxes_.size()) {
    leaf_nodes_.resize(slot + std::size_t{1});
    boxes_.resize(slot + std::size_t{1});
  }
  if (!is_valid(box)) {
    infinite_.push_back({slot, generation});
    boxes_[slot] = box;
    leaf_nodes_[slot] = static_cast<std::uint32_t>(infinite_.size() - 1);
    return;
  }
  require_nodes();
  boxes_[slot] = box;
  attach({box, slot, generation});
}

template <Dim N, class T>
void BvhTree<N, T>::update(std::uint32_t slot, const Box& box) {
  note_leaf_nodes();
  if (!is_valid(box) || !is_valid(boxes_[slot])) {
    require_nodes();
    reserve_one_more(infinite_);
    const std::uint32_t generation =
        is_valid(boxes_[slot]) ? detach(slot).generation : remove_from_list(slot).generation;
    insert(slot, box, generation);
    return;
  }
  require_nodes();
  boxes_[slot] = box;
  if (shift(slot, box)) return;
  attach({box, slot, detach(slot).generation});
}

template <Dim N, class T>
void BvhTree<N, T>::erase(std::uint32_t slot) noexcept {
  note_leaf_nodes();
  if (is_valid(boxes_[slot])) {
    detach(slot);
  } else {
    remove_from_list(slot);
  }
}

template <Dim N, class T>
void BvhTree<N, T>::clear() noexcept {
  clear_tree();
  infinite_.clear();
}

template <Dim N, class T>
void BvhTree<N, T>::fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots, const Executor& executor,
                         std::span<const std::uint32_t> generations) {
  const bool in_a_row = !slots.empty() && are_in_a_row(slots);
  const std::size_t slot_count = slots.empty() ? 0
                                 : in_a_row    ? slots.back() + std::size_t{1}
                                               : *std::max_element(slots.begin(), slots.end()) + std::size_t{1};
  boxes_.resize(slot_count);
  leaf_nodes_.resize(slot_count);
  if (in_a_row) {
    std::copy(boxes.begin(), boxes.end(), boxes_.begin() + static_cast<std::ptrdiff_t>(slots[0]));
  } else {
    for (std::size_t k = 0; k < boxes.size(); ++k) boxes_[slots[k]] = boxes[k];
  }
  PageVector<std::uint32_t> finite;
  if (build_kernels<N, T>().finite(boxes.data(), boxes.size()) < boxes.size()) {
    finite.reserve(boxes.size());
    for (const std::uint32_t slot : slots) {
      if (is_finite_box(boxes_[slot])) {
        finite.push_back(slot);
      } else {
        leaf_nodes_[slot] = static_cast<std::uint32_t>(infinite_.size());
        infinite_.push_back({slot, generations.empty() ? 0 : generations[slot]});
      }
    }
    slots = finite;
  }
  if (slots.empty()) return;
  const BvhPlan plan(slots.size());
  nodes_.resize(plan.nodes());
  places_.resize(plan.nodes());
  BvhArrays<N, T> arrays{boxes_.data(), nodes_.data(), places_.data(), generations};
  if (const std::optional<std::uint32_t> same = same_generation(slots, generations)) {
    arrays.generations = {};  // none needs a lookup when its leaf node is filled
    arrays.generation = *same;
  }
  build_bvh<N, T>(slots, margin_, plan, arrays, executor);
  unknown_leaf_nodes_ = static_cast<std::uint32_t>(plan.leaf_nodes());
  height_ = plan.height();
  const std::uint32_t top = plan.index(height_ - 1, 0);
  root_ = height_ == 1 ? BvhLink::leaf(top) : BvhLink::inner(top);
}

template <Dim N, class T>
std::size_t BvhTree<N, T>::boxes_below(BvhLink link) const {  // NOLINT(misc-no-recursion): no deeper than the tree
  if (link.is_leaf()) return count(link);
  std::size_t boxes = 0;
  for (std::uint32_t lane = 0; lane < count(link); ++lane) {
    boxes += boxes_below(BvhLink::of_code(node(link).entries[lane]));
  }
  return boxes;
}

template <Dim N, class T>
Aabb<N, T> BvhTree<N, T>::bounds() const {
  return bvh_kernels<N, T>().around(node(root_).boxes);
}

template <Dim N, class T>
std::size_t BvhTree<N, T>::bytes() const {
  return nodes_.capacity() * sizeof(Node) + places_.capacity() * sizeof(BvhPlace) + boxes_.capacity() * sizeof(Box) +
         infinite_.capacity() * sizeof(BvhName) + (spare_.capacity() + leaf_nodes_.capacity()) * sizeof(std::uint32_t);
}

template <Dim N, class T>
BvhName BvhTree<N, T>::remove_from_list(std::uint32_t slot) noexcept {
  const BvhName last = infinite_.back();
  const BvhName removed = std::exchange(infinite_[leaf_nodes_[slot]], last);
  leaf_nodes_[last.slot] = leaf_nodes_[slot];
  infinite_.pop_back();
  return removed;
}

// ---- Nodes

/// Records the leaf node of every box whose node was built in bulk and has not changed since.
template <Dim N, class T>
void BvhTree<N, T>::note_leaf_nodes() noexcept {
  for (std::uint32_t node = 0; node < unknown_leaf_nodes_; ++node) {
    for (std::uint32_t lane = 0; lane < places_[node].count; ++lane) leaf_nodes_[nodes_[node].entries[lane]] = node;
  }
  unknown_leaf_nodes_ = 0;
}

/// Ensures that enough spare nodes exist for one change: one per level and a new root. Also reserves space to return
/// every node.
template <Dim N, class T>
void BvhTree<N, T>::require_nodes() {
  const std::size_t wanted = height_ + 1;
  if (spare_.size() + (nodes_.capacity() - nodes_.size()) < wanted) nodes_.reserve(2 * nodes_.size() + wanted);
  places_.reserve(nodes_.capacity());
  spare_.reserve(nodes_.capacity());
}

/// Takes a spare node.
template <Dim N, class T>
std::uint32_t BvhTree<N, T>::take_node() noexcept {
  if (spare_.empty()) {
    nodes_.emplace_back();
    places_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t index = spare_.back();
  spare_.pop_back();
  return index;
}

template <Dim N, class T>
void BvhTree<N, T>::release_node(std::uint32_t index) noexcept {
  spare_.push_back(index);
}

template <Dim N, class T>
std::uint32_t BvhTree<N, T>::lane_of(std::uint32_t node, std::uint32_t entry) const {
  const std::uint32_t* const entries = nodes_[node].entries;
  return static_cast<std::uint32_t>(std::find(entries, entries + block_size, entry) - entries);
}

/// Writes an entry into a lane of a node, and records the node in the entry.
template <Dim N, class T>
void BvhTree<N, T>::put(BvhLink link, std::uint32_t lane, const BvhEntry<N, T>& entry) noexcept {
  put_entry(nodes_[link.index()], lane, entry);
  if (link.is_leaf()) {
    leaf_nodes_[entry.entry] = link.index();
  } else {
    places_[BvhLink::of_code(entry.entry).index()].parent = link.index();
  }
}

template <Dim N, class T>
void BvhTree<N, T>::fill_node(BvhLink link, std::span<const BvhEntry<N, T>> entries) noexcept {
  const auto count = static_cast<std::uint32_t>(entries.size());
  for (std::uint32_t lane = 0; lane < count; ++lane) put(link, lane, entries[lane]);
  clear_lanes(nodes_[link.index()], count);
  places_[link.index()].count = count;
}

/// Removes an entry by moving the last one to its lane.
template <Dim N, class T>
void BvhTree<N, T>::remove_lane(std::uint32_t node, std::uint32_t lane) noexcept {
  Node& from = nodes_[node];
  const std::uint32_t last = --places_[node].count;
  put_entry(from, lane, entry_in(from, last));
  clear_lane(from, last);
}

/// The bounds of a node as stored in its parent.
template <Dim N, class T>
Aabb<N, T> BvhTree<N, T>::bounds_of(BvhLink link) const {
  const Box around = bvh_kernels<N, T>().around(node(link).boxes);
  return link.is_leaf() ? grown_by(around, margin_) : around;
}

/// Makes a node with one entry the root.
template <Dim N, class T>
void BvhTree<N, T>::plant(BvhLink link, const BvhEntry<N, T>& first) noexcept {
  root_ = link;
  ++height_;
  places_[root_.index()].parent = no_box;
  fill_node(root_, {&first, 1});
}

// ---- Changes

/// Inserts a box into the leaf node whose bounds grow least.
template <Dim N, class T>
void BvhTree<N, T>::attach(const BvhEntry<N, T>& leaf) noexcept {
  if (root_.is_none()) return plant(BvhLink::leaf(take_node()), leaf);
  const BvhKernels<N, T>& kernels = bvh_kernels<N, T>();
  const Box grown = grown_by(leaf.box, margin_);
  BvhLink link = root_;
  while (!link.is_leaf()) {
    Node& node = nodes_[link.index()];
    const std::uint32_t lane = kernels.least_grown(node.boxes, leaf.box);
    const Box bounds = box_in(node.boxes, lane);
    put_box(node.boxes, lane, box_around(bounds, grown));
    link = BvhLink::of_code(node.entries[lane]);
  }
  add(link, leaf);
}

/// Adds an entry to a node. Splits the node if it is full, and so on upwards. The bounds above already contain the
/// entry.
template <Dim N, class T>
void BvhTree<N, T>::add(BvhLink link, BvhEntry<N, T> entry) noexcept {
  const bool is_split = count(link) == block_size;
  while (count(link) == block_size) {
    BvhEntries<N, T> entries;
    entries.add(nodes_[link.index()], block_size);
    entries.add(entry);
    const std::uint32_t first = split_entries(entries);
    const std::uint32_t fresh = take_node();
    const BvhLink second = link.is_leaf() ? BvhLink::leaf(fresh) : BvhLink::inner(fresh);
    fill_node(link, {entries.all.data(), first});
    fill_node(second, {entries.all.data() + first, entries.count - first});
    const BvhEntry<N, T> low{bounds_of(link), link.code()};
    entry = {bounds_of(second), second.code()};
    if (link == root_) {
      plant(BvhLink::inner(take_node()), low);
      link = root_;
    } else {
      const BvhLink above = parent_link(link);
      put(above, lane_of(above.index(), link.code()), low);
      link = above;
    }
  }
  put(link, places_[link.index()].count++, entry);
  if (is_split) tighten_above(link);  // the margin now surrounds two nodes
}

/// Removes a box from the tree.
template <Dim N, class T>
BvhEntry<N, T> BvhTree<N, T>::detach(std::uint32_t slot) noexcept {
  const std::uint32_t node = leaf_nodes_[slot];
  const std::uint32_t lane = lane_of(node, slot);
  const BvhEntry<N, T> entry = entry_in(nodes_[node], lane);
  remove_lane(node, lane);
  mend(BvhLink::leaf(node));
  return entry;
}

/// After removal from a node: merges it with a sibling if it has too few entries, and so on upwards.
template <Dim N, class T>
void BvhTree<N, T>::mend(BvhLink link) noexcept {
  while (link != root_ && count(link) < bvh_least) {
    const BvhLink above = parent_link(link);
    if (!join(link)) return tighten_above(above);
    link = above;
  }
  if (link != root_) return tighten_above(link);
  if (count(root_) == 0) return clear_tree();
  while (!root_.is_leaf() && count(root_) == 1) {
    const std::uint32_t old = root_.index();
    root_ = BvhLink::of_code(nodes_[old].entries[0]);
    places_[root_.index()].parent = no_box;
    release_node(old);
    --height_;
  }
}

/// Moves the entries of a node to the sibling that grows least, or redistributes both if they are too many for one.
/// Returns whether the node was removed.
template <Dim N, class T>
bool BvhTree<N, T>::join(BvhLink link) noexcept {
  const BvhLink above = parent_link(link);
  Node& parent = nodes_[above.index()];
  const std::uint32_t lane = lane_of(above.index(), link.code());
  Block<N, T> others = parent.boxes;
  put_box(others, lane, no_box_in<N, T>());
  const std::uint32_t other_lane = bvh_kernels<N, T>().least_grown(others, bounds_of(link));
  const BvhLink other = BvhLink::of_code(parent.entries[other_lane]);
  BvhEntries<N, T> entries;
  entries.add(node(link), count(link));
  entries.add(node(other), count(other));
  const bool fit_in_one = entries.count <= block_size;
  const std::uint32_t first = fit_in_one ? entries.count : split_entries(entries);
  fill_node(other, {entries.all.data(), first});
  put_box(parent.boxes, other_lane, bounds_of(other));
  if (fit_in_one) {
    release_node(link.index());
    remove_lane(above.index(), lane);
  } else {
    fill_node(link, {entries.all.data() + first, entries.count - first});
    put_box(parent.boxes, lane, bounds_of(link));
  }
  return fit_in_one;
}

/// Keeps a moved box in its node if the node's bounds contain it or no sibling would grow less. Returns whether it did.
template <Dim N, class T>
bool BvhTree<N, T>::shift(std::uint32_t slot, const Box& box) noexcept {
  const BvhLink link = BvhLink::leaf(leaf_nodes_[slot]);
  const std::uint32_t lane = lane_of(link.index(), slot);
  if (link != root_) {
    const BvhLink above = parent_link(link);
    const Block<N, T>& beside = node(above).boxes;
    const std::uint32_t here = lane_of(above.index(), link.code());
    if (!covers(box_in(beside, here), box) && bvh_kernels<N, T>().least_grown(beside, box) != here) return false;
  }
  put_box(nodes_[link.index()].boxes, lane, box);
  tighten_above(link);
  return true;
}

/// Whether bounds may remain for boxes of a leaf node with these bounds.
template <Dim N, class T>
bool BvhTree<N, T>::fit(const Box& bounds, const Box& around) const {
  if (margin_ == 0) return bounds == around;
  const double room = 4 * margin_;  // twice what a move by the margin leaves on the other side
  return covers(bounds, around) && covers(grown_by(around, room), bounds);
}

/// Recalculates the bounds of a node and those above it from their entries.
template <Dim N, class T>
void BvhTree<N, T>::tighten_above(BvhLink link) noexcept {
  while (link != root_) {
    const BvhLink above = parent_link(link);
    Block<N, T>& beside = nodes_[above.index()].boxes;
    const std::uint32_t lane = lane_of(above.index(), link.code());
    const Box present = box_in(beside, lane);
    const Box around = bvh_kernels<N, T>().around(node(link).boxes);
    if (link.is_leaf() ? fit(present, around) : present == around) return;
    put_box(beside, lane, link.is_leaf() ? grown_by(around, margin_) : around);
    link = above;
  }
}

/// Removes everything except the infinite boxes.
template <Dim N, class T>
void BvhTree<N, T>::clear_tree() noexcept {
  nodes_.clear();
  places_.clear();
  spare_.clear();
  unknown_leaf_nodes_ = 0;
  root_ = {};
  height_ = 0;
}

template class BvhTree<2, float>;
template class BvhTree<3, float>;
template class BvhTree<2, double>;
template class BvhTree<3, double>;

}  // namespace graze::detail
