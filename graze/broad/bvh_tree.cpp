// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_tree.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {
namespace {

constexpr std::uint32_t root_place = 0;
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// Makes room for one more, and for as many again when there is none.
template <class Value>
void reserve_one_more(std::vector<Value>& values) {
  if (values.size() == values.capacity()) values.reserve(2 * values.size() + 1);
}

template <Dim N, class T>
double distance_of_centers(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  double sum = 0;
  for (Dim i = 0; i < N; ++i) {
    const double twice = (static_cast<double>(a.min[i]) - static_cast<double>(b.min[i])) +
                         (static_cast<double>(a.max[i]) - static_cast<double>(b.max[i]));
    sum += std::fabs(twice);
  }
  return sum;
}

/// What hanging a box somewhere below this child adds at least: a node around child and box, or only the growth of the
/// child, which a smaller node below may lessen.
template <Dim N, class T>
double least_cost(const Aabb<N, T>& bounds, BvhChild child, const Aabb<N, T>& box) {
  const double around = surface_of(box_around(bounds, box));
  if (child.is_leaf()) return around;
  return around + std::min(surface_of(box) - surface_of(bounds), 0.0);
}

}  // namespace

template <Dim N, class T>
BvhTree<N, T>::BvhTree(double margin) : margin_(margin), nodes_(1) {
  if (!(margin >= 0) || std::isinf(margin)) {
    throw std::invalid_argument("Bvh: a margin of " + std::to_string(margin) +
                                " is not a length; it must be finite, 0 or more");
  }
}

template <Dim N, class T>
void BvhTree<N, T>::insert(std::uint32_t slot, const Box& box) {
  if (slot >= boxes_.size()) {
    boxes_.resize(slot + std::size_t{1});
    places_.resize(slot + std::size_t{1});
  }
  if (is_valid(box)) {
    prepare_node();
    boxes_[slot] = box;
    attach(slot, grown(box), root_place);
    count_change();
  } else {
    infinite_.push_back(slot);
    boxes_[slot] = box;
    places_[slot] = static_cast<std::uint32_t>(infinite_.size() - 1);
  }
}

template <Dim N, class T>
void BvhTree<N, T>::update(std::uint32_t slot, const Box& box) {
  if (!is_valid(box) || !is_valid(boxes_[slot])) {
    if (is_valid(box)) {
      prepare_node();
    } else {
      reserve_one_more(infinite_);
    }
    erase(slot);
    insert(slot, box);
    return;
  }
  boxes_[slot] = box;
  if (stays(slot, box)) return;
  const Box fat = grown(box);
  if (settles(places_[slot], fat)) {
    nodes_[places_[slot] / 2].boxes[places_[slot] % 2] = fat;
    return tighten_above(places_[slot]);
  }
  const std::uint32_t top = detach(slot, &fat);
  attach(slot, fat, top);
  tighten_above(top);
  count_change();
}

template <Dim N, class T>
void BvhTree<N, T>::erase(std::uint32_t slot) noexcept {
  if (is_valid(boxes_[slot])) {
    detach(slot, nullptr);
  } else {
    remove_from_list(slot);
  }
}

template <Dim N, class T>
void BvhTree<N, T>::clear() noexcept {
  nodes_.resize(1);
  nodes_[0] = {};
  spare_.clear();
  infinite_.clear();
}

template <Dim N, class T>
void BvhTree<N, T>::fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots, const Executor& executor) {
  const std::size_t slot_count = slots.empty() ? 0 : *std::max_element(slots.begin(), slots.end()) + std::size_t{1};
  boxes_.resize(slot_count);
  places_.resize(slot_count);
  std::vector<BvhLeaf<N, T>> leaves;
  leaves.reserve(boxes.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    boxes_[slots[k]] = boxes[k];
    if (is_valid(boxes[k])) {
      leaves.push_back({grown(boxes[k]), slots[k]});
    } else {
      places_[slots[k]] = static_cast<std::uint32_t>(infinite_.size());
      infinite_.push_back(slots[k]);
    }
  }
  if (leaves.empty()) return;
  nodes_.resize(leaves.size());
  std::vector<std::uint32_t> indices(leaves.size() - 1);
  std::iota(indices.begin(), indices.end(), std::uint32_t{1});
  BvhBuilder<N, T>(nodes_.data(), indices, places_.data(), executor).build(leaves, root_place);
}

