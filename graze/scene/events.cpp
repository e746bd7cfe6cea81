// SPDX-License-Identifier: MIT
#include <compare>
#include <cstddef>

#include <graze/scene/events.hpp>

namespace graze {

SceneEvents events_between(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after) {
  SceneEvents events;
  auto old = before.begin();
  for (const ObjectPair& pair : after) {
    for (; old != before.end() && *old < pair; ++old) events.ended.push_back(*old);
    if (old != before.end() && *old == pair) {
      events.stayed.push_back(pair);
      ++old;
    } else {
      events.began.push_back(pair);
    }
  }
  events.ended.insert(events.ended.end(), old, before.end());
  return events;
}

}  // namespace graze
