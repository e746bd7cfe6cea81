// SPDX-License-Identifier: MIT
// CornerRows(corners): a copy of a polytope's corners, one row per coordinate, for searching.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/math/platform/has_lanes.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/support_kernel.hpp>

namespace graze::detail {

/// At least one corner. The search has no branch per corner, since its mispredictions would cost more than all
/// products. With two or four lanes, heights are calculated block by block, and only a block with a new maximum is
/// searched for its index; with eight lanes, heights are compared together with their indices. The widest vectors of
/// the processor are used; all give the same answer.
template <Dim N, class T>
class CornerRows {
 public:
  explicit CornerRows(std::span<const Vec<N, T>> corners)
      : count_(corners.size()), length_((corners.size() + together - 1) / together * together) {
    numbers_.reserve(static_cast<std::size_t>(N) * length_);
    for (Dim k = 0; k < N; ++k) {
      double sum = 0;
      for (const Vec<N, T>& corner : corners) {
        numbers_.push_back(corner[k]);
        sum += static_cast<double>(corner[k]);
        largest_ = std::max(largest_, std::fabs(static_cast<double>(corner[k])));
      }
      numbers_.resize(static_cast<std::size_t>(k + 1) * length_, corners.front()[k]);
      middle_[k] = sum / static_cast<double>(corners.size());
    }
  }

  /// The mean of all corners: a point inside.
  const Vec<N, double>& middle() const { return middle_; }
  /// The largest magnitude of a coordinate.
  double largest() const { return largest_; }

  std::size_t size() const { return count_; }
  /// The length of each row, a multiple of eight: padding repeats the first corner.
  std::size_t length() const { return length_; }

#ifdef GRAZE_HAS_LANES
  /// Reads consecutive coordinates of a row, starting at one corner.
  template <std::size_t lanes>
  [[gnu::always_inline]] void read(Dim k, std::size_t from, typename LaneTypes<lanes>::Doubles& numbers) const {
    Stored<lanes> stored;
    std::memcpy(&stored, numbers_.data() + static_cast<std::size_t>(k) * length_ + from, sizeof(stored));
    numbers = __builtin_convertvector(stored, typename LaneTypes<lanes>::Doubles);
  }
#endif

  /// The index of the corner farthest in a direction, the first of several; calculated in double.
  std::uint32_t farthest(const Vec<N, double>& direction) const {
#ifdef GRAZE_HAS_WIDER_LANES
    if (length_ > few) {
      if (__builtin_cpu_supports("avx512f")) return farthest_by_eight(direction);
      if (__builtin_cpu_supports("avx2")) return farthest_by_four(direction);
    }
#endif
    return farthest_by_two(direction);
  }

  // The same with a given number of lanes, for processors that support it.

  std::uint32_t farthest_by_two(const Vec<N, double>& direction) const { return search<2>(direction); }
#ifdef GRAZE_HAS_WIDER_LANES
  [[gnu::target("avx2")]] std::uint32_t farthest_by_four(const Vec<N, double>& direction) const {
    return search<4>(direction);
  }
  [[gnu::target("avx512f")]] std::uint32_t farthest_by_eight(const Vec<N, double>& direction) const {
    return search_by_eight(direction);
  }
#endif

  template <std::size_t lanes>
  std::uint32_t farthest_by(const Vec<N, double>& direction) const {
#ifdef GRAZE_HAS_WIDER_LANES
    if constexpr (lanes == 8) return farthest_by_eight(direction);
    if constexpr (lanes == 4) return farthest_by_four(direction);
#endif
    return farthest_by_two(direction);
  }

 private:
#ifdef GRAZE_HAS_LANES
  template <std::size_t lanes>
  using Numbers = typename LaneTypes<lanes>::Doubles;
  template <std::size_t lanes>
  using Stored = std::conditional_t<std::is_same_v<T, double>, Numbers<lanes>, typename LaneTypes<lanes>::Floats>;
#endif
  static constexpr std::size_t together = 8;
  static constexpr std::size_t few = 8;  ///< Up to this length, calling the wider version costs more than it saves.
  static constexpr std::size_t block = 64;
  using Heights = std::array<double, block>;