template <Dim N, class T>
std::size_t BvhTree<N, T>::bytes() const {
  return nodes_.capacity() * sizeof(Node) + boxes_.capacity() * sizeof(Box) +
         leaves_.capacity() * sizeof(BvhLeaf<N, T>) +
         (spare_.capacity() + places_.capacity() + infinite_.capacity() + indices_.capacity()) * sizeof(std::uint32_t);
}

// ---- Leaves

/// The box and the margin around it, as far as there are finite numbers.
template <Dim N, class T>
Aabb<N, T> BvhTree<N, T>::grown(const Box& box) const {
  constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
  Box fat = box;
  for (Dim i = 0; i < N; ++i) {
    fat.min[i] = static_cast<T>(std::max(static_cast<double>(box.min[i]) - margin_, -most));
    fat.max[i] = static_cast<T>(std::min(static_cast<double>(box.max[i]) + margin_, most));
  }
  return fat;
}

/// Whether a leaf may stay as it is, now that its box is this one: it contains the box, and is not much larger.
template <Dim N, class T>
bool BvhTree<N, T>::stays(std::uint32_t slot, const Box& box) const {
  const Box& leaf = bounds(places_[slot]);
  if (!covers(leaf, box)) return false;
  const double room = 4 * margin_;  // twice what a move by the margin leaves on the other side
  for (Dim i = 0; i < N; ++i) {
    if (static_cast<double>(box.min[i]) - static_cast<double>(leaf.min[i]) > room) return false;
    if (static_cast<double>(leaf.max[i]) - static_cast<double>(box.max[i]) > room) return false;
  }
  return true;
}

/// Whether a leaf may keep its place with this box, because a small group around it contains the box: what is lost so
/// costs a query no more than a look at each of the group.
template <Dim N, class T>
bool BvhTree<N, T>::settles(std::uint32_t place, const Box& box) const {
  constexpr std::uint32_t small_group = 16;
  while (place != root_place && nodes_[place / 2].count <= small_group) {
    place = nodes_[place / 2].place;
    if (covers(bounds(place), box)) return true;
  }
  return false;
}

/// A node that is not in the tree, in front of the others; sees to it that all may be there.
template <Dim N, class T>
std::uint32_t BvhTree<N, T>::prepare_node() {
  if (spare_.empty()) {
    reserve_one_more(nodes_);
    spare_.reserve(nodes_.capacity());
    spare_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.emplace_back();
  }
  return spare_.back();
}

template <Dim N, class T>
void BvhTree<N, T>::hang(std::uint32_t place, BvhChild child) {
  nodes_[place / 2].children[place % 2] = child;
  (child.is_leaf() ? places_[child.index()] : nodes_[child.index()].place) = place;
}

/// Where a box adds less surface; between equals where the center is nearer, between those where there are fewer. Sides
/// so long that costs are no numbers are equal.
template <Dim N, class T>
std::uint32_t BvhTree<N, T>::better_side(const Node& node, const Box& box) const {
  const double first = least_cost(node.boxes[0], node.children[0], box);
  const double second = least_cost(node.boxes[1], node.children[1], box);
  if (first < second) return 0;
  if (second < first) return 1;
  const double to_first = distance_of_centers(node.boxes[0], box);
  const double to_second = distance_of_centers(node.boxes[1], box);
  if (to_first < to_second) return 0;
  if (to_second < to_first) return 1;
  return count(node.children[0]) <= count(node.children[1]) ? 0 : 1;
}

