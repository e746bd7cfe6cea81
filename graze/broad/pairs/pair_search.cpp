// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/overlap_kernels.hpp>
#include <graze/broad/pairs/pair_search.hpp>
#include <graze/broad/pairs/task_lists.hpp>

namespace graze::detail {

constexpr std::size_t most_children = std::size_t{block_size} * block_size;  // of a pair of blocks
constexpr std::size_t parents_at_once = 16;                                  // the order of pairs depends on it

/// What tasks have found so far, to size the memory of later tasks: growing costs a copy and fresh pages.
class ResultStats {
 public:
  void add(std::size_t count) {
    pairs_ += count;
    ++tasks_;
  }

  /// The average result of a task and a quarter more, plus space for a last batch of blocks.
  std::size_t expected() const {
    const std::size_t tasks = tasks_;
    return tasks == 0 ? 0 : pairs_ / tasks * 5 / 4 + block_pairs_at_once * most_children;
  }

 private:
  std::atomic<std::size_t> pairs_ = 0;
  std::atomic<std::size_t> tasks_ = 0;
};

/// The result of one task, and its memory.
template <Dim N, class T>
struct PairSearch<N, T>::Found {
  Buffer<BlockPair> blocks;
  Buffer<Pair> pairs;
  std::size_t count = 0;

  std::span<const Pair> all() const { return {pairs.data(), count}; }

  /// Space for `most` more pairs.
  Pair* room(std::size_t most) {
    pairs.extend(count + most, count);
    return pairs.data() + count;
  }
  void add(std::size_t more) {
    count += more;
    written_ = std::max(written_, count);
  }

  /// The memory held, in bytes. Pairs count as far as they have been written: the system provides pages only then, and
  /// much of the capacity may never be used.
  std::size_t bytes() const { return blocks.bytes() + std::min(written_ * sizeof(Pair), pairs.bytes()); }

 private:
  std::size_t written_ = 0;
};

namespace {

/// Passes the pairs of a task to a sort, through a buffer that is reused.
struct FoundToSort {
  Buffer<Pair>& pairs;
  PairSort::Sink sink;

  Pair* room(std::size_t most) {
    pairs.require(most);
    return pairs.data();
  }
  void add(std::size_t count) { sink.add({pairs.data(), count}); }
};

/// Appends pairs to a sink. Once their total number is estimated, it appends in small batches, while they are in the L1
/// cache.
struct FoundToAppend {
  Buffer<Pair>& pairs;
  PairSink& room_of_all;
  std::size_t held = 0;
  std::size_t expected = 0;  ///< Estimated total; zero if unknown.
  std::size_t count = 0;
  const Pair* first = nullptr;

  Pair* room(std::size_t most) {
    pairs.extend(held + most, held);
    return pairs.data() + held;
  }
  void add(std::size_t more) {
    held += more;
    count += more;
    if (expected > 0) append();
  }
  void expect(std::size_t in_all) {
    expected = in_all;
    if (held > 0) append();
  }

 private:
  void append() {
    first = room_of_all.append({pairs.data(), held}, expected);
    held = 0;
  }
};

/// Counts pairs, and samples their first indices.
struct FoundToForecast {
  std::size_t count = 0;
  std::vector<std::uint32_t> firsts = {};

  Pair* room(std::size_t most) {
    pairs_.require(most);
    return pairs_.data();
  }
  void add(std::size_t more) {
    constexpr std::size_t stride = 16;
    for (std::size_t k = stride - 1 - count % stride; k < more; k += stride) firsts.push_back(pairs_[k].a);
    count += more;
  }

  /// The approximate quantile of the first indices. There must be at least one.
  std::uint32_t first_after(double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(firsts.size()));
    std::nth_element(firsts.begin(), firsts.begin() + place, firsts.end());
    return firsts[static_cast<std::size_t>(place)];
  }

 private:
  Buffer<Pair> pairs_;
};

}  // namespace

template <Dim N, class T>
PairSearch<N, T>::PairSearch() = default;
template <Dim N, class T>
PairSearch<N, T>::~PairSearch() = default;

