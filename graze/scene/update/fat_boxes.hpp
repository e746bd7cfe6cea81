// SPDX-License-Identifier: MIT
// Boxes grown by a margin, and by what touching may forgive, all at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Contains the box: a difference of floats is rounded, but not to the other side of one of them.
template <Dim N, class T>
Aabb<N, T> fat_box_around(const Aabb<N, T>& box, T margin) {
  return {box.min - margin, box.max + margin};
}

/// Writes a room around each box, and what touching_bounds makes of it. Returns the largest finite coordinate of a
/// room, without its sign.
template <Dim N, class T>
T make_fat_boxes(const Aabb<N, T>* boxes, std::size_t count, T margin, Aabb<N, T>* fat_boxes, Aabb<N, T>* reaches) {
  T largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    fat_boxes[i] = reaches[i] = fat_box_around(boxes[i], margin);
    largest = std::max(largest, grow_for_touching(reaches[i]));
  }
  return largest;
}

#ifdef GRAZE_HAS_LANES

/// So many boxes of floats, four numbers at a time. What is the same in each four is which of them are of a min.
template <Dim N>
class FatBoxesOfBlock {
 public:
  static constexpr std::size_t count = 16;

  explicit FatBoxesOfBlock(float margin) {
    for (std::size_t k = 0; k < period; ++k) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const bool is_of_min = (k * lanes + lane) / N % 2 == 0;
        margins_[k][lane] = is_of_min ? -margin : margin;
        steps_[k][lane] = is_of_min ? -1 : 1;
      }
    }
  }

  /// Writes rooms, and from them what they reach by a step of the bits of each number. Returns whether that is what
  /// grow_for_touching does with each of them, as it does where no number is far smaller than another of the block.
  bool make(const Aabb<N, float>* boxes, Aabb<N, float>* fat_boxes, Aabb<N, float>* reaches, float& largest) const {
    Lanes near_zero = Lanes{} + std::numeric_limits<float>::max();
    Lanes size = {};
    for (std::size_t k = 0; k < count * 2 * N / lanes; ++k) {
      const std::size_t at = k * lanes;
      const Lanes room = four_at(&boxes->min.x + at) + margins_[k % period];
      const LaneBits bits = bit_cast<LaneBits>(room);
      const LaneBits is_negative = bits >> 31;
      const LaneBits reach = bits + ((steps_[k % period] ^ is_negative) - is_negative);
      std::memcpy(&fat_boxes->min.x + at, &room, sizeof room);
      std::memcpy(&reaches->min.x + at, &reach, sizeof reach);
      near_zero = smaller(magnitude(room), near_zero);
      size = larger(magnitude(room), size);
    }
    const float least = std::min(smallest_of_three(near_zero), near_zero[3]);
    const float most = std::max(largest_of_three(size), size[3]);
    if (!is_slack_within_a_step(least, most)) return false;
    largest = std::max(largest, most);
    return true;
  }

 private:
  static constexpr std::size_t lanes = 4;
  static constexpr std::size_t period = N == 3 ? 3 : 1;

  Lanes margins_[period];
  LaneBits steps_[period];
};

template <Dim N>
float make_fat_boxes(const Aabb<N, float>* boxes, std::size_t count, float margin, Aabb<N, float>* fat_boxes,
                     Aabb<N, float>* reaches) {
  const FatBoxesOfBlock<N> block(margin);
  float largest = 0;
  std::size_t i = 0;
  for (; i + block.count <= count; i += block.count) {
    if (block.make(boxes + i, fat_boxes + i, reaches + i, largest)) continue;
    largest = std::max(largest, make_fat_boxes<N, float>(boxes + i, block.count, margin, fat_boxes + i, reaches + i));
  }
  return std::max(largest, make_fat_boxes<N, float>(boxes + i, count - i, margin, fat_boxes + i, reaches + i));
}

#endif

}  // namespace graze::detail
