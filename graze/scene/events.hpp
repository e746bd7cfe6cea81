// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <graze/scene/object.hpp>

namespace graze {

/// What became of touching between two updates of a scene; each list ascending. A pair of which an object was removed
/// has ended, and its id no longer names an object.
struct SceneEvents {
  std::vector<ObjectPair> began;
  std::vector<ObjectPair> stayed;
  std::vector<ObjectPair> ended;
};

/// The events between two ascending lists of pairs.
SceneEvents events_between(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after);

namespace detail {

/// The same in the place of older events, whose memory is used again.
void find_events(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after, SceneEvents& events);

}  // namespace detail

}  // namespace graze
