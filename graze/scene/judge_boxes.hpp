// SPDX-License-Identifier: MIT
// The pairs of a scene that need no exact test, by how deep their boxes are in each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

#include <graze/broad/pair.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/lanes.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// How far one of two boxes has to go along an axis, that along which it is least, until they only touch; less than
/// zero where they are apart. Each difference is rounded once. Less than zero or NaN where one of them is
/// Aabb::nothing(), and NaN nowhere else.
template <Dim N, class T>
T depth_of(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  T depth = std::min(a.max[0] - b.min[0], b.max[0] - a.min[0]);
  for (Dim i = 1; i < N; ++i) depth = std::min(depth, std::min(a.max[i] - b.min[i], b.max[i] - a.min[i]));
  return depth;
}

#ifdef GRAZE_HAS_LANES

/// Four of that at once, of pairs in a row of boxes that is longer by one than the last that is named.
class FourDepths {
 public:
  static constexpr std::size_t count = 4;

  [[gnu::always_inline]] FourDepths(const Aabb<3, float>* boxes, const Pair* pairs) {
    const Lanes first = along_axes(boxes[pairs[0].a], boxes[pairs[0].b]);
    const Lanes second = along_axes(boxes[pairs[1].a], boxes[pairs[1].b]);
    const Lanes third = along_axes(boxes[pairs[2].a], boxes[pairs[2].b]);
    const Lanes fourth = along_axes(boxes[pairs[3].a], boxes[pairs[3].b]);
    const Lanes low = __builtin_shufflevector(first, second, 0, 4, 1, 5);
    const Lanes high = __builtin_shufflevector(third, fourth, 0, 4, 1, 5);
    const Lanes least =
        smaller(__builtin_shufflevector(low, high, 0, 1, 4, 5), __builtin_shufflevector(low, high, 2, 3, 6, 7));
    const Lanes low_z = __builtin_shufflevector(first, second, 2, 6, 3, 7);
    const Lanes high_z = __builtin_shufflevector(third, fourth, 2, 6, 3, 7);
    depths_ = smaller(least, __builtin_shufflevector(low_z, high_z, 0, 1, 4, 5));
  }

  [[gnu::always_inline]] FourDepths(const Aabb<2, float>* boxes, const Pair* pairs) {
    const Lanes first = between(boxes[pairs[0].a], boxes[pairs[0].b]);
    const Lanes second = between(boxes[pairs[1].a], boxes[pairs[1].b]);
    const Lanes third = between(boxes[pairs[2].a], boxes[pairs[2].b]);
    const Lanes fourth = between(boxes[pairs[3].a], boxes[pairs[3].b]);
    const Lanes low = __builtin_shufflevector(first, second, 0, 4, 1, 5);
    const Lanes high = __builtin_shufflevector(third, fourth, 0, 4, 1, 5);
    const Lanes low_way = __builtin_shufflevector(first, second, 2, 6, 3, 7);
    const Lanes high_way = __builtin_shufflevector(third, fourth, 2, 6, 3, 7);
    const Lanes one_way =
        smaller(__builtin_shufflevector(low, high, 0, 1, 4, 5), __builtin_shufflevector(low, high, 2, 3, 6, 7));
    const Lanes other_way = larger(__builtin_shufflevector(low_way, high_way, 0, 1, 4, 5),
                                   __builtin_shufflevector(low_way, high_way, 2, 3, 6, 7));
    depths_ = smaller(one_way, -other_way);
  }

  /// Which are above a number: 1 or 0 for each.
  [[gnu::always_inline]] LaneBits above(float number) const { return (depths_ > number) & 1; }
  /// Which are below a number, or NaN.
  [[gnu::always_inline]] LaneBits below(float number) const { return ~(depths_ >= number) & 1; }

 private:
  /// The fourth lane is of whatever comes next.
  [[gnu::always_inline]] static Lanes along_axes(const Aabb<3, float>& a, const Aabb<3, float>& b) {
    return smaller(four_at(&a.max.x) - four_at(&b.min.x), four_at(&b.max.x) - four_at(&a.min.x));
  }
  /// From a's min to b's max, and from a's max to b's min.
  [[gnu::always_inline]] static Lanes between(const Aabb<2, float>& a, const Aabb<2, float>& b) {
    const Lanes other = four_at(&b.min.x);
    return __builtin_shufflevector(other, other, 2, 3, 0, 1) - four_at(&a.min.x);
  }

  Lanes depths_;
};

#endif

/// Notes of each pair whether its boxes overlap by more than `certain`, and are the shapes themselves: then they touch.
/// Of the others lists those that are not as clearly apart, by their places, and returns how many. No branches on what
/// is found.
template <Dim N, class T, class AreBoxes>
// NOLINTNEXTLINE(readability-function-size): what it is told, and where it writes
std::size_t judge_bounds(const Aabb<N, T>* boxes, std::span<const Pair> pairs, T certain, const AreBoxes& are_boxes,
                         char* touches, std::size_t* open) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    prefetch(&boxes[pairs[std::min(i + prefetch_distance, pairs.size() - 1)].b]);
    const T depth = depth_of(boxes[pairs[i].a], boxes[pairs[i].b]);
    const unsigned is_deep = (depth > certain ? 1U : 0U) & (are_boxes(pairs[i]) ? 1U : 0U);
    const unsigned is_apart = depth >= -certain ? 0 : 1;  // NaN is of a box that contains nothing
    touches[i] = static_cast<char>(is_deep);
    open[count] = i;
    count += 1 - (is_deep | is_apart);
  }
  return count;
}

/// The same where all boxes are the shapes themselves.
template <Dim N, class T>
std::size_t judge_boxes(const Aabb<N, T>* boxes, std::span<const Pair> pairs, T certain, char* touches,
                        std::size_t* open) {
  return judge_bounds(
      boxes, pairs, certain, [](const Pair&) { return true; }, touches, open);
}

#ifdef GRAZE_HAS_LANES

/// By four. The row of boxes is longer by one than the last that is named.
template <Dim N>
std::size_t judge_boxes(const Aabb<N, float>* boxes, std::span<const Pair> pairs, float certain, char* touches,
                        std::size_t* open) {
  constexpr std::size_t four = FourDepths::count;
  using Bytes = char __attribute__((vector_size(four)));
  std::size_t count = 0;
  std::size_t i = 0;
  for (; i + four <= pairs.size(); i += four) {
    for (std::size_t k = i; k < i + four; ++k) {
      prefetch(&boxes[pairs[std::min(k + prefetch_distance, pairs.size() - 1)].b]);
    }
    const FourDepths depths(boxes, pairs.data() + i);
    const LaneBits deep = depths.above(certain);
    const auto bytes = __builtin_convertvector(deep, Bytes);
    std::memcpy(touches + i, &bytes, four);
    const LaneBits settled = deep | depths.below(-certain);
    if (settled[0] + settled[1] + settled[2] + settled[3] == four) continue;
    for (std::size_t k = 0; k < four; ++k) {
      open[count] = i + k;
      count += settled[static_cast<int>(k)] == 0 ? 1U : 0U;
    }
  }
  const std::size_t rest = judge_bounds(
      boxes, pairs.subspan(i), certain, [](const Pair&) { return true; }, touches + i, open + count);
  for (std::size_t k = count; k < count + rest; ++k) open[k] += i;
  return count + rest;
}

#endif

}  // namespace graze::detail
