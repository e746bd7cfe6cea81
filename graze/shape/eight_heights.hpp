// SPDX-License-Identifier: MIT
// Some heights and the places that they are of, by vectors of two, four or eight numbers: which of them is the highest.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/math/has_lanes.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// So many numbers that are calculated with at once: two, four or eight.
template <std::size_t lanes>
struct LaneTypes;

template <>
struct LaneTypes<2> {
  using Doubles = double __attribute__((vector_size(16)));
  using Floats = float __attribute__((vector_size(8)));
};
template <>
struct LaneTypes<4> {
  using Doubles = double __attribute__((vector_size(32)));
  using Floats = float __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<8> {
  using Doubles = double __attribute__((vector_size(64)));
  using Floats = float __attribute__((vector_size(32)));
};

/// `count` heights in vectors of so many lanes: the same answers by all. All of it is always inline, and goes by
/// reference, to be compiled for the processor of who calls it. Places are doubles, too, because GCC 12 compiles a
/// choice between vectors of integers by a comparison of doubles to one for each lane.
template <std::size_t count, std::size_t lanes>
struct PlacedHeights {
  using Numbers = typename LaneTypes<lanes>::Doubles;
  static constexpr std::size_t parts = count / lanes;

  Numbers height[parts];
  Numbers place[parts];

  /// In each lane the higher; of two that are equal the one that was here first.
  [[gnu::always_inline]] void meet_later(const PlacedHeights& later) {
    for (std::size_t i = 0; i < parts; ++i) {
      place[i] = later.height[i] > height[i] ? later.place[i] : place[i];
      // Not by the same comparison, whose result GCC would wait for: as a maximum.
      height[i] = height[i] > later.height[i] ? height[i] : later.height[i];
    }
  }

  /// In each lane the higher; of two that are equal the one with the lesser place.
  [[gnu::always_inline]] void meet(const PlacedHeights& other) {
    for (std::size_t i = 0; i < parts; ++i) {
      const Numbers least = other.place[i] < place[i] ? other.place[i] : place[i];
      const Numbers of_higher = other.height[i] > height[i] ? other.place[i] : place[i];
      place[i] = other.height[i] == height[i] ? least : of_higher;
      height[i] = height[i] > other.height[i] ? height[i] : other.height[i];
    }
  }

  /// The place of the highest of all, of several the least; where some are NaN any of the places. Without a branch,
  /// which would be guessed wrong.
  [[gnu::always_inline]] std::uint32_t highest() const {
    if constexpr (count == 2) {
      PlacedHeights exchanged;
      exchanged.height[0] = __builtin_shufflevector(height[0], height[0], 1, 0);
      exchanged.place[0] = __builtin_shufflevector(place[0], place[0], 1, 0);
      PlacedHeights both = *this;
      both.meet(exchanged);
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(both.place[0][0]));
    } else {
      PlacedHeights<count / 2, (parts > 1 ? lanes : lanes / 2)> low;
      PlacedHeights<count / 2, (parts > 1 ? lanes : lanes / 2)> high;
      for (std::size_t i = 0; i < low.parts; ++i) {
        if constexpr (parts > 1) {
          low.height[i] = height[i];
          low.place[i] = place[i];
          high.height[i] = height[i + low.parts];
          high.place[i] = place[i + low.parts];
        } else if constexpr (lanes == 8) {
          low.height[i] = __builtin_shufflevector(height[0], height[0], 0, 1, 2, 3);
          low.place[i] = __builtin_shufflevector(place[0], place[0], 0, 1, 2, 3);
          high.height[i] = __builtin_shufflevector(height[0], height[0], 4, 5, 6, 7);
          high.place[i] = __builtin_shufflevector(place[0], place[0], 4, 5, 6, 7);
        } else {
          low.height[i] = __builtin_shufflevector(height[0], height[0], 0, 1);
          low.place[i] = __builtin_shufflevector(place[0], place[0], 0, 1);
          high.height[i] = __builtin_shufflevector(height[0], height[0], 2, 3);
          high.place[i] = __builtin_shufflevector(place[0], place[0], 2, 3);
        }
      }
      low.meet(high);
      return low.highest();
    }
  }
};

}  // namespace graze::detail

#endif
