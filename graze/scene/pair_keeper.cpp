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
  is_changed_.resize(room, false);
  boxes_.resize(room, Aabb<N, T>::nothing());
  filters_.resize(room);
  kinds_.resize(room);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_new(std::uint32_t slot, const Object<N, T>& object) noexcept {
  set_filter(slot, filter_of(object));
  note_moved(slot, object);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
  const bool is_box = std::holds_alternative<Aabb<N, T>>(object.shape);
  set(slot, touching_bounds(object.box), {is_box || !is_nothing(object.box), is_box});
}

template <Dim N, class T>
void PairKeeper<N, T>::note_gone(std::uint32_t slot) noexcept {
  set_filter(slot, {});
  set(slot, Aabb<N, T>::nothing(), {});
}

template <Dim N, class T>
void PairKeeper<N, T>::set_filter(std::uint32_t slot, const PairFilter& filter) noexcept {
  choosy_ += filter.admits_all() ? 0 : 1;
  choosy_ -= filters_[slot].admits_all() ? 0 : 1;
  filters_[slot] = filter;
}

template <Dim N, class T>
void PairKeeper<N, T>::set(std::uint32_t slot, const Aabb<N, T>& box, Kind kind) noexcept {
  for (Dim i = 0; i < N; ++i) {
    largest_ = std::max({largest_, finite_magnitude(box.min[i]), finite_magnitude(box.max[i])});
  }
  boxes_[slot] = box;
  live_ += kind.is_live ? 1 : 0;
  live_ -= kinds_[slot].is_live ? 1 : 0;
  kinds_[slot] = kind;
  if (is_changed_[slot]) return;
  is_changed_[slot] = true;
  changed_.push_back(slot);
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

template <Dim N, class T>
void PairKeeper<N, T>::find_around_changed(const SlotIndex<N, T>& index, const Executor& executor) {
  std::vector<std::vector<Pair>> found((changed_.size() + slots_in_task - 1) / slots_in_task);
  in_blocks(changed_.size(), executor, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t slot = changed_[i];
      if (!kinds_[slot].is_live) continue;
      index.tree().query(boxes_[slot], [&](const Key& key) {
        const std::uint32_t other = index.slot_of(key);
        const bool is_seen_from_there = is_changed_[other] && other < slot;
        const Pair pair{std::min(slot, other), std::max(slot, other)};
        if (other != slot && !is_seen_from_there && is_admitted(pair)) found[first / slots_in_task].push_back(pair);
      });
    }
  });
  found_.clear();
  for (const std::vector<Pair>& part : found) found_.insert(found_.end(), part.begin(), part.end());
  std::sort(found_.begin(), found_.end());
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
      const auto [a, b] = found_[i];
      const bool are_boxes = kinds_[a].is_box && kinds_[b].is_box;
      is_kept[i] = are_boxes && overlap_by(boxes_[a], boxes_[b], depth) ? 1 : 0;
      places[open] = i;
      open += is_kept[i] ? 0 : 1;
    }
    for (std::size_t k = 0; k < open; ++k) {
      const auto [a, b] = found_[places[k]];
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
const std::vector<Pair>& PairKeeper<N, T>::update(const Slots& slots, const ObjectIndex<N, T>& index,
                                                  const Executor& executor, PairPlan plan) {
  if (changed_.empty()) return touching_;
  if (plan == PairPlan::automatic) {
    plan = changed_.size() * mended_share < live_ ? PairPlan::mend : PairPlan::anew;
  }
  if (plan == PairPlan::mend) {
    find_around_changed(index.over(slots), executor);
  } else {
    find_anew(slots.size(), executor);
  }
  keep_touching(slots, executor);
  if (have_all_changed()) {
    std::swap(touching_, found_);
  } else {
    merge_with_unchanged();
    std::swap(touching_, merged_);
  }
  for (const std::uint32_t slot : changed_) is_changed_[slot] = false;
  changed_.clear();
  return touching_;
}

template class PairKeeper<2, float>;
template class PairKeeper<3, float>;
template class PairKeeper<2, double>;
template class PairKeeper<3, double>;

}  // namespace graze::detail
