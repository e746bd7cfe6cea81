// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <variant>

#include <graze/broad/touching_pairs.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/pair_keeper.hpp>

namespace graze::detail {
namespace {

/// With more than one object changed of so many, all boxes are met with each other: a question to the index costs far
/// more than a box does in the batch method.
constexpr std::size_t mended_share = 16;

/// Exact tests, and questions to the index, per task.
constexpr std::size_t slots_in_task = 1024;

/// Runs `work(first, last)` over blocks of 0 ... count.
template <class Work>
void in_blocks(std::size_t count, const Executor& executor, const Work& work) {
  executor.parallel_for((count + slots_in_task - 1) / slots_in_task, [&](std::size_t block) {
    work(block * slots_in_task, std::min(count, (block + 1) * slots_in_task));
  });
}

Pair ascending(const Pair& pair) { return {std::min(pair.a, pair.b), std::max(pair.a, pair.b)}; }

/// Whether two boxes overlap by more than `depth` along every axis.
template <Dim N, class T>
bool overlap_by(const Aabb<N, T>& a, const Aabb<N, T>& b, T depth) {
  bool is_deep = true;
  for (Dim i = 0; i < N; ++i) is_deep &= std::min(a.max[i], b.max[i]) - std::max(a.min[i], b.min[i]) > depth;
  return is_deep;
}

}  // namespace

template <Dim N, class T>
void PairKeeper<N, T>::reserve(std::size_t slots) {
  if (boxes_.size() >= slots) return;
  const std::size_t room = 2 * slots + 16;
  changed_.reserve(room);
  changes_.resize(room, Change::none);
  boxes_.resize(room, Aabb<N, T>::nothing());
  filters_.resize(room);
  kinds_.resize(room);
}

template <Dim N, class T>
auto PairKeeper<N, T>::kind_of(const Object<N, T>& object) -> Kind {
  const bool is_box = std::holds_alternative<Aabb<N, T>>(object.shape);
  return {is_box || !is_nothing(object.box), is_box};
}

template <Dim N, class T>
void PairKeeper<N, T>::note_new(std::uint32_t slot, const Object<N, T>& object) noexcept {
  set_filter(slot, filter_of(object));
  set(slot, object.box, kind_of(object), Change::replaced);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
  set(slot, object.box, kind_of(object), Change::moved);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_gone(std::uint32_t slot) noexcept {
  set_filter(slot, {});
  set(slot, Aabb<N, T>::nothing(), {}, Change::replaced);
}

template <Dim N, class T>
void PairKeeper<N, T>::set_filter(std::uint32_t slot, const PairFilter& filter) noexcept {
  choosy_ += filter.admits_all() ? 0 : 1;
  choosy_ -= filters_[slot].admits_all() ? 0 : 1;
  filters_[slot] = filter;
}

template <Dim N, class T>
void PairKeeper<N, T>::set(std::uint32_t slot, const Aabb<N, T>& box, Kind kind, Change change) noexcept {
  boxes_[slot] = box;
  largest_ = std::max(largest_, grow_for_touching(boxes_[slot]));
  live_ += kind.is_live ? 1 : 0;
  live_ -= kinds_[slot].is_live ? 1 : 0;
  kinds_[slot] = kind;
  if (!has_changed(slot)) changed_.push_back(slot);
  changes_[slot] = std::max(changes_[slot], change);
}

template <Dim N, class T>
bool PairKeeper<N, T>::have_all_changed() const {
  if (changed_.size() < live_) return false;
  const auto is_live = [this](std::uint32_t slot) { return kinds_[slot].is_live; };
  return static_cast<std::size_t>(std::count_if(changed_.begin(), changed_.end(), is_live)) == live_;
}

template <Dim N, class T>
void PairKeeper<N, T>::find_anew(std::size_t slots, const Executor& executor) {
  const std::span<const Pair> near = finder_.find({boxes_.data(), slots}, {.executor = &executor});
  const bool are_all_new = have_all_changed();
  found_.clear();
  if (are_all_new && choosy_ == 0) {
    found_.assign(near.begin(), near.end());
    return;
  }
  for (const Pair& pair : near) {
    if ((are_all_new || has_changed(pair)) && is_admitted(pair)) found_.push_back(pair);
  }
}

/// Each changed slot first, and those around it; grouped by that one, in the order of `changed_`.
template <Dim N, class T>
void PairKeeper<N, T>::find_around_changed(const SlotIndex<N, T>& index, const Executor& executor) {
  std::vector<std::vector<Pair>> found((changed_.size() + slots_in_task - 1) / slots_in_task);
  in_blocks(changed_.size(), executor, [&](std::size_t first, std::size_t last) {
    std::vector<Pair>& part = found[first / slots_in_task];
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t slot = changed_[i];
      index.prefetch_place(changed_[std::min(i + prefetch_distance / 2, last - 1)]);
      index.prefetch_node(changed_[std::min(i + prefetch_distance / 4, last - 1)]);
      if (!kinds_[slot].is_live) continue;
      index.query(boxes_[slot], [&](std::uint32_t other) {
        if (other == slot || is_seen_from_there(slot, other) || !is_admitted({slot, other})) return;
        prefetch(&boxes_[other]);
        part.push_back({slot, other});
      });
    }
  });
  found_.clear();
  for (const std::vector<Pair>& part : found) found_.insert(found_.end(), part.begin(), part.end());
}

/// Of boxes that overlap by more than they were grown by, and more than their sides are rounded, that is known.
template <Dim N, class T>
void PairKeeper<N, T>::keep_touching(const Slots& slots, const Executor& executor) {
  const double grown = 2 * (tolerance::box_slack + 4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
  const T depth = round_up<T>(grown * static_cast<double>(largest_));
  std::vector<char> is_kept(found_.size());
  in_blocks(found_.size(), executor, [&](std::size_t first, std::size_t last) {
    std::array<ShapePair<N, T>, slots_in_task> shapes;
    std::array<std::size_t, slots_in_task> places;
    std::array<Relation, slots_in_task> relations;
    std::size_t open = 0;
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t later = found_[std::min(i + prefetch_distance, last - 1)].b;
      prefetch(&boxes_[later]);
      prefetch(&kinds_[later]);
      const auto [a, b] = found_[i];
      const bool are_boxes = kinds_[a].is_box && kinds_[b].is_box;
      is_kept[i] = are_boxes && overlap_by(boxes_[a], boxes_[b], depth) ? 1 : 0;
      places[open] = i;
      open += is_kept[i] ? 0 : 1;
    }
    for (std::size_t k = 0; k < open; ++k) {
      const auto [a, b] = ascending(found_[places[k]]);
      shapes[k] = {&slots[a]->shape, &slots[b]->shape};
    }
    relations_of<N, T>({shapes.data(), open}, relations.data());
    for (std::size_t k = 0; k < open; ++k) is_kept[places[k]] = relations[k] != Relation::apart ? 1 : 0;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    found_[kept] = found_[i];
    kept += is_kept[i] ? 1 : 0;
  }
  found_.resize(kept);
}

/// Of what was found of changed objects, and what is known of the others.
template <Dim N, class T>
void PairKeeper<N, T>::merge_with_unchanged() {
  merged_.clear();
  merged_.reserve(found_.size() + touching_.size());
  auto next = found_.begin();
  for (const Pair& known : touching_) {
    if (has_changed(known)) continue;
    for (; next != found_.end() && *next < known; ++next) merged_.push_back(*next);
    merged_.push_back(known);
  }
  merged_.insert(merged_.end(), next, found_.end());
}

template <Dim N, class T>
void PairKeeper<N, T>::list_pairs() {
  if (is_listed_) return;
  graph_.list(touching_);
  is_listed_ = true;
}

template <Dim N, class T>
void PairKeeper<N, T>::link_pairs() {
  if (is_linked_) return;
  graph_.assign(touching_, boxes_.size());
  is_linked_ = true;
}

/// What has begun and ended among the pairs of what has changed. The slots known to touch one are marked with a number
/// of its own, the marks of those that still do taken away.
template <Dim N, class T>
void PairKeeper<N, T>::compare_with_known() {
  marks_.resize(boxes_.size(), 0);
  auto next = found_.begin();
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const std::uint32_t slot = changed_[i];
    graph_.prefetch_chain(changed_[std::min(i + prefetch_distance, changed_.size() - 1)]);
    graph_.prefetch_first(changed_[std::min(i + prefetch_distance / 2, changed_.size() - 1)]);
    if (++mark_ == 0) std::fill(marks_.begin(), marks_.end(), mark_++);
    graph_.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t /*edge*/) { marks_[other] = mark_; });
    for (; next != found_.end() && next->a == slot; ++next) {
      const bool is_known = marks_[next->b] == mark_ && !is_replaced(slot) && !is_replaced(next->b);
      if (!is_known) began_.push_back(ascending(*next));
      if (is_known) marks_[next->b] = 0;
    }
    graph_.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t edge) {
      if (marks_[other] != mark_ || is_seen_from_there(slot, other)) return;
      ended_.push_back(ascending({slot, other}));
      ended_edges_.push_back(edge);
    });
  }
  std::sort(began_.begin(), began_.end());
  std::sort(ended_.begin(), ended_.end());
  graph_.reserve(boxes_.size(), began_.size());
}