template <Dim N, class T>
void PairSearch<N, T>::build(Boxes boxes_a, const Boxes* boxes_b, T margin, const Executor& executor) {
  const auto take = [margin, &executor](BlockTree<N, T>& tree, Boxes boxes, BoxSet set) {
    if (!tree.refit(boxes, margin, executor)) tree.build(boxes, margin, executor, set);
  };
  take(tree_a_, boxes_a, boxes_b == nullptr ? BoxSet::only : BoxSet::first);
  other_ = &tree_a_;
  if (boxes_b == nullptr) return;
  take(tree_b_, *boxes_b, BoxSet::second);
  other_ = &tree_b_;
  if (tree_a_.height() == 0 || tree_b_.height() == 0) return;
  tree_a_.raise(tree_b_.height());
  tree_b_.raise(tree_a_.height());
}

/// The bounds of a level's blocks; null for the last level.
template <Dim N, class T>
const Block<N, T>* PairSearch<N, T>::above_of(std::size_t level) const {
  return level + 1 < other_->height() ? other_->level(level + 1) : nullptr;
}

/// Finds the pairs of level-1 blocks that may contain pairs of boxes.
template <Dim N, class T>
void PairSearch<N, T>::descend() {
  meeting_count_ = 0;
  if (tree_a_.height() == 0 || other_->height() == 0) return;
  meetings_.require(1);
  meetings_[0] = {0, 0};
  meeting_count_ = 1;
  for (std::size_t level = tree_a_.height() - 1; level > 1; --level) {
    constexpr std::size_t step = 64;
    std::size_t children = 0;
    for (std::size_t k = 0; k < meeting_count_; k += step) {
      const std::size_t parents = std::min(step, meeting_count_ - k);
      spare_meetings_.extend(children + parents * most_children, children);
      children += overlap_kernels<N, T>().descend(tree_a_.level(level), other_->level(level), above_of(level),
                                                  other_ == &tree_a_, meetings_.data() + k, parents,
                                                  spare_meetings_.data() + children);
    }
    std::swap(meetings_, spare_meetings_);
    meeting_count_ = children;
  }
}

/// Finds the pairs of boxes below pairs of level-1 blocks and writes them to the space that `found` provides.
template <Dim N, class T>
template <class Finds>
void PairSearch<N, T>::meet(std::span<const BlockPair> parents, Buffer<BlockPair>& list, Finds& found) const {
  if (parents.empty()) return;  // a tree may have no levels
  const OverlapKernels<N, T>& kernels = overlap_kernels<N, T>();
  const bool itself = other_ == &tree_a_;
  const BlockLevel<N, T> level_a{tree_a_.level(0), tree_a_.ids(), tree_a_.level(1)};
  const BlockLevel<N, T> level_b{other_->level(0), other_->ids(), other_->level(1)};
  list.require(parents_at_once * most_children);
  for (std::size_t k = 0; k < parents.size(); k += parents_at_once) {
    const std::size_t blocks =
        kernels.descend(tree_a_.level(1), other_->level(1), above_of(1), itself, parents.data() + k,
                        std::min(parents_at_once, parents.size() - k), list.data());
    for (std::size_t j = 0; j < blocks; j += block_pairs_at_once) {
      const std::size_t following = j + block_pairs_at_once;
      for (std::size_t i = following; i < std::min(blocks, following + block_pairs_at_once); ++i) {
        prefetch_whole(other_->level(0) + list[i].b);  // a is often that of the previous pair
      }
      Pair* const room = found.room(block_pairs_at_once * most_children);
      found.add(kernels.meet(level_a, level_b, itself, list.data() + j,
                             std::min<std::size_t>(block_pairs_at_once, blocks - j), room));
    }
  }
}

/// The number of tasks depends on the work, not on the threads, so the order of pairs is the same for any number of
/// threads.
template <Dim N, class T>
std::size_t PairSearch<N, T>::task_count() const {
  constexpr std::size_t least_meetings = 128;
  constexpr std::size_t most_tasks = 64;
  return std::clamp<std::size_t>(meeting_count_ / least_meetings, 1, most_tasks);
}

template <Dim N, class T>
std::span<const BlockPair> PairSearch<N, T>::meetings_of(std::size_t task, std::size_t tasks) const {
  const std::size_t first = task * meeting_count_ / tasks;
  return {meetings_.data() + first, (task + 1) * meeting_count_ / tasks - first};
}

