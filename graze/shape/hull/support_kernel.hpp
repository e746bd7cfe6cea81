// SPDX-License-Identifier: MIT
// Finds the highest of some heights and its index, in vectors of two, four or eight numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <graze/math/platform/has_lanes.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Vector types with two, four or eight lanes.
template <std::size_t lanes>
struct LaneTypes;

template <>
struct LaneTypes<2> {
  using Doubles = double __attribute__((vector_size(16)));
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  using Floats = float __attribute__((vector_size(8)));
};
template <>
struct LaneTypes<4> {
  using Doubles = double __attribute__((vector_size(32)));
  using Bits = std::uint64_t __attribute__((vector_size(32)));
  using Floats = float __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<8> {
  using Doubles = double __attribute__((vector_size(64)));
  using Bits = std::uint64_t __attribute__((vector_size(64)));
  using Floats = float __attribute__((vector_size(32)));
};

/// `count` heights with indices, in vectors of this many lanes; all widths give the same answers. Everything is always
/// inlined and passed by reference, to be compiled for the caller's target. Indices are stored as doubles, because GCC
/// 12 compiles a selection between integer vectors by a comparison of doubles lane by lane.
template <std::size_t count, std::size_t lanes>
struct PlacedHeights {
  using Numbers = typename LaneTypes<lanes>::Doubles;
  static constexpr std::size_t parts = count / lanes;

  Numbers height[parts];
  Numbers place[parts];

  /// Per lane, takes the higher; of two equal ones the earlier.
  [[gnu::always_inline]] void meet_later(const PlacedHeights& later) {
    for (std::size_t i = 0; i < parts; ++i) {
      place[i] = later.height[i] > height[i] ? later.place[i] : place[i];
      // A separate maximum, because GCC would wait for the result of the comparison.
      height[i] = height[i] > later.height[i] ? height[i] : later.height[i];
    }
  }

  /// Per lane, takes the higher; of two equal ones the one with the smaller index.
  [[gnu::always_inline]] void meet(const PlacedHeights& other) {
    for (std::size_t i = 0; i < parts; ++i) {
      const Numbers least = other.place[i] < place[i] ? other.place[i] : place[i];
      const Numbers of_higher = other.height[i] > height[i] ? other.place[i] : place[i];
      place[i] = other.height[i] == height[i] ? least : of_higher;
      height[i] = height[i] > other.height[i] ? height[i] : other.height[i];
    }
  }

  /// The index of the highest, the smallest of several; any index if some are NaN. Branch-free, because a branch would
  /// be mispredicted.
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

/// The largest lane of a vector, by halving.
template <std::size_t lanes>
[[gnu::always_inline]] inline double largest_of(const typename LaneTypes<lanes>::Doubles& numbers) {
  if constexpr (lanes == 2) {
    return numbers[1] > numbers[0] ? numbers[1] : numbers[0];
  } else {
    typename LaneTypes<lanes / 2>::Doubles low;
    typename LaneTypes<lanes / 2>::Doubles high;
    if constexpr (lanes == 8) {
      low = __builtin_shufflevector(numbers, numbers, 0, 1, 2, 3);
      high = __builtin_shufflevector(numbers, numbers, 4, 5, 6, 7);
    } else {
      low = __builtin_shufflevector(numbers, numbers, 0, 1);
      high = __builtin_shufflevector(numbers, numbers, 2, 3);
    }
    const typename LaneTypes<lanes / 2>::Doubles larger = high > low ? high : low;
    return largest_of<lanes / 2>(larger);
  }
}

/// The error of `lane_of_highest`: how far its height may be below the highest, relative to the larger magnitude of the
/// two.
inline constexpr double lane_of_highest_error = 8 * std::numeric_limits<double>::epsilon();

/// The lane of the highest of eight heights, up to `lane_of_highest_error`; any lane if some are NaN. The last bits of
/// each height are replaced by its lane number, so only a maximum is needed.
template <std::size_t lanes>
[[gnu::always_inline]] inline std::uint32_t lane_of_highest(
    const typename LaneTypes<lanes>::Doubles (&heights)[8 / lanes]) {
  using Numbers = typename LaneTypes<lanes>::Doubles;
  using Bits = typename LaneTypes<lanes>::Bits;
  static constexpr std::array<std::uint64_t, 8> numbers = {0, 1, 2, 3, 4, 5, 6, 7};
  Numbers largest{};
  for (std::size_t i = 0; i < 8 / lanes; ++i) {
    Bits own;
    std::memcpy(&own, numbers.data() + i * lanes, sizeof(own));
    const Numbers marked = reinterpret_cast<Numbers>((reinterpret_cast<Bits>(heights[i]) & ~std::uint64_t{7}) | own);
    largest = i == 0 ? marked : (marked > largest ? marked : largest);
  }
  const double last = largest_of<lanes>(largest);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &last, sizeof(bits));
  return static_cast<std::uint32_t>(bits & 7U);
}

}  // namespace graze::detail

#endif
