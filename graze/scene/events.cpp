// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <graze/scene/events.hpp>

namespace graze {
namespace {

/// In this order pairs of the same places follow each other, whoever has been there.
std::uint64_t places_of(const ObjectPair& pair) { return std::uint64_t{pair.a.index} << 32U | pair.b.index; }

}  // namespace

/// Most pairs stay: each is written to that list, which goes on if it does.
void detail::find_events(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after,
                         SceneEvents& events) {
  events.began.clear();
  events.stayed.resize(after.size());
  events.ended.clear();
  std::size_t stayed = 0;
  auto old = before.begin();
  for (const ObjectPair& pair : after) {
    const std::uint64_t places = places_of(pair);
    for (; old != before.end() && places_of(*old) < places; ++old) events.ended.push_back(*old);
    const bool is_there = old != before.end() && *old == pair;
    if (!is_there) events.began.push_back(pair);
    events.stayed[stayed] = pair;
    stayed += is_there ? 1 : 0;
    old += is_there ? 1 : 0;
  }
  events.ended.insert(events.ended.end(), old, before.end());
  events.stayed.resize(stayed);
}

SceneEvents events_between(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after) {
  SceneEvents events;
  detail::find_events(before, after, events);
  return events;
}

}  // namespace graze
