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

/// What tasks find, one after the other in the order of tasks, however they end: each is copied to the room for all as
/// soon as those before have ended, so that few lists are held at a time. A List is what keeps the memory of
/// list->all(), a span of pairs, until it is destroyed.
template <class List>
class TaskLists {
 public:
  /// For the memory ahead in a room.
  TaskLists(std::size_t tasks, PairSink& room, std::span<Pair> ahead) : room_(room), ahead_(ahead), lists_(tasks) {}

  /// Takes what a task has found, from any thread.
  void add(std::size_t task, std::unique_ptr<List> list) {
    std::vector<Copy> copies;
    {
      const std::lock_guard lock(mutex_);
      lists_[task] = std::move(list);
      for (; has_room_ && next_ < lists_.size() && lists_[next_] != nullptr; ++next_) {
        const std::size_t end = end_ + lists_[next_]->all().size();
        has_room_ = end <= ahead_.size();
        if (!has_room_) break;  // from now on all are kept
        room_.reach(end);       // not by all threads: they may be in need of this lock
        copies.push_back({std::move(lists_[next_]), std::exchange(end_, end)});
      }
    }
    for (const Copy& copy : copies) copy_to(copy.list->all(), ahead_.data() + copy.place);
  }

  /// All of them, when all tasks have ended.
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
  std::size_t end_ = 0;   // of those that have
  bool has_room_ = true;
};

}  // namespace graze::detail
