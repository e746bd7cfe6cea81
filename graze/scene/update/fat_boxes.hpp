// SPDX-License-Identifier: MIT
// Enlarges many boxes at once by a margin, and by the tolerance of touching.
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

/// Contains the box: the rounding of a difference never passes an operand.
template <Dim N, class T>
Aabb<N, T> fat_box_around(const Aabb<N, T>& box, T margin) {
  return {box.min - margin, box.max + margin};
}

/// Writes the fat box of each box, and its touching_bounds. Returns the largest magnitude of the finite coordinates of
/// fat boxes.
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

/// A block of float boxes, four numbers at a time. Which lanes belong to a min repeats periodically.
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

  /// Writes fat boxes, and their touching bounds by incrementing the bits of each number. Returns whether that equals
  /// grow_for_touching, as it does unless a number is far smaller than another of the block.
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
