// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/scene/events.hpp>

namespace graze {
namespace {

/// The order of pairs by slots only, whatever the generations of their objects.
std::uint64_t places_of(const ObjectPair& pair) { return std::uint64_t{pair.a.index} << 32U | pair.b.index; }

std::uint64_t places_of(const Pair& pair) { return std::uint64_t{pair.a} << 32U | pair.b; }

ObjectPair named(const Pair& pair, const detail::KeyTable& ids) {
  const Key a = ids.key_of(pair.a);
  const Key b = ids.key_of(pair.b);
  return {{a.index, a.generation, a.owner}, {b.index, b.generation, b.owner}};
}

/// Iterates over the pairs that began and those that stayed as one ascending list.
class BothLists {
 public:
  explicit BothLists(const SceneEvents& events)
      : began_(events.began.data()),
        stayed_(events.stayed.data()),
        began_end_(began_ + events.began.size()),
        stayed_end_(stayed_ + events.stayed.size()) {
    look_at_began();
    look_at_stayed();
  }

  /// Greater than that of every pair at the end.
  std::uint64_t places() const { return std::min(places_of_began_, places_of_stayed_); }

  const ObjectPair& operator*() const { return has_begun() ? *began_ : *stayed_; }

  void operator++() {
    if (has_begun()) {
      ++began_;
      look_at_began();
    } else {
      ++stayed_;
      look_at_stayed();
    }
  }

  /// Copies the pairs of `stayed` as long as `found` has the same slots and no pair of `began` comes first. Returns
  /// their number.
  std::size_t copy_found(std::span<const Pair> found, ObjectPair* to) {
    const std::size_t most = std::min(found.size(), static_cast<std::size_t>(stayed_end_ - stayed_));
    std::size_t count = 0;
    for (; count < most; ++count) {
      const std::uint64_t places = places_of(found[count]);
      if (places != places_of(stayed_[count]) || places > places_of_began_) break;
      to[count] = stayed_[count];
    }
    stayed_ += count;
    look_at_stayed();
    return count;
  }

  static constexpr std::uint64_t end = std::numeric_limits<std::uint64_t>::max();

 private:
  bool has_begun() const { return places_of_began_ < places_of_stayed_; }
  void look_at_began() { places_of_began_ = began_ != began_end_ ? places_of(*began_) : end; }
  void look_at_stayed() { places_of_stayed_ = stayed_ != stayed_end_ ? places_of(*stayed_) : end; }

  const ObjectPair* began_;
  const ObjectPair* stayed_;
  const ObjectPair* began_end_;
  const ObjectPair* stayed_end_;
  std::uint64_t places_of_began_ = end;
  std::uint64_t places_of_stayed_ = end;
};

}  // namespace

SceneEvents events_between(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after) {
  SceneEvents events;
  auto old = before.begin();
  for (const ObjectPair& pair : after) {
    const std::uint64_t places = places_of(pair);
    for (; old != before.end() && places_of(*old) < places; ++old) events.ended.push_back(*old);
    const bool is_there = old != before.end() && *old == pair;
    (is_there ? events.stayed : events.began).push_back(pair);
    old += is_there ? 1 : 0;
  }
  events.ended.insert(events.ended.end(), old, before.end());
  return events;
}

namespace detail {

std::vector<ObjectPair> pairs_of(const SceneEvents& events) {
  const std::span<const ObjectPair> stayed(events.stayed.data(), events.stayed.size());
  std::vector<ObjectPair> pairs;
  pairs.reserve(stayed.size() + events.began.size());
  std::size_t from = 0;
  const auto copy_until = [&](std::size_t end) {
    pairs.insert(pairs.end(), stayed.begin() + static_cast<std::ptrdiff_t>(from),
                 stayed.begin() + static_cast<std::ptrdiff_t>(end));
    from = end;
  };
  for (const ObjectPair& pair : events.began) {
    copy_until(position_of(stayed, pair, from, stayed.size()));
    pairs.push_back(pair);
  }
  copy_until(stayed.size());
  return pairs;
}

namespace {

/// Resizes a list without keeping its content: if it needs more memory, it is reallocated in large pages with a quarter
/// to spare.
void make_long(std::vector<ObjectPair>& pairs, std::size_t count) {
  if (pairs.capacity() < count) {
    pairs.clear();
    reserve_in_large_pages(pairs, count + count / 4);
  }
  pairs.resize(count);
}

/// Replaces the slots, which is all that the pairs hold so far, by ids. The keys are anywhere in memory and are
/// prefetched.
void name_all(std::vector<ObjectPair>& pairs, const KeyTable& ids) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ObjectPair& later = pairs[std::min(k + prefetch_distance, pairs.size() - 1)];
    ids.prefetch_key(later.a.index);
    ids.prefetch_key(later.b.index);
    pairs[k] = named({pairs[k].a.index, pairs[k].b.index}, ids);
  }
}

/// A pair that still lacks its generations and owners.
ObjectPair nameless(const Pair& pair) { return {{pair.a, 0, 0}, {pair.b, 0, 0}}; }

/// Slots have had one object only, so most pairs stay and are copied unchanged.
void find_events_of_the_same(BothLists old, std::span<const Pair> found, const KeyTable& ids, NextEvents& next) {
  SceneEvents& events = next.events;
  std::size_t stayed = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t copied = old.copy_found(found.subspan(k), events.stayed.data() + stayed);
    std::fill_n(next.young.data() + k, copied, char{0});
    stayed += copied;
    k += copied;
    if (k == found.size()) break;
    const std::uint64_t places = places_of(found[k]);
    for (; old.places() < places; ++old) events.ended.push_back(*old);
    if (old.places() == places) {
      next.young[k] = 0;
      events.stayed[stayed++] = *old;
      ++old;
    } else {
      next.young[k] = 1;
      events.began.push_back(nameless(found[k]));
    }
  }
  for (; old.places() != BothLists::end; ++old) events.ended.push_back(*old);
  events.stayed.resize(stayed);
  name_all(events.began, ids);
}

