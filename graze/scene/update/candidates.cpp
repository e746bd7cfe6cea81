// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/math/lanes/lanes.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/update/candidates.hpp>
#include <graze/scene/update/fat_boxes.hpp>

namespace graze::detail {
namespace {

/// When all fat boxes are recalculated, their margin is this multiple of the longest step of a box in a frame,
constexpr double steps_for_all = 2;
/// but zero if that exceeds this share of the mean side of a box, because there would be too many candidates.
constexpr double most_of_mean_side = 0.5;

/// When a graph is built and more than one in this many boxes have left their fat boxes, the others will follow one by
/// one: then the margin of all is this multiple of the median step of those boxes,
constexpr std::size_t least_share_of_strays = 256;
constexpr double steps_in_graph = 2;
/// but not if that exceeds this share of the mean side of a box.
constexpr double most_of_mean_side_in_graph = 0.25;

/// When a box has left its fat box, its next margin is this share of the previous one plus this multiple of the
/// distance by which the box has left it: for steps of equal length, about four steps in the long run.
constexpr double margin_kept = 0.75;
constexpr double margin_missed = 2;
/// At most this share of its longest side or of the mean side, whichever is longer; zero if a single step exceeds that.
constexpr double most_of_side = 0.5;

/// A list with a margin that was used fewer times than this was not worth it.
constexpr std::size_t least_uses = 2;
constexpr unsigned longest_pause = 64;

/// The number of boxes whose sides are measured; all if there are fewer.
constexpr std::size_t least_sample = 512;

/// Tree queries per task.
constexpr std::size_t questions_in_task = 1024;

/// How far a box extends beyond its fat box; negative if it is inside, with an exact sign. Infinite sides do not count.
template <Dim N, class T>
T excess_of(const Aabb<N, T>& box, const Aabb<N, T>& room) {
  T excess = std::numeric_limits<T>::lowest();
  for (Dim i = 0; i < N; ++i) {
    const T below = room.min[i] - box.min[i];
    const T above = box.max[i] - room.max[i];
    excess = below > excess ? below : excess;
    excess = above > excess ? above : excess;
  }
  return excess;
}

/// The largest excess of all boxes.
template <Dim N, class T>
T largest_excess(const Aabb<N, T>* boxes, const Aabb<N, T>* fat_boxes, std::size_t count) {
  T excess = std::numeric_limits<T>::lowest();
  for (std::size_t i = 0; i < count; ++i) excess = std::max(excess, excess_of(boxes[i], fat_boxes[i]));
  return excess;
}

#ifdef GRAZE_HAS_LANES

/// The same with four coordinates at a time; the arrays must have one more element.
float largest_excess(const Aabb<3, float>* boxes, const Aabb<3, float>* fat_boxes, std::size_t count) {
  Lanes below = Lanes{} + std::numeric_limits<float>::lowest();
  Lanes above = below;
  for (std::size_t i = 0; i < count; ++i) {
    below = larger(four_at(&fat_boxes[i].min.x) - four_at(&boxes[i].min.x), below);
    above = larger(four_at(&boxes[i].max.x) - four_at(&fat_boxes[i].max.x), above);
  }
  return largest_of_three(larger(below, above));  // the fourth lane has no meaning
}

float largest_excess(const Aabb<2, float>* boxes, const Aabb<2, float>* fat_boxes, std::size_t count) {
  Lanes below = Lanes{} + std::numeric_limits<float>::lowest();
  Lanes above = below;
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes difference =
        four_at(&fat_boxes[i].min.x) - four_at(&boxes[i].min.x);  // lanes 0, 1: below; lanes 2, 3: -above
    below = larger(difference, below);
    above = larger(-difference, above);
  }
  return std::max(std::max(below[0], below[1]), std::max(above[2], above[3]));
}

#endif

template <Dim N, class T>
T longest_side(const Aabb<N, T>& box) {
  T side = 0;
  for (Dim i = 0; i < N; ++i) side = std::max(side, box.max[i] - box.min[i]);
  return side;
}

}  // namespace

