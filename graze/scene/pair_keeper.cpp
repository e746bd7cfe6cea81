// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <graze/broad/touching_pairs.hpp>
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

/// Leaves those candidates that touch.
template <Dim N, class T>
void keep_touching(const SharedSlots<Object<N, T>>& slots, const Executor& executor, std::vector<Pair>& candidates) {
  std::vector<Relation> relations(candidates.size());
  in_blocks(candidates.size(), executor, [&](std::size_t first, std::size_t last) {
    std::array<ShapePair<N, T>, slots_in_task> shapes;
    for (std::size_t i = first; i < last; ++i) {
      shapes[i - first] = {&slots[candidates[i].a]->shape, &slots[candidates[i].b]->shape};
    }
    relations_of<N, T>({shapes.data(), last - first}, relations.data() + first);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (relations[i] != Relation::apart) candidates[kept++] = candidates[i];
  }
  candidates.resize(kept);
}

}  // namespace

template <Dim N, class T>
void PairKeeper<N, T>::reserve(std::size_t slots) {
  if (boxes_.size() >= slots) return;
  const std::size_t room = 2 * slots + 16;
  changed_.reserve(room);
  is_changed_.resize(room, false);
  boxes_.resize(room, Aabb<N, T>::nothing());
}

template <Dim N, class T>
void PairKeeper<N, T>::note(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
  if (!is_nothing(boxes_[slot])) --live_;
  if (!is_nothing(box)) ++live_;
  boxes_[slot] = touching_bounds(box);
  if (is_changed_[slot]) return;
  is_changed_[slot] = true;
  changed_.push_back(slot);
}

/// If the two may touch and one of them has changed.
template <Dim N, class T>
void PairKeeper<N, T>::offer(const Slots& slots, std::uint32_t a, std::uint32_t b,
                             std::vector<Pair>& candidates) const {
  const Pair pair{std::min(a, b), std::max(a, b)};
  if (has_changed(pair) && may_touch(*slots[a], *slots[b])) candidates.push_back(pair);
}

template <Dim N, class T>
std::vector<Pair> PairKeeper<N, T>::candidates_anew(const Slots& slots, const Executor& executor) {
  std::vector<Pair> candidates;
  const std::span<const Aabb<N, T>> boxes(boxes_.data(), slots.size());
  for (const Pair& pair : finder_.find(boxes, {.executor = &executor})) offer(slots, pair.a, pair.b, candidates);
  return candidates;
}

template <Dim N, class T>
std::vector<Pair> PairKeeper<N, T>::candidates_around_changed(const Slots& slots, const SlotIndex<N, T>& index,
                                                              const Executor& executor) const {
  std::vector<std::vector<Pair>> found((changed_.size() + slots_in_task - 1) / slots_in_task);
  in_blocks(changed_.size(), executor, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t slot = changed_[i];
      if (is_nothing(boxes_[slot])) continue;
      index.tree().query(boxes_[slot], [&](const Key& key) {
        const std::uint32_t other = index.slot_of(key);
        const bool is_seen_from_there = is_changed_[other] && other < slot;
        if (other != slot && !is_seen_from_there) offer(slots, slot, other, found[first / slots_in_task]);
      });
    }
  });
  std::vector<Pair> candidates;
  for (const std::vector<Pair>& part : found) candidates.insert(candidates.end(), part.begin(), part.end());
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

/// What was found of changed objects, and what is known of the others.
template <Dim N, class T>
std::vector<Pair> PairKeeper<N, T>::with_unchanged(const std::vector<Pair>& found) const {
  std::vector<Pair> all;
  all.reserve(found.size() + touching_.size());
  auto next = found.begin();
  for (const Pair& known : touching_) {
    if (has_changed(known)) continue;
    for (; next != found.end() && *next < known; ++next) all.push_back(*next);
    all.push_back(known);
  }
  all.insert(all.end(), next, found.end());
  return all;
}

template <Dim N, class T>
const std::vector<Pair>& PairKeeper<N, T>::update(const Slots& slots, const ObjectIndex<N, T>& index,
                                                  const Executor& executor, PairPlan plan) {
  if (changed_.empty()) return touching_;
  if (plan == PairPlan::automatic) {
    plan = changed_.size() * mended_share < live_ ? PairPlan::mend : PairPlan::anew;
  }
  std::vector<Pair> found = plan == PairPlan::mend ? candidates_around_changed(slots, index.over(slots), executor)
                                                   : candidates_anew(slots, executor);
  keep_touching(slots, executor, found);
  touching_ = with_unchanged(found);
  for (const std::uint32_t slot : changed_) is_changed_[slot] = false;
  changed_.clear();
  return touching_;
}

template class PairKeeper<2, float>;
template class PairKeeper<3, float>;
template class PairKeeper<2, double>;
template class PairKeeper<3, double>;

}  // namespace graze::detail