/// Whether a node around a node in a place and a new box costs less than going on below it.
template <Dim N, class T>
bool BvhTree<N, T>::stops_at(const Node& node, std::uint32_t place, const Box& box) const {
  const double around = surface_of(box_around(bounds(place), box));
  const double growth = around - surface_of(bounds(place));
  return around <= growth + least_cost(node.boxes[0], node.children[0], box) &&
         around <= growth + least_cost(node.boxes[1], node.children[1], box);
}

/// Hangs a new leaf in a place or below, in a node that is prepared. Bounds and counts grow on the way down, while the
/// nodes are at hand.
template <Dim N, class T>
void BvhTree<N, T>::attach(std::uint32_t slot, const Box& box, std::uint32_t place) {
  const BvhChild leaf = BvhChild::leaf(slot);
  if (child(place).is_none()) {
    nodes_[place / 2].boxes[place % 2] = box;
    return hang(place, leaf);
  }
  std::uint32_t broken = nowhere;
  std::uint32_t whole = 0;  // of the leaves of the node above, with the new one
  while (true) {
    const BvhChild present = child(place);
    const std::uint32_t part = count(present) + 1;
    // The other side too: of 12 leaves it may hold 11, of 13 it may not.
    const bool breaks = whole > 0 && is_out_of_balance(std::max(part, whole - part), whole);
    if (broken == nowhere && breaks) broken = nodes_[place / 2].place;
    if (present.is_leaf()) break;
    Node& node = nodes_[present.index()];
    if (!is_out_of_balance(part - 1, part) && stops_at(node, place, box)) break;
    grow_at_once(nodes_[place / 2].boxes[place % 2], box);
    node.count = whole = part;
    place = 2 * present.index() + better_side(node, box);
  }
  const std::uint32_t index = prepare_node();
  spare_.pop_back();
  Node& node = nodes_[index];
  const BvhChild sibling = child(place);
  Box& bounds = nodes_[place / 2].boxes[place % 2];
  node.boxes = {bounds, box};
  node.count = count(sibling) + 1;
  grow_at_once(bounds, box);
  hang(place, BvhChild::node(index));
  hang(2 * index, sibling);
  hang(2 * index + 1, leaf);
  if (broken != nowhere) rebuild(broken);
}

/// Takes a leaf and the node above it out of the tree. The bounds above shrink up to the first that contain the target
/// even so, whose place is returned; the counts of what is above that place still have the leaf.
template <Dim N, class T>
std::uint32_t BvhTree<N, T>::detach(std::uint32_t slot, const Box* target) noexcept {
  const std::uint32_t leaf_place = places_[slot];
  if (leaf_place == root_place) {
    nodes_.resize(1);
    nodes_[0] = {};
    spare_.clear();
    return root_place;
  }
  const std::uint32_t index = leaf_place / 2;
  const std::uint32_t sibling_place = leaf_place ^ 1U;
  std::uint32_t place = nodes_[index].place;
  nodes_[place / 2].boxes[place % 2] = bounds(sibling_place);
  hang(place, child(sibling_place));
  spare_.push_back(index);
  std::uint32_t broken = nowhere;
  std::uint32_t part = count(child(place));
  while (place != root_place && !(target != nullptr && covers(bounds(place), *target))) {
    Node& node = nodes_[place / 2];
    --node.count;
    if (is_out_of_balance(node.count - part, node.count)) broken = node.place;
    part = node.count;
    place = node.place;
    nodes_[place / 2].boxes[place % 2] = box_around(node.boxes[0], node.boxes[1]);
  }
  if (broken != nowhere) rebuild(broken);
  return place;
}