/// Estimates from a sample of the pairs of blocks, taken separately from blocks paired with themselves, which all have
/// similar numbers of pairs, and from the others. Returns an empty forecast if there are too few.
template <Dim N, class T>
PairForecast PairSearch<N, T>::forecast() const {
  constexpr std::size_t stride = 37;
  if (meeting_count_ < 64 * stride) return {};
  Buffer<BlockPair> blocks;
  FoundToForecast sample;
  struct Kind {
    std::size_t meetings = 0;
    std::size_t sampled = 0;
    std::size_t found = 0;
  };
  std::array<Kind, 2> kinds;
  for (std::size_t k = 0; k < meeting_count_; ++k) {
    Kind& kind = kinds[meetings_[k].a == meetings_[k].b ? 0 : 1];
    if (kind.meetings++ % stride != stride / 2) continue;
    const std::size_t before = sample.count;
    meet({meetings_.data() + k, 1}, blocks, sample);
    ++kind.sampled;
    kind.found += sample.count - before;
  }
  if (sample.firsts.empty()) return {};
  PairForecast result;
  for (const Kind& kind : kinds) result.count += kind.found * kind.meetings / std::max<std::size_t>(kind.sampled, 1);
  for (std::size_t k = 0; k < result.firsts.size(); ++k) result.firsts[k] = sample.first_after(sort_.shares()[k]);
  return result;
}

template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find_sorted(const PairLimits& limits, const Executor& executor,
                                                    PairSink& room) {
  sort_.begin(limits, executor.concurrency());
  for (BlockTree<N, T>* const tree : {&tree_a_, &tree_b_}) {
    for (const std::span<std::byte> memory : tree->idle_memory()) sort_.lend(memory);
  }
  sort_.wait_in(room, sort_.last().count > 0 ? sort_.last() : forecast());
  const std::size_t tasks = task_count();
  executor.parallel_for(tasks, [&](std::size_t task) {
    const typename Pool<Found>::Loan memory(workers_);
    FoundToSort found{memory->pairs, PairSort::Sink(sort_)};
    meet(meetings_of(task, tasks), memory->blocks, found);
  });
  const std::size_t count = sort_.count();
  return {sort_.sort(executor, room), count};
}

/// Finds the pairs of all tasks. As long as each task starts after the previous one has ended, they share the first
/// list; later tasks have lists of their own.
template <Dim N, class T>
void PairSearch<N, T>::find_lists(std::size_t tasks, const Executor& executor) {
  while (found_.size() < tasks) found_.push_back(std::make_unique<Found>());
  for (std::size_t task = 0; task < tasks; ++task) found_[task]->count = 0;
  ResultStats so_far;
  std::atomic<std::size_t> in_order = 0;  // this many tasks have ended and are in the first list
  executor.parallel_for(tasks, [&](std::size_t task) {
    const bool next_in_order = in_order == task;
    Found& found = *found_[next_in_order ? 0 : task];
    const std::size_t before = found.count;
    // On one thread it becomes the list of all pairs; on several, memory for all would be a third copy of them.
    const std::size_t tasks_to_come = next_in_order && executor.concurrency() == 1 ? tasks - task : 1;
    found.pairs.extend(before + so_far.expected() * tasks_to_come, before);
    meet(meetings_of(task, tasks), found.blocks, found);
    so_far.add(found.count - before);
    if (next_in_order) in_order = task + 1;
  });
}

/// Finds the same pairs as the tasks would, one task after another, and appends them.
template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find_in_turns(PairSink& room) {
  constexpr std::size_t step = 2 * parents_at_once;  // cut tasks where they are cut anyway, to keep the order of pairs
  const std::size_t tasks = task_count();
  const typename Pool<Found>::Loan memory(workers_);
  FoundToAppend found{memory->pairs, room};
  std::size_t done = 0;
  for (std::size_t task = 0; task < tasks; ++task) {
    const std::span<const BlockPair> meetings = meetings_of(task, tasks);
    for (std::size_t k = 0; k < meetings.size(); k += step) {
      const std::span<const BlockPair> some = meetings.subspan(k, std::min(step, meetings.size() - k));
      meet(some, memory->blocks, found);
      done += some.size();
      found.expect((found.count / done + 1) * meeting_count_);
    }
  }
  return {found.first, found.count};
}

