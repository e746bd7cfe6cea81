// SPDX-License-Identifier: MIT
// The closed forms of ray_cast.hpp for boxes. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Where a path is between each two sides of a box along the axes (Kay and Kajiya, "Ray tracing complex scenes", 1986).
/// Along an axis across which the path runs it would be so always or never: there the inverse of the direction stands
/// for a number so large that the box is as good as infinite, and is finite, so that no zero is multiplied by infinity.
template <Dim N>
struct Slabs {
  Slabs(const Aabb<N, double>& box, const Vec<N, double>& direction, double margin) {
    double size = 0;
    for (Dim i = 0; i < N; ++i) size += std::fabs(box.min[i]) + std::fabs(box.max[i]);
    for (Dim i = 0; i < N; ++i) {
      const double inverse = std::fabs(direction[i]) > least_slope ? 1 / direction[i] : 1 / least_slope;
      const double to_min = box.min[i] * inverse;
      const double to_max = box.max[i] * inverse;
      near[i] = std::min(to_min, to_max);
      far[i] = std::max(to_min, to_max);
      slack[i] = margin * size * std::fabs(inverse);
    }
  }

  /// Where the path enters and leaves the box if its sides are moved out by the slack.
  double widest_enter() const { return largest(near - slack); }
  double widest_exit() const { return -largest(-(far + slack)); }

  /// The axis across whose side it enters that box.
  Dim axis() const {
    Dim best = 0;
    for (Dim i = 1; i < N; ++i) {
      if (near[i] - slack[i] > near[best] - slack[best]) best = i;
    }
    return best;
  }

  /// Whether it is between all sides at once, with the slack to spare where two axes are compared: of one axis the near
  /// side comes first even if the box is flat.
  bool are_entered() const {
    bool entered = true;
    for (Dim i = 0; i < N; ++i) {
      for (Dim j = 0; j < N; ++j) {
        entered &= i == j || near[i] + slack[i] <= far[j] - slack[j];
      }
    }
    return entered;
  }

  static double largest(const Vec<N, double>& v) {
    double result = v[0];
    for (Dim i = 1; i < N; ++i) result = std::max(result, v[i]);
    return result;
  }

  static constexpr double least_slope = 0x1p-500;
  Vec<N, double> near;
  Vec<N, double> far;
  Vec<N, double> slack;  ///< What it takes to move by `margin` times the box's size across a side.
};

/// Where a path meets a box as the box's own axes see it.
template <Dim N>
struct TouchOfBox {
  Sight sight = Sight::misses;
  double t = 0;
  Vec<N, double> point = Vec<N, double>(0.0);
  Dim axis = 0;
  double side = 0;  ///< -1 or 1: the min or the max side of the axis; 0 if zero is inside.
};

/// Where the path enters a box that it hits, if its sides are moved out by the slack of `slabs`.
template <Dim N>
void enter_box(const Aabb<N, double>& box, const Slabs<N>& slabs, const Vec<N, double>& direction, double t_max,
               TouchOfBox<N>& touch) {
  const Dim axis = slabs.axis();
  if (!(slabs.near[axis] >= 0)) return;
  touch.axis = axis;
  touch.side = direction[axis] > 0 ? -1 : 1;
  const double exit = std::max(0.0, std::min(slabs.widest_exit(), t_max));
  const double face = direction[axis] > 0 ? box.min[axis] : box.max[axis];
  // Divided once more, and so rounded once less, where the near side is not that of a path along it.
  const double t = std::fabs(direction[axis]) > slabs.least_slope ? face / direction[axis] : slabs.near[axis];
  touch.t = std::min(t, exit);
  for (Dim i = 0; i < N; ++i) touch.point[i] = std::clamp(direction[i] * touch.t, box.min[i], box.max[i]);
  touch.point[axis] = face;
}

