// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pair.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/list_edit.hpp>

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

/// The pairs that touched when these events were found, ascending: those that began and those that stayed.
std::vector<ObjectPair> pairs_of(const SceneEvents& events);

/// Who is in the slots, if it is known to be who was there at the last update.
enum class SlotReuse : std::uint8_t { the_same, maybe_others };

/// For each of the pairs that touched when events were found, ascending: 1 if it began then, else 0.
using YoungMarks = BlankVector<char>;

/// Events that are being found, in the place of older ones, whose memory is used again.
struct NextEvents {
  SceneEvents events;
  YoungMarks young;
};

/// What touches now and what did at the last update, of one list of pairs that could touch.
struct ListedPairs {
  std::span<const Pair> found;                   ///< That touch now, ascending.
  std::span<const std::uint32_t> places;         ///< Where in the list these are.
  std::span<const std::uint32_t> places_before;  ///< Where those are that touched at the last update.
  const char* touches;                           ///< By place: 1 if it touches now, else 0.
  const char* touched;                           ///< By place: the same at the last update.
};

/// The events between the pairs of the last update and what touches now: pairs of slots, ascending, and who is in them.
void find_events(const SceneEvents& last, std::span<const Pair> found, const KeyTable& ids, SlotReuse slot_reuse,
                 NextEvents& next);

/// The same by a list, where each slot has had one tenant. `young` is of the last events.
void find_events(const SceneEvents& last, const YoungMarks& young, const ListedPairs& pairs, const KeyTable& ids,
                 NextEvents& next);

/// Makes the events of the last update those of the next, where few pairs begin and end. Keeps its memory.
class EventsEdit {
 public:
  /// What is to be done: these pairs of slots have begun, and these of the last ones ended, both ascending. A pair is
  /// in both if the objects in its slots are others.
  void plan(const SceneEvents& last, std::span<const Pair> began, std::span<const Pair> ended, const KeyTable& ids);

  /// In the events that were planned for, so that `apply` cannot fail.
  void make_room(SceneEvents& events) const;

  void apply(SceneEvents& events) noexcept;

 private:
  std::vector<ObjectPair> began_;
  std::vector<ObjectPair> ended_;
  std::vector<ObjectPair> added_;     // to those that stayed: they began in the last update
  std::vector<std::size_t> removed_;  // positions in those that stayed
  ListEdit<ObjectPair> stayed_;
};

}  // namespace detail
}  // namespace graze