template <Dim N, class T>
PairPlan PairKeeper<N, T>::find(const Slots& slots, const ObjectIndex<N, T>& index, const Executor& executor,
                                PairPlan plan) {
  if (plan == PairPlan::automatic) {
    plan = changed_.size() * mended_share < live_ || changed_.empty() ? PairPlan::mend : PairPlan::anew;
  }
  plan_ = plan;
  if (plan == PairPlan::mend) {
    began_.clear();
    ended_.clear();
    ended_edges_.clear();
    if (changed_.empty()) return plan;
    link_pairs();
    find_around_changed(index.over(slots), executor);
    keep_touching(slots, executor);
    compare_with_known();
  } else {
    find_anew(slots.size(), executor);
    keep_touching(slots, executor);
    if (!have_all_changed()) {
      list_pairs();
      merge_with_unchanged();
      std::swap(found_, merged_);
    }
  }
  return plan;
}

template <Dim N, class T>
void PairKeeper<N, T>::commit() noexcept {
  if (plan_ == PairPlan::mend) {
    for (const std::uint32_t edge : ended_edges_) graph_.remove(edge);
    for (const Pair& pair : began_) graph_.add(pair);
    is_listed_ = is_listed_ && began_.empty() && ended_.empty();
  } else {
    std::swap(touching_, found_);
    is_listed_ = true;
    is_linked_ = false;
  }
  for (const std::uint32_t slot : changed_) changes_[slot] = Change::none;
  changed_.clear();
}

template class PairKeeper<2, float>;
template class PairKeeper<3, float>;
template class PairKeeper<2, double>;
template class PairKeeper<3, double>;

}  // namespace graze::detail