/// What is moved by the slack across a side is moved by tolerance::ray_side of the box's size, so all verdicts hold for
/// the true box. If it is touched after all, it is by no more than rounding.
template <Dim N>
TouchOfBox<N> touch_of_box(const Aabb<N, double>& box, const Vec<N, double>& direction, double t_max) {
  TouchOfBox<N> touch;
  const Slabs<N> slabs(box, direction, tolerance::ray_side);
  if (!(std::max(slabs.widest_enter(), 0.0) <= std::min(slabs.widest_exit(), t_max))) return touch;
  const bool is_in_time =
      slabs.largest(slabs.near + slabs.slack) <= t_max && slabs.largest(slabs.slack - slabs.far) <= 0;
  touch.sight = is_in_time && slabs.are_entered() ? Sight::hits : Sight::unclear;
  if (touch.sight == Sight::hits) {
    enter_box(box, slabs, direction, t_max, touch);
  } else {
    enter_box(box, Slabs<N>(box, direction, tolerance::rounding), direction, t_max, touch);
  }
  return touch;
}

template <Dim N>
double error_of(const Aabb<N, double>& box) {
  return tolerance::rounding * (sum_abs(box.min) + sum_abs(box.max));
}

template <Dim N>
Sighting<N> sight_of(const Aabb<N, double>& box, const Vec<N, double>& direction, double t_max) {
  const TouchOfBox<N> found = touch_of_box(box, direction, t_max);
  Sighting<N> result{found.sight, {found.t, found.point, Vec<N, double>(0.0), error_of(box)}};
  result.touch.normal[found.axis] = found.side;
  return result;
}

/// The rows of the inverse of a matrix, all as much too long as `determinant` says.
template <Dim N>
struct Inverse {
  std::array<Vec<N, double>, static_cast<std::size_t>(N)> rows;
  double determinant;
};

inline Inverse<2> inverse_of(const Mat<2, double>& m) {
  return {{Vec<2, double>(m[1].y, -m[1].x), Vec<2, double>(-m[0].y, m[0].x)}, cross_2d(m[0], m[1])};
}
inline Inverse<3> inverse_of(const Mat<3, double>& m) {
  const Vec<3, double> first = cross(m[1], m[2]);
  return {{first, cross(m[2], m[0]), cross(m[0], m[1])}, dot(first, m[0])};
}

/// The box as its own axes see it. They are orthonormal only up to rounding and the set is taken as stored, so the
/// places on the axes are found with their inverse, where the transpose would be off by as much as they are. It is not
/// divided by the determinant, which is positive or negative and nearly 1: box and direction grow alike.
template <Dim N>
Sighting<N> sight_of(const Obb<N, double>& box, const Vec<N, double>& direction, double t_max) {
  const Inverse<N> inverse = inverse_of(box.axes);
  const double sign = inverse.determinant < 0 ? -1 : 1;
  Vec<N, double> center;
  Vec<N, double> slope;
  for (Dim i = 0; i < N; ++i) {
    const Vec<N, double>& row = inverse.rows[static_cast<std::size_t>(i)];
    center[i] = dot(row, box.center) * sign;
    slope[i] = dot(row, direction) * sign;
  }
  const Vec<N, double> half = box.half_extents * (inverse.determinant * sign);
  const TouchOfBox<N> found = touch_of_box<N>({center - half, center + half}, slope, t_max);
  Sighting<N> result{found.sight, {}};
  result.touch.t = found.t;
  result.touch.error = tolerance::rounding * (sum_abs(box.center) + 2 * sum_abs(box.half_extents));
  if (found.side == 0) return result;
  result.touch.normal = inverse.rows[static_cast<std::size_t>(found.axis)] * (found.side * sign);
  Vec<N, double> place = (found.point - center) / (inverse.determinant * sign);
  place[found.axis] = box.half_extents[found.axis] * found.side;
  result.touch.point = box.center + box.axes * place;
  return result;
}

}  // namespace graze::detail
