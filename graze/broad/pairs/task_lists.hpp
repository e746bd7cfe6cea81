// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs/pair_sink.hpp>

namespace graze::detail {

/// Concatenates the results of tasks in the order of tasks, whatever the order in which they end: each list is copied
/// as soon as all earlier tasks have ended, so that few lists are held at a time. A List keeps the memory of
/// list->all(), a span of pairs, until it is destroyed.
template <class List>
class TaskLists {
 public:
  /// `ahead` is the result of room.ahead().
  TaskLists(std::size_t tasks, PairSink& room, std::span<Pair> ahead) : room_(room), ahead_(ahead), lists_(tasks) {}

  /// Takes the result of a task, from any thread.
  void add(std::size_t task, std::unique_ptr<List> list) {
    std::vector<Copy> copies;
    {
      const std::lock_guard lock(mutex_);
      lists_[task] = std::move(list);
      for (; has_room_ && next_ < lists_.size() && lists_[next_] != nullptr; ++next_) {
        const std::size_t end = end_ + lists_[next_]->all().size();
        has_room_ = end <= ahead_.size();
        if (!has_room_) break;  // from now on all are kept
        room_.reach(end);       // not reach_by_all: other threads may need this lock
        copies.push_back({std::move(lists_[next_]), std::exchange(end_, end)});
      }
    }
    for (const Copy& copy : copies) copy_to(copy.list->all(), ahead_.data() + copy.place);
  }

  /// All pairs, when all tasks have ended.
  std::span<const Pair> take() {
    std::size_t count = end_;
    for (std::size_t k = next_; k < lists_.size(); ++k) count += lists_[k]->all().size();
    if (next_ == lists_.size()) return {room_.all_in_turns(count), count};
    Buffer<Pair> copied;
    copied.require(end_);
    copy_to(ahead_.first(end_), copied.data());
    Pair* const all = room_.all(count);
    copy_to({copied.data(), end_}, all);
    for (std::size_t place = end_; next_ < lists_.size(); ++next_) {
      copy_to(lists_[next_]->all(), all + place);
      place += lists_[next_]->all().size();
    }
    return {all, count};
  }

 private:
  struct Copy {
    std::unique_ptr<List> list;
    std::size_t place;
  };

  static void copy_to(std::span<const Pair> pairs, Pair* to) { std::copy(pairs.begin(), pairs.end(), to); }

  PairSink& room_;
  std::span<Pair> ahead_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<List>> lists_;
  std::size_t next_ = 0;  // the first task whose list has not been copied
  std::size_t end_ = 0;   // end of the copied pairs
  bool has_room_ = true;
};

}  // namespace graze::detail