template <Dim N, class T>
Candidates<N, T>::Candidates(const Candidates& other)
    : boxes_(other.boxes_),
      fat_boxes_(other.fat_boxes_),
      margins_(other.margins_),
      filters_(other.filters_),
      choosy_(other.choosy_),
      largest_(other.largest_),
      mean_side_(other.mean_side_),
      form_(other.is_linked() ? Form::graph : Form::none),
      list_number_(other.list_number_),
      graph_(other.graph_),
      tree_(other.tree_),
      is_held_(other.is_held_),
      is_stray_(other.is_stray_) {
  strays_.reserve(is_stray_.size());
}

template <Dim N, class T>
Candidates<N, T>& Candidates<N, T>::operator=(const Candidates& other) {
  if (this != &other) *this = Candidates(other);
  return *this;
}

template <Dim N, class T>
void Candidates<N, T>::reserve(std::size_t slots) {
  strays_.reserve(slots);
  boxes_.resize(slots + 1, Box::nothing());
  fat_boxes_.resize(slots + 1, Box::nothing());
  margins_.resize(slots, T(0));
  filters_.resize(slots);
  is_held_.resize(slots, 0);
  is_stray_.resize(slots, 0);
}

template <Dim N, class T>
void Candidates<N, T>::set_filter(std::uint32_t slot, const PairFilter& filter) noexcept {
  choosy_ += filter.admits_all() ? 0 : 1;
  choosy_ -= filters_[slot].admits_all() ? 0 : 1;
  filters_[slot] = filter;
}

template <Dim N, class T>
void Candidates<N, T>::set_exceptions(std::uint32_t slot, bool has_exceptions) noexcept {
  PairFilter filter = filters_[slot];
  filter.has_exceptions = has_exceptions;
  set_filter(slot, filter);
  is_stray_[slot] = 1;
  has_new_ = true;
}

template <Dim N, class T>
void Candidates<N, T>::put(std::uint32_t slot, const Box& box, const PairFilter& filter) noexcept {
  set_filter(slot, filter);
  boxes_[slot] = box;
  margins_[slot] = 0;
  is_stray_[slot] = 1;
  has_new_ = has_new_ || !is_nothing(box);
}

template <Dim N, class T>
bool Candidates<N, T>::is_at_home(std::uint32_t slot) const {
  return covers(fat_boxes_[slot], boxes_[slot]);
}

// ---- The list

/// Whether all boxes are inside their fat boxes. Notes the longest step.
template <Dim N, class T>
bool Candidates<N, T>::have_stayed(std::size_t slots) {
  const T excess = largest_excess(boxes_.data(), fat_boxes_.data(), slots);
  if (uses_ == 1) step_ = std::max(T(0), margin_ + excess);
  return !(excess > 0);
}

/// The margin of the next list. After a margin that was not worth it, the margin is zero for a number of lists, which
/// doubles each time.
template <Dim N, class T>
T Candidates<N, T>::margin_for_all() {
  if (margin_ > 0 && uses_ < least_uses) {
    pause_ = next_pause_;
    next_pause_ = std::min(2 * next_pause_, longest_pause);
  } else if (margin_ > 0) {
    next_pause_ = 1;
  }
  const T margin = static_cast<T>(steps_for_all) * step_;
  const bool is_small = margin <= static_cast<T>(most_of_mean_side) * mean_side_;
  if (pause_ == 0) return is_small ? margin : T(0);
  --pause_;
  return 0;
}

template <Dim N, class T>
void Candidates<N, T>::make_fat_boxes(std::size_t slots, T margin) {
  reaches_.resize(slots);
  largest_ = detail::make_fat_boxes(boxes_.data(), slots, margin, fat_boxes_.data(), reaches_.data());
  std::fill(margins_.begin(), margins_.begin() + static_cast<std::ptrdiff_t>(slots), margin);
  measure_sides(slots);
}

/// The mean of a sample.
template <Dim N, class T>
void Candidates<N, T>::measure_sides(std::size_t slots) noexcept {
  double sides = 0;
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < slots; slot += slots / least_sample + 1) {
    const T side = longest_side(boxes_[slot]);
    if (!(side > 0 && side <= std::numeric_limits<T>::max())) continue;
    sides += static_cast<double>(side);
    ++count;
  }
  if (count > 0) mean_side_ = static_cast<T>(sides / static_cast<double>(count));
}

