// SPDX-License-Identifier: MIT
// Selects four of many corners of a face over a face: SpanningChoice of manifold_points.hpp in float, all corners at
// once, because branches on which corner is better are mispredicted.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// A number for each corner, indexed by the line that starts there; three more as padding.
struct CornerLanes {
  Lanes four[3];

  float operator[](std::size_t i) const { return four[i / 4][i % 4]; }
};

/// Corners are relative to the first one, in units of the longer half edge of the incident face: float is accurate to a
/// hundredth of the difference that SpanningChoice treats as equal.
class LaneChoice {
 public:
  [[gnu::always_inline]] LaneChoice(const FaceOverFace& over, const PairedVec& normal, bool on_incident)
      : left_(over.left()), first_(over.first()) {
    const BoxFace& face = over.incident();
    const LanePair climb = over.climb();
    const double longest = std::max(dot(face.right, face.right), dot(face.up, face.up));
    const double down = -1 / std::sqrt(longest);
    const double scale = down * down;
    // Points on the reference face have no height; points on the incident face are equally far apart with theirs.
    const LanePair flat = on_incident ? LanePair{0, 0} : climb;
    xx_ = static_cast<float>((dot(face.right, face.right) - flat[0] * flat[0]) * scale);
    yy_ = static_cast<float>((dot(face.up, face.up) - flat[1] * flat[1]) * scale);
    xy_ = static_cast<float>(2 * (dot(face.right, face.up) - flat[0] * flat[1]) * scale);
    area_ = static_cast<float>(dot(cross(face.right, face.up), normal) * scale);
    const LanePair sink = climb * down;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      place_four(over, 4 * i, i);
      depth_.four[i] = x_.four[i] * static_cast<float>(sink[0]) + y_.four[i] * static_cast<float>(sink[1]);
    }
  }

  /// As bits, by the lines that start there.
  [[gnu::always_inline]] unsigned run() const {
    const auto equal = static_cast<float>(tolerance::aligned);
    const CornerLanes from_first = squared_from(first_);
    const float squared = largest(from_first);
    const std::size_t start = best(depth_, equal * std::sqrt(squared));
    const std::size_t end = best(squared_from(start), equal * squared);
    CornerLanes area;
    CornerLanes opposite;
    const float way_x = (x_[end] - x_[start]) * area_;
    const float way_y = (y_[end] - y_[start]) * area_;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      area.four[i] = way_x * (y_.four[i] - y_[start]) - way_y * (x_.four[i] - x_[start]);
      opposite.four[i] = -area.four[i];
    }
    return 1U << start | 1U << end | 1U << best(area, equal * squared) | 1U << best(opposite, equal * squared);
  }

 private:
  /// A missing corner is replaced by the first one, which is never better than itself.
  [[gnu::always_inline]] void place_four(const FaceOverFace& over, std::size_t first, std::size_t four) {
    using Four = double __attribute__((vector_size(32)));  // in two registers
    const LanePair origin = over.within(first_);
    const auto seen = [&](std::size_t line) { return over.within((left_ >> line & 1U) != 0 ? line : first_) - origin; };
    const auto both = [&](std::size_t i) {
      const Four places = __builtin_shufflevector(seen(i), seen(i + 1), 0, 1, 2, 3);
      return __builtin_convertvector(places, Lanes);
    };
    const Lanes low = both(first);
    const Lanes high = both(first + 2);
    x_.four[four] = __builtin_shufflevector(low, high, 0, 2, 4, 6);
    y_.four[four] = __builtin_shufflevector(low, high, 1, 3, 5, 7);
  }

  [[gnu::always_inline]] CornerLanes squared_from(std::size_t start) const {
    CornerLanes result;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes x = x_.four[i] - x_[start];
      const Lanes y = y_.four[i] - y_[start];
      result.four[i] = x * x * xx_ + (y * y * yy_ + x * y * xy_);
    }
    return result;
  }

  [[gnu::always_inline]] static float largest(const CornerLanes& values) {
    const Lanes four = larger(values.four[0], larger(values.four[1], values.four[2]));
    const Lanes two = larger(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    return std::max(two[0], two[1]);
  }

  /// As in SpanningChoice: the first, unless a later one is better by more than the slack, and so on.
  [[gnu::always_inline]] std::size_t best(const CornerLanes& values, float slack) const {
    const float least = largest(values) - slack;
    LaneBits bits = {1, 2, 4, 8};
    LaneBits chosen = {0, 0, 0, 0};
#pragma GCC unroll 3
    for (const Lanes four : values.four) {
      chosen |= (four >= least) & bits;
      bits *= 16;
    }
    const LaneBits two = chosen | __builtin_shufflevector(chosen, chosen, 2, 3, 0, 1);
    const auto good = static_cast<unsigned>(two[0] | two[1]) & left_;
    if (good != 0 && ((good >> first_ & 1U) != 0 || (good & (good - 1)) == 0)) [[likely]]
      return static_cast<std::size_t>(std::countr_zero(good));
    return best_in_turn(values, slack);
  }

  [[gnu::noinline]] std::size_t best_in_turn(const CornerLanes& values, float slack) const {
    std::size_t best = first_;
    for (unsigned rest = left_; rest != 0; rest &= rest - 1) {
      const auto line = static_cast<std::size_t>(std::countr_zero(rest));
      if (values[line] > values[best] + slack) best = line;
    }
    return best;
  }

  unsigned left_;  ///< The lines on which sides start, as bits; and the first of them.
  std::size_t first_;
  float xx_, yy_, xy_;  ///< The squared length of x * right + y * up is xx * x * x + yy * y * y + xy * x * y.
  float area_;          ///< The area of the rectangle of right and up, projected along the normal.
  CornerLanes x_, y_, depth_;
};

}  // namespace graze::detail
#endif