/// Finds the pairs in lists, then concatenates these.
template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find_in_lists(const Executor& executor, PairSink& room) {
  const std::size_t tasks = task_count();
  find_lists(tasks, executor);
  std::vector<std::size_t> begins = {0};  // of each list among all pairs
  for (std::size_t task = 0; task < tasks; ++task) begins.push_back(begins.back() + found_[task]->count);
  const std::size_t count = begins.back();
  if (found_[0]->count == count) {
    return room.appends() ? std::span(room.append(found_[0]->all(), count), count) : found_[0]->all();
  }
  Pair* const pairs = room.all(count);
  executor.parallel_for(tasks, [&](std::size_t task) {
    const std::span<const Pair> found = found_[task]->all();
    std::copy(found.begin(), found.end(), pairs + begins[task]);
  });
  return {pairs, count};
}

/// The same in the same order, without holding all pairs twice: lists are concatenated while others are filled.
template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find_ahead(std::size_t expected, const Executor& executor, PairSink& room) {
  /// A list that is kept until it has been copied.
  class List {
   public:
    explicit List(Pool<Found>& pool) : loan(pool) { loan->count = 0; }
    std::span<const Pair> all() const { return loan->all(); }

    typename Pool<Found>::Loan loan;
  };
  const std::size_t tasks = task_count();
  const std::span<Pair> ahead = room.ahead(expected);
  if (ahead.empty()) return find_in_lists(executor, room);
  TaskLists<List> lists(tasks, room, ahead);
  std::atomic<std::size_t> next = 0;  // tasks in order of time, so few wait for an earlier one
  executor.parallel_for(tasks, [&](std::size_t /*turn*/) {
    const std::size_t task = next++;
    auto list = std::make_unique<List>(workers_);
    meet(meetings_of(task, tasks), list->loan->blocks, *list->loan);
    lists.add(task, std::move(list));
  });
  return lists.take();
}

template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find_any(const PairLimits& limits, const Executor& executor, PairSink& room) {
  if (executor.concurrency() == 1) return room.appends() ? find_in_turns(room) : find_in_lists(executor, room);
  constexpr std::size_t many = 1;  // pairs per box, above which they take more memory than the search
  const bool is_like_last = last_count_ > 0 && last_limits_ == limits;
  const std::size_t expected = is_like_last ? last_count_ : forecast().count;
  const std::span<const Pair> found =
      expected > many * limits.a ? find_ahead(expected, executor, room) : find_in_lists(executor, room);
  last_count_ = found.size();
  last_limits_ = limits;
  return found;
}

template <Dim N, class T>
std::span<const Pair> PairSearch<N, T>::find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                                             PairSink& room) {
  const Executor& executor = executor_of(options);
  build(boxes_a, boxes_b, static_cast<T>(options.margin), executor);
  descend();
  const PairLimits limits{boxes_a.size(), boxes_b != nullptr ? boxes_b->size() : boxes_a.size()};
  if (options.order == PairOrder::any) return find_any(limits, executor, room);
  return find_sorted(limits, executor, room);
}

template <Dim N, class T>
void PairSearch<N, T>::visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                             const PairVisitor& visitor) {
  const Executor& executor = executor_of(options);
  build(boxes_a, boxes_b, static_cast<T>(options.margin), executor);
  descend();
  // Processes tasks in waves, so that only the pairs of one wave are held.
  constexpr std::size_t meetings_per_task = 4;
  constexpr std::size_t tasks_per_wave = 32;
  while (found_.size() < tasks_per_wave) found_.push_back(std::make_unique<Found>());
  for (std::size_t wave = 0; wave < meeting_count_; wave += meetings_per_task * tasks_per_wave) {
    executor.parallel_for(tasks_per_wave, [&](std::size_t task) {
      const std::size_t first = std::min(meeting_count_, wave + task * meetings_per_task);
      const std::size_t last = std::min(meeting_count_, first + meetings_per_task);
      found_[task]->count = 0;
      meet({meetings_.data() + first, last - first}, found_[task]->blocks, *found_[task]);
    });
    for (std::size_t task = 0; task < tasks_per_wave; ++task) {
      if (found_[task]->count > 0 && !visitor(found_[task]->all())) return;
    }
  }
}

template <Dim N, class T>
std::size_t PairSearch<N, T>::bytes() const {
  std::size_t result = tree_a_.bytes() + tree_b_.bytes() + meetings_.bytes() + spare_meetings_.bytes() + sort_.bytes();
  for (const auto* memory : {&found_, &workers_.all()}) {
    for (const auto& found : *memory) result += found->bytes();
  }
  return result;
}

template class PairSearch<2, float>;
template class PairSearch<3, float>;
template class PairSearch<2, double>;
template class PairSearch<3, double>;

}  // namespace graze::detail