  /// Searches with this number of lanes. Always inlined, like everything it calls, to be compiled for the caller's
  /// target.
  template <std::size_t lanes>
  [[gnu::always_inline]] std::uint32_t search(const Vec<N, double>& direction) const {
    alignas(64) Heights heights;
    double highest = 0;
    std::size_t place = 0;
    for (std::size_t from = 0; from < length_; from += block) {
      const std::size_t count = block < length_ - from ? block : length_ - from;
      const double found = lift<lanes>(from, count, direction, heights);
      if (from > 0 && !(found > highest)) continue;
      highest = found;
      place = from + place_of<lanes>(highest, heights, count);
    }
    // Padding repeats the first corner.
    return static_cast<std::uint32_t>(place < length_ ? place : 0);
  }

#ifdef GRAZE_HAS_WIDER_LANES
  /// Alternates between two sets of accumulators, so that neither waits for the other.
  [[gnu::always_inline]] std::uint32_t search_by_eight(const Vec<N, double>& direction) const {
    constexpr double low = -std::numeric_limits<double>::infinity();
    PlacedHeights<8, 8> even{{{low, low, low, low, low, low, low, low}}, {{0, 0, 0, 0, 0, 0, 0, 0}}};
    PlacedHeights<8, 8> odd = even;
    PlacedHeights<8, 8> next{{}, {{0, 1, 2, 3, 4, 5, 6, 7}}};
    std::size_t i = 0;
    for (; i + 8 < length_; i += 16) {
      lift_eight(i, direction, next.height[0]);
      even.meet_later(next);
      lift_eight(i + 8, direction, next.height[0]);
      odd.meet_later(next);
      next.place[0] += 16.0;
    }
    odd.place[0] += 8.0;
    if (i < length_) {
      lift_eight(i, direction, next.height[0]);
      even.meet_later(next);
    }
    even.meet(odd);
    // Padding repeats the first corner.
    const std::uint32_t place = even.highest();
    return place < count_ ? place : 0;
  }

  [[gnu::always_inline]] void lift_eight(std::size_t from, const Vec<N, double>& direction, Numbers<8>& height) const {
    Numbers<8> row;
    read<8>(0, from, row);
    height = row * direction[0];
    for (Dim k = 1; k < N; ++k) {
      read<8>(k, from, row);
      height += row * direction[k];
    }
  }
#endif

#ifdef GRAZE_HAS_LANES
  /// Calculates the heights of some corners and returns the largest.
  template <std::size_t lanes>
  [[gnu::always_inline]] double lift(std::size_t from, std::size_t count, const Vec<N, double>& direction,
                                     Heights& heights) const {
    Numbers<lanes> largest{};
    for (std::size_t i = 0; i < count; i += lanes) {
      Numbers<lanes> height{};
      for (Dim k = 0; k < N; ++k) {
        Numbers<lanes> row;
        read<lanes>(k, from + i, row);
        height = k == 0 ? row * direction[0] : height + row * direction[k];
      }
      std::memcpy(heights.data() + i, &height, sizeof(height));
      largest = i == 0 ? height : (height > largest ? height : largest);
    }
    return largest_of<lanes>(largest);
  }

  /// The first index of a height; branch-free, because the end of a loop would be mispredicted. Returns `count` for
  /// NaN.
  template <std::size_t lanes>
  [[gnu::always_inline]] static std::size_t place_of(double height, const Heights& heights, std::size_t count) {
    // Tracks the distance to the end: the largest distance belongs to the first index.
    static constexpr std::array<double, together> steps = {0, 1, 2, 3, 4, 5, 6, 7};
    Numbers<lanes> left;
    std::memcpy(&left, steps.data(), sizeof(left));
    left = static_cast<double>(count) - left;
    Numbers<lanes> largest{};
    for (std::size_t i = 0; i < count; i += lanes) {
      Numbers<lanes> at;
      std::memcpy(&at, heights.data() + i, sizeof(at));
      const Numbers<lanes> found = at == height ? left : Numbers<lanes>{};
      largest = found > largest ? found : largest;
      left -= static_cast<double>(lanes);
    }
    return count - static_cast<std::size_t>(largest_of<lanes>(largest));
  }
#else
  template <std::size_t>
  double lift(std::size_t from, std::size_t count, const Vec<N, double>& direction, Heights& heights) const {
    for (std::size_t i = 0; i < count; ++i) {
      heights[i] = static_cast<double>(numbers_[from + i]) * direction[0];
      for (Dim k = 1; k < N; ++k) {
        heights[i] += static_cast<double>(numbers_[static_cast<std::size_t>(k) * length_ + from + i]) * direction[k];
      }
    }
    return *std::max_element(heights.begin(), heights.begin() + count);
  }

  template <std::size_t>
  static std::size_t place_of(double height, const Heights& heights, std::size_t count) {
    return static_cast<std::size_t>(std::find(heights.begin(), heights.begin() + count, height) - heights.begin());
  }
#endif

  std::size_t count_;
  std::size_t length_;
  std::vector<T> numbers_;
  Vec<N, double> middle_;
  double largest_ = 0;
};

}  // namespace graze::detail
