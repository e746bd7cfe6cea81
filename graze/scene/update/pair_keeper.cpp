// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include <graze/broad/touching_pairs.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/update/classify_boxes.hpp>
#include <graze/scene/update/compaction_kernels.hpp>
#include <graze/scene/update/pair_keeper.hpp>

namespace graze::detail {
namespace {

/// If more than one in this many objects has changed, all candidates are tested: finding those of one object costs far
/// more than reading one from a list.
constexpr std::size_t mended_share = 16;

/// Exact tests per task.
constexpr std::size_t tests_in_task = 1024;

/// Runs `work(first, last)` over blocks of 0 ... count.
template <class Work>
void in_blocks(std::size_t count, const Executor& executor, const Work& work) {
  executor.parallel_for((count + tests_in_task - 1) / tests_in_task, [&](std::size_t block) {
    work(block * tests_in_task, std::min(count, (block + 1) * tests_in_task));
  });
}

/// For coordinates so small that rounding is not relative, a box grows by this.
template <class T>
constexpr T least_forgiven = 4 * std::numeric_limits<T>::denorm_min();

Pair ascending(const Pair& pair) { return {std::min(pair.a, pair.b), std::max(pair.a, pair.b)}; }

}  // namespace

template <Dim N, class T>
void PairKeeper<N, T>::reserve(std::size_t slots) {
  if (kinds_.size() >= slots) return;
  const std::size_t room = 2 * slots + 16;
  candidates_.reserve(room);
  changed_.reserve(room);
  changes_.resize(room, Change::none);
  kinds_.resize(room);
}

template <Dim N, class T>
auto PairKeeper<N, T>::kind_of(const Object<N, T>& object) -> Kind {
  const bool is_live = !is_nothing(object.box);
  return {is_live, is_live && std::holds_alternative<Aabb<N, T>>(object.shape)};
}

/// An object without points is treated as removed.
template <Dim N, class T>
void PairKeeper<N, T>::note_new(std::uint32_t slot, const Object<N, T>& object) noexcept {
  const Kind kind = kind_of(object);
  candidates_.put(slot, kind.is_live ? sized_box(object) : Aabb<N, T>::nothing(), filter_of(object));
  set_kind(slot, kind);
  set_changed(slot, Change::replaced);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
  const Kind kind = kind_of(object);
  if (kind.is_live) {
    candidates_.move(slot, sized_box(object));
  } else {
    candidates_.move(slot, Aabb<N, T>::nothing());
  }
  set_kind(slot, kind);
  set_changed(slot, Change::moved);
}

template <Dim N, class T>
void PairKeeper<N, T>::note_moved_boxes(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept {
  candidates_.move_all(ids, boxes);
  Change* const changes = changes_.data();
  for (const ObjectId& id : ids) {
    Change& change = changes[id.index];
    if (change == Change::none) changed_.add(id.index);
    change = std::max(change, Change::moved);
  }
}

template <Dim N, class T>
void PairKeeper<N, T>::note_gone(std::uint32_t slot) noexcept {
  candidates_.put(slot, Aabb<N, T>::nothing(), {});
  set_kind(slot, {});
  set_changed(slot, Change::replaced);
}

template <Dim N, class T>
void PairKeeper<N, T>::set_kind(std::uint32_t slot, Kind kind) noexcept {
  live_ += kind.is_live ? 1 : 0;
  live_ -= kinds_[slot].is_live ? 1 : 0;
  others_ += kind.is_live && !kind.is_box ? 1 : 0;
  others_ -= kinds_[slot].is_live && !kinds_[slot].is_box ? 1 : 0;
  kinds_[slot] = kind;
}

template <Dim N, class T>
bool PairKeeper<N, T>::have_all_changed(std::size_t slots) const {
  if (changed_.size() < live_) return false;
  if (changed_.size() == slots) return true;
  const std::span<const std::uint32_t> changed = changed_.all();
  const auto is_live = [this](std::uint32_t slot) { return kinds_[slot].is_live; };
  return static_cast<std::size_t>(std::count_if(changed.begin(), changed.end(), is_live)) == live_;
}

// ---- Exact tests

/// A bound on the depth beyond which boxes overlap or are apart regardless of the tolerance of `relation`.
template <Dim N, class T>
T PairKeeper<N, T>::certain_depth() const {
  const double share = 2 * (tolerance::box_slack + 4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
  return round_up<T>(share * static_cast<double>(candidates_.largest())) + least_forgiven<T>;
}

/// Determines whether each pair touches.
template <Dim N, class T>
void PairKeeper<N, T>::judge(std::span<const Pair> pairs, const Slots& slots, const Executor& executor) {
  touches_.resize(pairs.size());
  const T certain = certain_depth();
  in_blocks(pairs.size(), executor, [&](std::size_t first, std::size_t last) {
    std::array<ShapePair<N, T>, tests_in_task> shapes;
    std::array<std::size_t, tests_in_task> places;
    std::array<Relation, tests_in_task> relations;
    const std::span<const Pair> block = pairs.subspan(first, last - first);
    char* const touches = touches_.data() + first;
    std::size_t open = 0;
    if (others_ == 0) {
      open = classify_boxes(candidates_.boxes(), slots.size(), block, certain, touches, places.data());
    } else {
      const auto are_boxes = [this](const Pair& pair) { return kinds_[pair.a].is_box && kinds_[pair.b].is_box; };
      open = classify_bounds(candidates_.boxes(), block, certain, are_boxes, touches, places.data());
    }
    for (std::size_t k = 0; k < open; ++k) {
      const auto [a, b] = ascending(block[places[k]]);
      shapes[k] = {&slots[a]->shape, &slots[b]->shape};
    }
    relations_of<N, T>({shapes.data(), open}, relations.data());
    for (std::size_t k = 0; k < open; ++k) touches[places[k]] = relations[k] != Relation::apart ? 1 : 0;
  });
}

// ---- All candidates

template <Dim N, class T>
void PairKeeper<N, T>::find_anew(const Slots& slots, const Executor& executor, const PairExceptions& exceptions) {
  list_pairs();
  std::span<const Pair> near = candidates_.list(slots.size(), executor, exceptions);
  const bool are_all_new = have_all_changed(slots.size());
  const bool have_places = near.size() <= std::numeric_limits<std::uint32_t>::max();
  found_list_ = are_all_new && have_places ? candidates_.list_number() : no_list;
  if (!are_all_new) {
    near_pairs_.clear();
    for (const Pair& pair : near) {
      if (has_changed(pair)) near_pairs_.push_back(pair);
    }
    near = near_pairs_;
  }
  judge(near, slots, executor);
  keep_touching(near);
  if (!are_all_new) merge_with_unchanged();
}

/// Selects the touching pairs of those that were tested. Far more are near than touch, so memory is allocated for these
/// only.
template <Dim N, class T>
void PairKeeper<N, T>::keep_touching(std::span<const Pair> pairs) {
  const auto touching = static_cast<std::size_t>(std::count(touches_.begin(), touches_.end(), char{1}));
  const auto give_room = [room = touching + room_behind_chosen](auto& list) {
    list.clear();
    if (list.capacity() < room) list.reserve(room + room / 8);
    list.resize(room);
  };
  give_room(found_);
  give_room(found_places_);
  const std::size_t count =
      compaction_kernels().choose(pairs.data(), touches_.data(), pairs.size(), found_.data(), found_places_.data());
  found_.resize(count);
  found_places_.resize(count);
}

template <Dim N, class T>
std::optional<ListedPairs> PairKeeper<N, T>::listed() const {
  if (found_list_ == no_list || found_list_ != list_) return std::nullopt;
  return ListedPairs{found(), found_places_, places_, touches_.data(), touched_.data()};
}

/// Merges the pairs found for changed objects with the known ones of the others.
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
  std::swap(found_, merged_);
}

template <Dim N, class T>
void PairKeeper<N, T>::list_pairs() {
  if (is_listed_) return;
  candidates_.graph().list_touching(touching_);
  is_listed_ = true;
}

// ---- Candidates of changed objects

/// Collects the candidates of each changed slot.
template <Dim N, class T>
void PairKeeper<N, T>::gather_near() {
  const PairGraph& graph = candidates_.graph();
  const Aabb<N, T>* const boxes = candidates_.boxes();
  near_.clear();
  near_pairs_.clear();
  graph.visit_pairs_of_all(changed_.all(), [&](std::uint32_t slot, std::uint32_t other, std::uint32_t edge) {
    if (is_seen_from_there(slot, other)) return;
    prefetch(&boxes[other]);
    near_.push_back({{slot, other}, edge, graph.is_touching(edge)});
    near_pairs_.push_back({slot, other});
  });
}

/// Finds the pairs that began and ended among the candidates of changed slots.
template <Dim N, class T>
void PairKeeper<N, T>::compare_with_known(const PairExceptions& exceptions) {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const auto& [pair, edge, was] = near_[i];
    const bool is = touches_[i] != 0 && candidates_.is_admitted(pair, exceptions);
    if (!was && !is) continue;
    const bool are_others = is_replaced(pair.a) || is_replaced(pair.b);
    if (was && is && !are_others) continue;
    if (was) ended_.push_back(ascending(pair));
    if (is) began_.push_back(ascending(pair));
    if (was && !is) ended_edges_.push_back(near_[i]);
    if (is && !was) began_edges_.push_back(edge);
  }
  std::sort(began_.begin(), began_.end());
  std::sort(ended_.begin(), ended_.end());
}

template <Dim N, class T>
void PairKeeper<N, T>::find_around_changed(const Slots& slots, const Executor& executor,
                                           const PairExceptions& exceptions) {
  began_.clear();
  ended_.clear();
  began_edges_.clear();
  ended_edges_.clear();
  if (changed_.empty()) return;
  if (!candidates_.is_linked()) candidates_.link(slots.size(), touching_, executor, exceptions);
  candidates_.follow(changed_.all(), executor, exceptions);
  gather_near();
  judge(near_pairs_, slots, executor);
  compare_with_known(exceptions);
}

// ---- Updates

template <Dim N, class T>
PairPlan PairKeeper<N, T>::find(const Slots& slots, const Executor& executor, PairPlan plan,
                                const PairExceptions& exceptions) {
  if (plan == PairPlan::automatic) {
    plan = changed_.size() * mended_share < live_ || changed_.empty() ? PairPlan::mend : PairPlan::anew;
  }
  plan_ = plan;
  found_list_ = no_list;
  if (plan == PairPlan::mend) {
    find_around_changed(slots, executor, exceptions);
  } else {
    find_anew(slots, executor, exceptions);
  }
  return plan;
}

template <Dim N, class T>
void PairKeeper<N, T>::commit() noexcept {
  if (plan_ == PairPlan::mend) {
    for (const NearPair& ended : ended_edges_) candidates_.part(ended.pair, ended.edge);
    for (const std::uint32_t edge : began_edges_) candidates_.graph().set_touching(edge, true);
    is_listed_ = is_listed_ && began_edges_.empty() && ended_edges_.empty();
  } else {
    std::swap(touching_, found_);
    std::swap(places_, found_places_);
    std::swap(touched_, touches_);
    is_listed_ = true;
  }
  list_ = found_list_;
  for (const std::uint32_t slot : changed_.all()) changes_[slot] = Change::none;
  changed_.clear();
}

template class PairKeeper<2, float>;
template class PairKeeper<3, float>;
template class PairKeeper<2, double>;
template class PairKeeper<3, double>;

}  // namespace graze::detail
