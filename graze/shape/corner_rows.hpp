// SPDX-License-Identifier: MIT
// CornerRows(corners): the corners of a polytope once more, coordinate by coordinate, to be searched.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include <graze/math/has_lanes.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

#ifdef GRAZE_HAS_LANES
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
#endif

/// At least one corner. To search them takes no branch for each, which would be guessed wrong every few corners, and
/// longer than all products together: heights are calculated a block at a time, and only a block that has the highest
/// one so far is asked where that is. By the widest vectors that the processor has; the answer is the same by all.
template <Dim N, class T>
class CornerRows {
 public:
  explicit CornerRows(std::span<const Vec<N, T>> corners)
      : length_((corners.size() + together - 1) / together * together) {
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

  /// Of all corners: somewhere inside.
  const Vec<N, double>& middle() const { return middle_; }
  /// The largest coordinate, without its sign.
  double largest() const { return largest_; }

  /// The place of the corner that is farthest in a direction, of several the first; calculated in double.
  std::uint32_t farthest(const Vec<N, double>& direction) const {
#ifdef GRAZE_HAS_WIDER_LANES
    if (length_ > few) {
      if (__builtin_cpu_supports("avx512f")) return farthest_by_eight(direction);
      if (__builtin_cpu_supports("avx2")) return farthest_by_four(direction);
    }
#endif
    return farthest_by_two(direction);
  }

  // The same by so many heights at once, for processors that can.

  std::uint32_t farthest_by_two(const Vec<N, double>& direction) const { return search<2>(direction); }
#ifdef GRAZE_HAS_WIDER_LANES
  [[gnu::target("avx2")]] std::uint32_t farthest_by_four(const Vec<N, double>& direction) const {
    return search<4>(direction);
  }
  [[gnu::target("avx512f")]] std::uint32_t farthest_by_eight(const Vec<N, double>& direction) const {
    return search<8>(direction);
  }
#endif

 private:
  static constexpr std::size_t together = 8;
  static constexpr std::size_t few = 8;  ///< So few that it takes longer to call for wider vectors.
  static constexpr std::size_t block = 64;
  using Heights = std::array<double, block>;

  /// With so many at once. Always inline, as all that it calls, to be compiled for the processor of who calls it.
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
    // Behind the last corner stands the first.
    return static_cast<std::uint32_t>(place < length_ ? place : 0);
  }

#ifdef GRAZE_HAS_LANES
  template <std::size_t lanes>
  using Numbers = typename LaneTypes<lanes>::Doubles;
  template <std::size_t lanes>
  using Stored = std::conditional_t<std::is_same_v<T, double>, Numbers<lanes>, typename LaneTypes<lanes>::Floats>;

  /// The heights of some corners, and the largest of them.
  template <std::size_t lanes>
  [[gnu::always_inline]] double lift(std::size_t from, std::size_t count, const Vec<N, double>& direction,
                                     Heights& heights) const {
    Numbers<lanes> largest{};
    for (std::size_t i = 0; i < count; i += lanes) {
      Numbers<lanes> height{};
      for (Dim k = 0; k < N; ++k) {
        Stored<lanes> stored;
        std::memcpy(&stored, numbers_.data() + static_cast<std::size_t>(k) * length_ + from + i, sizeof(stored));
        const Numbers<lanes> part = __builtin_convertvector(stored, Numbers<lanes>) * direction[k];
        height = k == 0 ? part : height + part;
      }
      std::memcpy(heights.data() + i, &height, sizeof(height));
      largest = i == 0 ? height : (height > largest ? height : largest);
    }
    return largest_in<lanes>(&largest);
  }

  /// The first place of a height; without a branch, whose end would be guessed wrong. Of what is no number, `count`.
  template <std::size_t lanes>
  [[gnu::always_inline]] static std::size_t place_of(double height, const Heights& heights, std::size_t count) {
    // From a place to the end; of all places with that height the largest is looked for.
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
    return count - static_cast<std::size_t>(largest_in<lanes>(&largest));
  }

  /// By halves. By its address, since vectors that a processor may not have cannot be handed over.
  template <std::size_t lanes>
  [[gnu::always_inline]] static double largest_in(const Numbers<lanes>* numbers) {
    if constexpr (lanes == 2) {
      return (*numbers)[1] > (*numbers)[0] ? (*numbers)[1] : (*numbers)[0];
    } else {
      Numbers<lanes / 2> halves[2];
      std::memcpy(&halves, numbers, sizeof(halves));
      const Numbers<lanes / 2> larger = halves[1] > halves[0] ? halves[1] : halves[0];
      return largest_in<lanes / 2>(&larger);
    }
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

  std::size_t length_;  ///< Of a row: a multiple of `together`.
  std::vector<T> numbers_;
  Vec<N, double> middle_;
  double largest_ = 0;
};

}  // namespace graze::detail
