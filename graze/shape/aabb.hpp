// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {

/// An axis-aligned box: all x with min <= x <= max in every coordinate. Flat boxes (min == max in some coordinate) are
/// valid. Bounds of unbounded shapes have infinite corners; bounds of nothing have min = +infinity and max = -infinity.
/// All comparisons below accept both, but as shapes neither is valid (`is_valid`).
template <Dim N, class T = float>
struct Aabb {
  Vec<N, T> min = Vec<N, T>(T(-1));  ///< Least coordinates; at most `max` in each.
  Vec<N, T> max = Vec<N, T>(T(1));   ///< Greatest coordinates.

  /// The box with this center; each half extent must be at least zero.
  static Aabb from_center(const Vec<N, T>& center, const Vec<N, T>& half_extents) {
    return {center - half_extents, center + half_extents};
  }

  /// The box with two opposite corners, in any order.
  static Aabb from_corners(const Vec<N, T>& a, const Vec<N, T>& b) {
    Aabb box{a, a};
    box.grow(b);
    return box;
  }

  /// The empty box: min = +infinity, max = -infinity. `grow` starts from it.
  static Aabb nothing() {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    return {Vec<N, T>(infinity), Vec<N, T>(-infinity)};
  }

  /// The unbounded box: min = -infinity, max = +infinity.
  static Aabb everything() {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    return {Vec<N, T>(-infinity), Vec<N, T>(infinity)};
  }

  /// The midpoint, rounded. Both corners are halved before they are added, so that no finite box overflows.
  Vec<N, T> center() const { return min * T(0.5) + max * T(0.5); }
  /// Half the size along each axis, rounded; no finite box overflows.
  Vec<N, T> half_extents() const { return max * T(0.5) - min * T(0.5); }

  /// Extends the box to contain a point. NaN coordinates are ignored.
  void grow(const Vec<N, T>& point) {
    for (Dim i = 0; i < N; ++i) {
      if (point[i] < min[i]) min[i] = point[i];
      if (point[i] > max[i]) max[i] = point[i];
    }
  }

  /// Extends the box to contain another one. NaN coordinates are ignored.
  void grow(const Aabb& other) {
    for (Dim i = 0; i < N; ++i) {
      if (other.min[i] < min[i]) min[i] = other.min[i];
      if (other.max[i] > max[i]) max[i] = other.max[i];
    }
  }

  friend bool operator==(const Aabb&, const Aabb&) = default;
};

/// The axis-aligned rectangle: a 2D Aabb.
template <class T = float>
using Rect = Aabb<2, T>;

/// The corner that is farthest along `direction` (any nonzero length), in double. Exact. Where the direction has a zero
/// coordinate, min's is taken.
template <Dim N, class T>
Vec<N, double> support(const Aabb<N, T>& box, const std::type_identity_t<Vec<N, double>>& direction) {
  Vec<N, double> corner;
  for (Dim i = 0; i < N; ++i) corner[i] = static_cast<double>(direction[i] > 0 ? box.max[i] : box.min[i]);
  return corner;
}

/// True if the box contains no point: its min is above its max in some coordinate.
template <Dim N, class T>
bool is_nothing(const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    if (box.min[i] > box.max[i]) return true;
  }
  return false;
}

namespace detail {
template <Dim N, class T>
inline constexpr auto description_of<Aabb<N, T>> = Description("aabb", field::point("min", &Aabb<N, T>::min),
                                                               field::point("max", &Aabb<N, T>::max));
}  // namespace detail

/// Empty for valid values. Otherwise the first fault, worded as the rest of a sentence: a coordinate that is not
/// finite, or a min above its max.
template <Dim N, class T>
std::string_view defect(const Aabb<N, T>& box) {
  if (const std::string_view found = detail::defect_of_fields(box); !found.empty()) return found;
  return is_nothing(box) ? "has a min above its max" : "";
}

/// True if two boxes share a point; touching counts. Exact. False if a coordinate is NaN. Neither box may be
/// `is_nothing`.
template <Dim N, class T>
bool boxes_overlap(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  for (Dim i = 0; i < N; ++i) {
    if (!(a.min[i] <= b.max[i] && b.min[i] <= a.max[i])) return false;
  }
  return true;
}

}  // namespace graze
