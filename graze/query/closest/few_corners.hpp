// SPDX-License-Identifier: MIT
// FewCorners: the transformed corners of a small polytope, in rows for repeated searches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <graze/math/platform/has_lanes.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/corner_rows.hpp>
#include <graze/shape/hull/support_kernel.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Up to `room` corners. Transforming them takes longer than one search, but then neither direction nor corners need to
/// be rotated for each search. With any number of lanes, a branch-free search gives the same answers.
class FewCorners {
 public:
  static constexpr std::size_t room = 32;

  Vec<3, double> operator[](std::size_t i) const { return {rows_[0][i], rows_[1][i], rows_[2][i]}; }

  /// Rotates, then translates; every number is calculated as `rotation * corner + shift`.
  template <std::size_t lanes, class T>
  [[gnu::always_inline]] void put(const CornerRows<3, T>& rows, const Mat<3, double>& rotation,
                                  const Vec<3, double>& shift) {
    count_ = rows.size();
    length_ = rows.length();
    for (std::size_t i = 0; i < length_; i += lanes) {
      Numbers<lanes> x;
      Numbers<lanes> y;
      Numbers<lanes> z;
      rows.template read<lanes>(0, i, x);
      rows.template read<lanes>(1, i, y);
      rows.template read<lanes>(2, i, z);
      for (Dim k = 0; k < 3; ++k) {
        write<lanes>(k, i, rotation[0][k] * x + rotation[1][k] * y + rotation[2][k] * z + shift[k]);
      }
    }
  }

  /// Corners relative to a point.
  template <std::size_t lanes, class T>
  [[gnu::always_inline]] void put(const CornerRows<3, T>& rows, const Vec<3, double>& origin) {
    count_ = rows.size();
    length_ = rows.length();
    for (std::size_t i = 0; i < length_; i += lanes) {
      for (Dim k = 0; k < 3; ++k) {
        Numbers<lanes> numbers;
        rows.template read<lanes>(k, i, numbers);
        write<lanes>(k, i, numbers - origin[k]);
      }
    }
  }

  /// How much lower than the farthest corner the result may be, relative to its height.
  static constexpr double farthest_error = lane_of_highest_error;

  /// The index of the corner farthest in a direction, up to `farthest_error`; with more than eight corners exactly the
  /// farthest, the first of several. Along a direction that is not finite, any valid index below `room`.
  template <std::size_t lanes>
  [[gnu::always_inline]] std::uint32_t farthest(const Vec<3, double>& direction) const {
    static constexpr std::array<double, 8> first = {0, 1, 2, 3, 4, 5, 6, 7};
    PlacedHeights<8, lanes> best;
    std::memcpy(&best.place, first.data(), sizeof(best.place));
    lift<lanes>(0, direction, best);
    if (length_ == 8) {
      const std::uint32_t lane = lane_of_highest<lanes>(best.height);
      return lane < count_ ? lane : 0;
    }
    PlacedHeights<8, lanes> next = best;
    for (std::size_t i = 8; i < length_; i += 8) {
      lift<lanes>(i, direction, next);
      for (Numbers<lanes>& place : next.place) place += 8.0;
      best.meet_later(next);
    }
    return best.highest();
  }

 private:
  template <std::size_t lanes>
  using Numbers = typename LaneTypes<lanes>::Doubles;

  template <std::size_t lanes>
  [[gnu::always_inline]] void write(Dim k, std::size_t from, const Numbers<lanes>& numbers) {
    std::memcpy(rows_[static_cast<std::size_t>(k)].data() + from, &numbers, sizeof(numbers));
  }

  template <std::size_t lanes>
  [[gnu::always_inline]] void lift(std::size_t from, const Vec<3, double>& direction,
                                   PlacedHeights<8, lanes>& heights) const {
    for (std::size_t i = 0; i < heights.parts; ++i) {
      Numbers<lanes> x;
      Numbers<lanes> y;
      Numbers<lanes> z;
      std::memcpy(&x, rows_[0].data() + from + i * lanes, sizeof(x));
      std::memcpy(&y, rows_[1].data() + from + i * lanes, sizeof(y));
      std::memcpy(&z, rows_[2].data() + from + i * lanes, sizeof(z));
      heights.height[i] = x * direction[0] + y * direction[1] + z * direction[2];
    }
  }

  std::size_t count_ = 0;
  std::size_t length_ = 0;  ///< A multiple of eight: padding repeats the first corner.
  alignas(64) std::array<std::array<double, room>, 3> rows_;
};

}  // namespace graze::detail

#endif
