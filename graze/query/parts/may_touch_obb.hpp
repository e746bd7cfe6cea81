// SPDX-License-Identifier: MIT
// Which boxes and faces an oriented box may touch: those between its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/triangle_block.hpp>

namespace graze::detail {

#ifdef GRAZE_HAS_LANES

/// The layers of space between the opposite sides of an oriented box, and the box around it.
template <Dim N, class T>
struct LaneSides {
  Mat<N, T> axes;
  Vec<N, T> low;  ///< Along each axis.
  Vec<N, T> high;
  Aabb<N, T> box;
};

/// For boxes and faces in a box, each up to `error` away from where the oriented box sees it.
template <Dim N, class T>
LaneSides<N, T> lane_sides(const Obb<N, T>& obb, const Aabb<N, T>& grown, const Aabb<N, T>& around, double error) {
  constexpr double relative = 4 * (static_cast<double>(lane_slack<T>) + tolerance::box_slack);
  const double size = static_cast<double>(std::max(size_of_box(grown), size_of_box(around)));
  const Vec<N, double> halves = wide<N, T>(obb.half_extents);
  LaneSides<N, T> result{obb.axes, {}, {}, grown};
  const T largest =
      std::max({max_abs(obb.center), max_abs(obb.half_extents), max_abs(around.min), max_abs(around.max)});
  if (!(largest < std::numeric_limits<T>::max() / 16)) {  // sums may overflow: only the box decides
    result.low = Vec<N, T>(-std::numeric_limits<T>::infinity());
    result.high = Vec<N, T>(std::numeric_limits<T>::infinity());
    return result;
  }
  for (Dim k = 0; k < N; ++k) {
    const Vec<N, double> axis = wide<N, T>(obb.axes[k]);
    const double middle = dot(axis, wide<N, T>(obb.center));
    double reach = sum_abs(axis) * (N * relative * size + error) + 4 * tolerance::orthonormal * sum_abs(halves) +
                   16 * static_cast<double>(std::numeric_limits<T>::denorm_min());
    for (Dim i = 0; i < N; ++i) reach += std::fabs(dot(axis, wide<N, T>(obb.axes[i]))) * halves[i];
    result.low[k] = round_down<T>(middle - reach);
    result.high[k] = round_up<T>(middle + reach);
  }
  return result;
}

/// The lanes whose boxes are not beyond a side; lanes with NaN are among them.
template <Dim N, class T>
LaneMask lanes_between(const BoxBlock<N, T>& block, const LaneSides<N, T>& sides) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers gap = Numbers{} - 1;
    Numbers center[static_cast<std::size_t>(N)];
    Numbers half[static_cast<std::size_t>(N)];
    for (Dim i = 0; i < N; ++i) {
      Numbers low;
      Numbers high;
      group.read(block.min_row(i), low);
      group.read(block.max_row(i), high);
      make_larger(gap, low - sides.box.max[i]);
      make_larger(gap, sides.box.min[i] - high);
      center[i] = low * T(0.5) + high * T(0.5);
      half[i] = high * T(0.5) - low * T(0.5);
    }
    for (Dim k = 0; k < N; ++k) {
      Numbers middle = {};
      Numbers reach = {};
      for (Dim i = 0; i < N; ++i) {
        const T factor = sides.axes[k][i];
        middle += center[i] * factor;
        reach += half[i] * (factor < 0 ? -factor : factor);
      }
      make_larger(gap, middle - reach - sides.high[k]);
      make_larger(gap, sides.low[k] - middle - reach);
    }
    group.flags = ~(gap > 0);
  });
}

/// The same for triangles.
template <Dim N, class T>
LaneMask lanes_between(const TriangleBlock<N, T>& triangles, const LaneSides<N, T>& sides) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers corners[3][static_cast<std::size_t>(N)];
    for (std::size_t c = 0; c < 3; ++c) {
      for (Dim i = 0; i < N; ++i) group.read(triangles.corners[c][static_cast<std::size_t>(i)], corners[c][i]);
    }
    Numbers gap = Numbers{} - 1;
    for (Dim k = 0; k < N; ++k) {
      Numbers along[3];
      for (std::size_t c = 0; c < 3; ++c) {
        along[c] = corners[c][0] * sides.axes[k][0];
        for (Dim i = 1; i < N; ++i) along[c] += corners[c][i] * sides.axes[k][i];
      }
      Numbers low = along[0];
      Numbers high = along[0];
      make_smaller(low, along[1]);
      make_smaller(low, along[2]);
      make_larger(high, along[1]);
      make_larger(high, along[2]);
      make_larger(gap, low - sides.high[k]);
      make_larger(gap, sides.low[k] - high);
    }
    group.flags = ~(gap > 0);
  });
}

#endif

template <Dim N, class T>
class MayTouchObbInside;

/// For `visit_parts`: whether a part may touch an oriented box.
template <Dim N, class T>
struct MayTouchObb : MayTouch<N, T> {
  explicit MayTouchObb(const Obb<N, T>& shape) : MayTouch<N, T>{touching_bounds(shape)}, obb(shape) {}

  MayTouchObbInside<N, T> inside(const Aabb<N, T>& around, double error) const {
    return MayTouchObbInside<N, T>(*this, around, error);
  }

  const Obb<N, T>& obb;
};

template <Dim N, class T>
class MayTouchObbInside {
 public:
  MayTouchObbInside(const MayTouchObb<N, T>& may_touch, [[maybe_unused]] const Aabb<N, T>& around,
                    [[maybe_unused]] double error)
      : box_(may_touch.box) {
#ifdef GRAZE_HAS_LANES
    // NOLINTNEXTLINE(cppcoreguidelines-prefer-member-initializer): not in every build
    sides_ = lane_sides(may_touch.obb, may_touch.box, around, error);
#endif
  }

  bool operator()(const Aabb<N, T>& grown) const { return boxes_overlap(grown, box_); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& grown) const { return lanes_between(grown, sides_); }
  LaneMask lanes(const TriangleBlock<N, T>& triangles) const { return lanes_between(triangles, sides_); }
#endif

 private:
  Aabb<N, T> box_;
#ifdef GRAZE_HAS_LANES
  LaneSides<N, T> sides_;
#endif
};

/// What may touch a shape, for `visit_parts`. It refers to the shape.
template <class S>
auto may_touch(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  if constexpr (std::is_same_v<S, Obb<N, T>>) {
    return MayTouchObb<N, T>(shape);
  } else {
    return MayTouch<N, T>{touching_bounds(shape)};
  }
}

}  // namespace graze::detail
