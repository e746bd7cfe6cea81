// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace graze::io {

/// Reduces a failing list by delta debugging (Zeller and Hildebrandt 2002): tries parts of the list and their
/// complements, first halves, finally single items. `still_fails(items)` returns the items that were used when the
/// failure occurred (all or some of its input), or none if it did not fail. No single item can be removed from the
/// result. The initial items must fail; their order is kept.
template <class Item, class StillFails>
std::vector<Item> ddmin(std::vector<Item> items, const StillFails& still_fails) {
  std::size_t parts = 2;
  const auto piece = [&](std::size_t part, bool is_complement) {
    const std::size_t first = part * items.size() / parts;
    const std::size_t last = (part + 1) * items.size() / parts;
    std::vector<Item> result;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if ((first <= i && i < last) != is_complement) result.push_back(items[i]);
    }
    return result;
  };
  const auto try_all = [&](bool is_complement) {
    for (std::size_t part = 0; part < parts; ++part) {
      std::optional<std::vector<Item>> failing = still_fails(piece(part, is_complement));
      if (!failing) continue;
      items = *std::move(failing);
      return true;
    }
    return false;
  };
  while (items.size() > 1) {
    parts = std::min(parts, items.size());
    if (try_all(false)) {
      parts = 2;
    } else if (parts > 2 && try_all(true)) {  // with two parts, each is the complement of the other
      parts = std::max<std::size_t>(parts - 1, 2);
    } else if (parts == items.size()) {
      break;
    } else {
      parts = 2 * parts;
    }
  }
  return items;
}

}  // namespace graze::io