template <Dim N, class T>
std::span<const Pair> Candidates<N, T>::list(std::size_t slots, const Executor& executor,
                                             const PairExceptions& exceptions) {
  if (form_ == Form::list && !has_new_ && have_stayed(slots)) {
    ++uses_;
    return list_;
  }
  make_list(slots, margin_for_all(), executor, exceptions);
  return list_;
}

template <Dim N, class T>
void Candidates<N, T>::make_list(std::size_t slots, T margin, const Executor& executor,
                                 const PairExceptions& exceptions) {
  form_ = Form::none;
  ++list_number_;
  margin_ = margin;
  uses_ = 1;
  make_fat_boxes(slots, margin_);
  list_ = finder_.find({reaches_.data(), slots}, {.executor = &executor});
  if (choosy_ > 0) {
    admitted_.clear();
    for (const Pair& pair : list_) {
      if (is_admitted(pair, exceptions)) admitted_.push_back(pair);
    }
    list_ = admitted_;
  }
  std::fill(is_stray_.begin(), is_stray_.end(), char{0});
  has_new_ = false;
  form_ = Form::list;
}

// ---- The graph

/// The margin for a graph built from this list: from the median step of the boxes that have left their fat boxes.
template <Dim N, class T>
T Candidates<N, T>::margin_for_graph(std::size_t slots) const {
  std::vector<T> steps;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const T excess = excess_of(boxes_[slot], fat_boxes_[slot]);
    if (excess > 0 && excess <= std::numeric_limits<T>::max()) steps.push_back(margin_ + excess);
  }
  if (steps.size() * least_share_of_strays <= slots) return margin_;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const T margin = static_cast<T>(steps_in_graph) * *middle;
  return margin <= static_cast<T>(most_of_mean_side_in_graph) * mean_side_ ? margin : margin_;
}

template <Dim N, class T>
void Candidates<N, T>::link(std::size_t slots, std::span<const Pair> touching, const Executor& executor,
                            const PairExceptions& exceptions) {
  if (form_ != Form::list) list(slots, executor, exceptions);
  const T margin = margin_for_graph(slots);
  if (margin > margin_) make_list(slots, margin, executor, exceptions);
  form_ = Form::none;
  graph_.assign(list_, touching, boxes_.size());
  std::vector<Box> fat_boxes;
  std::vector<std::uint32_t> places;
  fat_boxes.reserve(slots);
  places.reserve(slots);
  std::fill(is_held_.begin(), is_held_.end(), char{0});
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    if (is_nothing(boxes_[slot]) || is_nothing(fat_boxes_[slot])) continue;
    fat_boxes.push_back(touching_bounds(fat_boxes_[slot]));
    places.push_back(slot);
    is_held_[slot] = 1;
  }
  tree_.clear();
  tree_.fill(fat_boxes, places, executor);
  form_ = Form::graph;
}

template <Dim N, class T>
T Candidates<N, T>::margin_for(std::uint32_t slot) const {
  const T most = static_cast<T>(most_of_side) * std::max(mean_side_, longest_side(boxes_[slot]));
  const T excess = excess_of(boxes_[slot], fat_boxes_[slot]);
  if (!(excess < most)) return 0;
  const T margin =
      static_cast<T>(margin_kept) * margins_[slot] + static_cast<T>(margin_missed) * std::max(excess, T(0));
  return std::min(margin, most);
}

/// Recalculates the fat box of a stray and updates the tree.
template <Dim N, class T>
void Candidates<N, T>::place(std::uint32_t slot) {
  const bool is_there = !is_nothing(boxes_[slot]);
  const bool was_there = is_held_[slot] != 0;
  if (is_there) {
    margins_[slot] = was_there ? margin_for(slot) : T(0);
    fat_boxes_[slot] = fat_box_around(boxes_[slot], margins_[slot]);
    Box reach = fat_boxes_[slot];
    largest_ = std::max(largest_, grow_for_touching(reach));
    if (was_there) {
      tree_.update(slot, reach);
    } else {
      tree_.insert(slot, reach);
    }
  } else {
    fat_boxes_[slot] = boxes_[slot];
    if (was_there) tree_.erase(slot);
  }
  is_held_[slot] = is_there ? 1 : 0;
}

