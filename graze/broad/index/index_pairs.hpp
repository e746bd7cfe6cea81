// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/spatial_index.hpp>

namespace graze::detail {

/// SpatialIndex::pairs by the batch method, which is faster than a walk through any tree. `box_of(slot)` returns the
/// box of an occupied slot. Holds all pairs in memory while visiting them.
template <class BoxOf, class Visit>
void visit_index_pairs(const KeyTable& keys, const BoxOf& box_of, Visit& visit) {
  std::vector<std::decay_t<std::invoke_result_t<const BoxOf&, std::uint32_t>>> boxes;
  std::vector<std::uint32_t> slots;
  boxes.reserve(keys.size());
  slots.reserve(keys.size());
  for (std::uint32_t slot = 0; slot < keys.slots(); ++slot) {
    if (!keys.is_taken(slot)) continue;
    boxes.push_back(box_of(slot));
    slots.push_back(slot);
  }
  GuardedVisit guarded(visit, keys);
  for (const Pair& pair : overlapping_pairs(boxes)) {
    if (!guarded(keys.key_of(slots[pair.a]), keys.key_of(slots[pair.b]))) return;
  }
}

}  // namespace graze::detail