/// Shrinks what is above a place whose bounds have changed.
template <Dim N, class T>
void BvhTree<N, T>::tighten_above(std::uint32_t place) {
  while (place != root_place) {
    const Node& node = nodes_[place / 2];
    place = node.place;
    const Box tight = box_around(node.boxes[0], node.boxes[1]);
    if (bounds(place) == tight) return;
    nodes_[place / 2].boxes[place % 2] = tight;
  }
}

template <Dim N, class T>
void BvhTree<N, T>::remove_from_list(std::uint32_t slot) noexcept {
  const std::uint32_t last = infinite_.back();
  infinite_[places_[slot]] = last;
  places_[last] = places_[slot];
  infinite_.pop_back();
}

// ---- Building anew

/// Neighbours drift apart in memory, which can make a query half as slow again: now and then they are brought together.
/// A change pays for four nodes.
template <Dim N, class T>
void BvhTree<N, T>::count_change() noexcept {
  if (++changes_ <= nodes_.size() / 4) return;
  changes_ = 0;
  renumber();
}

/// Gives nodes their numbers in the order in which a walk meets them that goes down first. Not where memory is lacking.
template <Dim N, class T>
void BvhTree<N, T>::renumber() noexcept {
  if (child(root_place).is_none() || child(root_place).is_leaf()) return;
  std::vector<Node> fresh;
  try {
    fresh.reserve(count(child(root_place)));
    indices_.reserve(bvh_path);
  } catch (const std::bad_alloc&) {
    return;
  }
  fresh.push_back(nodes_[0]);
  indices_.push_back(root_place);
  while (!indices_.empty()) {
    const std::uint32_t place = indices_.back();
    indices_.pop_back();
    BvhChild& child = fresh[place / 2].children[place % 2];
    Node& node = fresh.emplace_back(nodes_[child.index()]);
    node.place = place;
    const auto index = static_cast<std::uint32_t>(fresh.size() - 1);
    child = BvhChild::node(index);
    for (const std::uint32_t side : {1U, 0U}) {
      if (node.children[side].is_leaf()) {
        places_[node.children[side].index()] = 2 * index + side;
      } else {
        indices_.push_back(2 * index + side);
      }
    }
  }
  nodes_ = std::move(fresh);
  spare_.clear();
}

/// Where memory is lacking the tree below the place stays as it is until the next change.
template <Dim N, class T>
void BvhTree<N, T>::rebuild(std::uint32_t place) noexcept {
  if (child(place).is_none() || child(place).is_leaf()) return;
  try {
    gather(place);
  } catch (const std::bad_alloc&) {
    leaves_.clear();
    indices_.clear();
    return;
  }
  if (place == root_place) {
    nodes_.resize(leaves_.size());
    spare_.clear();
    std::iota(indices_.begin(), indices_.end(), std::uint32_t{1});
  } else {
    std::sort(indices_.begin(), indices_.end());
  }
  BvhBuilder<N, T>(nodes_.data(), indices_, places_.data(), serial_executor()).build(leaves_, place);
  leaves_.clear();
  indices_.clear();
  if (place == root_place) {  // comes seldom, and would hold room for all for ever
    leaves_.shrink_to_fit();
    indices_.shrink_to_fit();
  }
}

/// The leaves and the nodes below a place.
template <Dim N, class T>
void BvhTree<N, T>::gather(std::uint32_t place) {
  leaves_.reserve(count(child(place)));
  indices_.reserve(leaves_.capacity());
  indices_.push_back(child(place).index());
  for (std::size_t k = 0; k < indices_.size(); ++k) {
    const Node& node = nodes_[indices_[k]];
    for (std::size_t side = 0; side < 2; ++side) {
      const BvhChild child = node.children[side];
      if (child.is_leaf()) {
        leaves_.push_back({node.boxes[side], child.index()});
      } else {
        indices_.push_back(child.index());
      }
    }
  }
}

template class BvhTree<2, float>;
template class BvhTree<3, float>;
template class BvhTree<2, double>;
template class BvhTree<3, double>;

}  // namespace graze::detail