/// Of a pair of strays, the one with the lower slot finds the other.
template <Dim N, class T>
void Candidates<N, T>::find_around_strays(const Executor& executor, const PairExceptions& exceptions) {
  const std::size_t tasks = (strays_.size() + questions_in_task - 1) / questions_in_task;
  if (found_.size() < tasks) found_.resize(tasks);
  for (std::vector<Pair>& part : found_) part.clear();
  executor.parallel_for(tasks, [&](std::size_t task) {
    std::vector<Pair>& part = found_[task];
    const std::size_t last = std::min(strays_.size(), (task + 1) * questions_in_task);
    for (std::size_t i = task * questions_in_task; i < last; ++i) {
      const std::uint32_t slot = strays_[i];
      if (is_held_[slot] == 0) continue;
      visit_met(tree_, RegionProbe<Box>(tree_.box(slot)), [&](const BvhName& found) {
        const std::uint32_t other = found.slot;
        const bool is_found_from_there = is_stray_[other] != 0 && other <= slot;
        if (!is_found_from_there && is_admitted({slot, other}, exceptions)) part.push_back({slot, other});
        return true;
      });
    }
  });
}

/// Merges what was found around strays into the graph. The previous candidates of each stray are marked with a number
/// of its own; marks are cleared for those found again, and the rest are removed.
template <Dim N, class T>
void Candidates<N, T>::mend_graph() {
  std::size_t count = 0;
  for (const std::vector<Pair>& part : found_) count += part.size();
  graph_.reserve(boxes_.size(), count);
  marks_.resize(boxes_.size(), 0);
  for (std::size_t i = 0, next = 0; i < strays_.size(); ++i) {
    const std::uint32_t slot = strays_[i];
    const std::vector<Pair>& part = found_[i / questions_in_task];
    if (i % questions_in_task == 0) next = 0;
    if (++mark_ == 0) std::fill(marks_.begin(), marks_.end(), mark_++);
    graph_.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t /*edge*/) { marks_[other] = mark_; });
    for (; next < part.size() && part[next].a == slot; ++next) {
      std::uint32_t& mark = marks_[part[next].b];
      if (mark != mark_) graph_.add(part[next]);
      mark = 0;
    }
    graph_.visit_pairs_of(slot, [&](std::uint32_t other, std::uint32_t edge) {
      const bool is_found_from_there = is_stray_[other] != 0 && other < slot;
      if (marks_[other] == mark_ && !is_found_from_there && !graph_.is_touching(edge)) graph_.remove(edge);
    });
  }
}

/// If it throws, strays remain strays, to be found by the next call, and the graph lacks no pair of other slots.
template <Dim N, class T>
void Candidates<N, T>::follow(std::span<const std::uint32_t> changed, const Executor& executor,
                              const PairExceptions& exceptions) {
  strays_.clear();
  for (const std::uint32_t slot : changed) {
    if (is_stray_[slot] == 0 && is_at_home(slot)) continue;
    is_stray_[slot] = 1;
    strays_.push_back(slot);
  }
  if (strays_.empty()) return;
  for (std::size_t i = 0; i < strays_.size(); ++i) {
    const std::uint32_t later = strays_[std::min(i + prefetch_distance / 2, strays_.size() - 1)];
    const std::uint32_t sooner = strays_[std::min(i + prefetch_distance / 4, strays_.size() - 1)];
    if (is_held_[later] != 0) tree_.prefetch_place(later);
    if (is_held_[sooner] != 0) tree_.prefetch_node(sooner);
    place(strays_[i]);
  }
  find_around_strays(executor, exceptions);
  mend_graph();
  for (const std::uint32_t slot : strays_) is_stray_[slot] = 0;
}

template <Dim N, class T>
void Candidates<N, T>::part(const Pair& pair, std::uint32_t edge) noexcept {
  if (boxes_overlap(touching_bounds(fat_boxes_[pair.a]), touching_bounds(fat_boxes_[pair.b]))) {
    graph_.set_touching(edge, false);
  } else {
    graph_.remove(edge);
  }
}

template class Candidates<2, float>;
template class Candidates<3, float>;
template class Candidates<2, double>;
template class Candidates<3, double>;

}  // namespace graze::detail