/// Branch-free: each pair is written to the list of those that stayed, and the end of the list advances if it did.
void find_events_of_others(BothLists old, std::span<const Pair> found, const KeyTable& ids, NextEvents& next) {
  SceneEvents& events = next.events;
  std::size_t stayed = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::uint64_t places = places_of(found[k]);
    for (; old.places() < places; ++old) events.ended.push_back(*old);
    const ObjectPair now = named(found[k], ids);
    const bool is_there = old.places() == places && *old == now;
    if (!is_there) events.began.push_back(now);
    next.young[k] = is_there ? 0 : 1;
    events.stayed[stayed] = now;
    stayed += is_there ? 1 : 0;
    if (is_there) ++old;
  }
  for (; old.places() != BothLists::end; ++old) events.ended.push_back(*old);
  events.stayed.resize(stayed);
}

/// Branch-free for most pairs: each is copied to the list of those that stayed, whose end advances if it did. Only
/// pairs that begin or end, which are few, are mispredicted.
void find_stayed_and_ended(const SceneEvents& last, const YoungMarks& young, const ListedPairs& pairs,
                           SceneEvents& events) {
  const std::uint32_t* const places = pairs.places_before.data();
  const std::size_t count = pairs.places_before.size();
  const char* const touches = pairs.touches;
  const char* const is_young = young.data();
  const ObjectPair* began = last.began.data();
  const ObjectPair* stayed = last.stayed.data();
  ObjectPair* to = events.stayed.data();
  for (std::size_t k = 0; k < count; ++k) {
    const ObjectPair* const pair = is_young[k] != 0 ? began++ : stayed++;
    const char stays = touches[places[k]];
    *to = *pair;
    to += stays;
    if (stays == 0) events.ended.push_back(*pair);
  }
  events.stayed.resize(static_cast<std::size_t>(to - events.stayed.data()));
}

void find_began(const ListedPairs& pairs, const KeyTable& ids, NextEvents& next) {
  const std::uint32_t* const places = pairs.places.data();
  const std::size_t count = pairs.places.size();
  const char* const touched = pairs.touched;
  char* const young = next.young.data();
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_young = touched[places[k]] == 0;
    young[k] = is_young ? 1 : 0;
    if (is_young) next.events.began.push_back(nameless(pairs.found[k]));
  }
  name_all(next.events.began, ids);
}

/// Clears the lists, except that `stayed` and the marks are resized with unspecified content.
void clear(NextEvents& next, std::size_t most_stay, std::size_t found) {
  next.events.began.clear();
  next.events.ended.clear();
  make_long(next.events.stayed, most_stay);
  next.young.resize(found);
}

}  // namespace

void find_events(const SceneEvents& last, std::span<const Pair> found, const KeyTable& ids, SlotReuse slot_reuse,
                 NextEvents& next) {
  clear(next, found.size(), found.size());
  const BothLists old(last);
  if (slot_reuse == SlotReuse::the_same) {
    find_events_of_the_same(old, found, ids, next);
  } else {
    find_events_of_others(old, found, ids, next);
  }
}

void find_events(const SceneEvents& last, const YoungMarks& young, const ListedPairs& pairs, const KeyTable& ids,
                 NextEvents& next) {
  clear(next, pairs.places_before.size() + 1, pairs.found.size());
  find_stayed_and_ended(last, young, pairs, next.events);
  find_began(pairs, ids, next);
}

void EventsEdit::plan(const SceneEvents& last, std::span<const Pair> began, std::span<const Pair> ended,
                      const KeyTable& ids) {
  began_.clear();
  ended_.clear();
  added_.clear();
  removed_.clear();
  for (const Pair& pair : began) began_.push_back(named(pair, ids));
  const auto is_before = [](const ObjectPair& each, std::uint64_t places) { return places_of(each) < places; };
  auto old = last.stayed.begin();
  auto young = last.began.begin();
  for (const Pair& pair : ended) {
    const std::uint64_t places = places_of(pair);
    for (; young != last.began.end() && places_of(*young) < places; ++young) added_.push_back(*young);
    if (young != last.began.end() && places_of(*young) == places) {
      ended_.push_back(*young++);
      continue;
    }
    old = std::lower_bound(old, last.stayed.end(), places, is_before);
    removed_.push_back(static_cast<std::size_t>(old - last.stayed.begin()));
    ended_.push_back(*old);
  }
  added_.insert(added_.end(), young, last.began.end());
  stayed_.plan({last.stayed.data(), last.stayed.size()}, removed_, added_);
}

void EventsEdit::make_room(SceneEvents& events) const {
  const std::size_t wanted = stayed_.size();
  if (events.stayed.capacity() < wanted) events.stayed.reserve(wanted + wanted / 2);
}

void EventsEdit::apply(SceneEvents& events) noexcept {
  stayed_.apply(events.stayed, added_);
  std::swap(events.began, began_);
  std::swap(events.ended, ended_);
}

}  // namespace detail
}  // namespace graze
