// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/list_edit.hpp>

namespace graze {

/// How the touching pairs changed between two updates of a scene; each list is ascending. If an object of a touching
/// pair was removed, the pair has ended, and its id no longer names an object.
struct SceneEvents {
  std::vector<ObjectPair> began;   ///< Pairs that touch now and did not before.
  std::vector<ObjectPair> stayed;  ///< Pairs that touched before and still do.
  std::vector<ObjectPair> ended;   ///< Pairs that touched before and do not now.
};

/// The events between two ascending lists of pairs, neither with duplicates.
GRAZE_EXPORT SceneEvents events_between(const std::vector<ObjectPair>& before, const std::vector<ObjectPair>& after);

namespace detail {

/// The pairs that touched when these events were found, ascending: those that began and those that stayed.
GRAZE_EXPORT std::vector<ObjectPair> pairs_of(const SceneEvents& events);

/// Whether the objects in the slots are known to be those of the last update.
enum class SlotReuse : std::uint8_t { the_same, maybe_others };

/// For each of the pairs that touched when events were found, ascending: 1 if it began then, else 0.
using YoungMarks = BlankVector<char>;

/// Events under construction in the memory of older ones.
struct NextEvents {
  SceneEvents events;
  YoungMarks young;
};

/// What touches now and what did at the last update, among the pairs of a list that could touch.
struct ListedPairs {
  std::span<const Pair> found;                   ///< Touching now, ascending.
  std::span<const std::uint32_t> places;         ///< Their positions in the list.
  std::span<const std::uint32_t> places_before;  ///< Positions of those that touched at the last update.
  const char* touches;                           ///< By position: 1 if it touches now, else 0.
  const char* touched;                           ///< By position: 1 if it touched at the last update, else 0.
};

/// The events between the pairs of the last update and those that touch now, given as ascending pairs of slots.
GRAZE_EXPORT void find_events(const SceneEvents& last, std::span<const Pair> found, const KeyTable& ids,
                              SlotReuse slot_reuse, NextEvents& next);

/// The same by a list of pairs, if each slot has had one object. `young` belongs to the last events.
GRAZE_EXPORT void find_events(const SceneEvents& last, const YoungMarks& young, const ListedPairs& pairs,
                              const KeyTable& ids, NextEvents& next);

/// Turns the events of the last update into the next ones if few pairs begin and end. Keeps its memory.
class EventsEdit {
 public:
  /// Plans an edit: these pairs of slots have begun, and these of the last ones ended, both ascending. A pair is in
  /// both if the objects in its slots have changed.
  void plan(const SceneEvents& last, std::span<const Pair> began, std::span<const Pair> ended, const KeyTable& ids);

  /// Reserves memory in the events that `plan` was called for, so that `apply` cannot fail.
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
