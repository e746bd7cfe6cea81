// SPDX-License-Identifier: MIT
/// @file
/// bounds(shape): an axis-aligned box in T that contains the shape; rounded outward, and the smallest one if the
/// numbers allow it. Users' convex shapes have a generic form at the end.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/parts/grown_box.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// The box of a point: both corners are the point. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Vec<N, T>& point) {
  return {point, point};
}

/// The least box of a segment. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Segment<N, T>& segment) {
  return Aabb<N, T>::from_corners(segment.start, segment.end);
}

/// The least box of a ray: infinite on the sides to which the ray runs. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Ray<N, T>& ray) {
  Aabb<N, T> box{ray.origin, ray.origin};
  for (Dim i = 0; i < N; ++i) {
    if (ray.direction[i] > T(0)) box.max[i] = std::numeric_limits<T>::infinity();
    if (ray.direction[i] < T(0)) box.min[i] = -std::numeric_limits<T>::infinity();
  }
  return box;
}

namespace detail {
/// `box` extended by `radius` on all sides, rounded outward.
template <Dim N, class T>
Aabb<N, T> inflated(Aabb<N, T> box, T radius) {
  for (Dim i = 0; i < N; ++i) {
    box.min[i] = round_down<T>(add_down(static_cast<double>(box.min[i]), -static_cast<double>(radius)));
    box.max[i] = round_up<T>(add_up(static_cast<double>(box.max[i]), static_cast<double>(radius)));
  }
  return box;
}
}  // namespace detail

/// The least box of T that contains the sphere: every side is rounded outward.
template <Dim N, class T>
Aabb<N, T> bounds(const Sphere<N, T>& sphere) {
  return detail::inflated(Aabb<N, T>{sphere.center, sphere.center}, sphere.radius);
}

/// The box itself.
template <Dim N, class T>
Aabb<N, T> bounds(const Aabb<N, T>& box) {
  return box;
}

/// A box that contains an oriented box; rounded outward, at most a few ulp larger than the least one. Along coordinate
/// i it reaches sum_j |axes[j][i]| * half_extents[j] from the center.
template <Dim N, class T>
Aabb<N, T> bounds(const Obb<N, T>& box) {
  Aabb<N, T> result;
  for (Dim i = 0; i < N; ++i) {
    double reach = 0;
    for (Dim j = 0; j < N; ++j) {
      const double slope = std::fabs(static_cast<double>(box.axes[j][i]));
      reach = add_up(reach, multiply_up(slope, static_cast<double>(box.half_extents[j])));
    }
    const double center = static_cast<double>(box.center[i]);
    result.min[i] = round_down<T>(add_down(center, -reach));
    result.max[i] = round_up<T>(add_up(center, reach));
  }
  return result;
}

namespace detail {
/// The coordinate axis to which a plane is perpendicular, or -1: otherwise the plane is unbounded everywhere.
template <Dim N, class T>
Dim only_axis(const Vec<N, T>& normal) {
  Dim axis = -1;
  for (Dim i = 0; i < N; ++i) {
    if (normal[i] == T(0)) continue;
    if (axis >= 0) return -1;
    axis = i;
  }
  return axis;
}

/// Bounds on where a plane perpendicular to axis i crosses it: the quotient is rounded to nearest, then stepped both
/// ways unless the division was certainly exact.
template <Dim N, class T>
std::pair<T, T> crossing(const Plane<N, T>& plane, Dim axis) {
  const double slope = static_cast<double>(plane.normal[axis]);  // not zero: the axis was chosen so
  const double offset = static_cast<double>(plane.offset);
  const double quotient = offset / slope;
  const bool remainder_known = std::fabs(offset) >= least_product_with_error;
  const Rounded product = two_product(quotient, slope);
  const bool exact = offset == 0 || (remainder_known && product.value == offset && product.error == 0);
  return {round_down<T>(exact ? quotient : next_down(quotient)), round_up<T>(exact ? quotient : next_up(quotient))};
}
}  // namespace detail

/// The box of a plane: infinite, except along the axis to which the plane is perpendicular, if there is one.
template <Dim N, class T>
Aabb<N, T> bounds(const Plane<N, T>& plane) {
  Aabb<N, T> box = Aabb<N, T>::everything();
  const Dim axis = detail::only_axis(plane.normal);
  if (axis < 0) return box;
  std::tie(box.min[axis], box.max[axis]) = detail::crossing(plane, axis);
  return box;
}

/// The box of a half-space: infinite, except on one side if its plane is perpendicular to an axis.
template <Dim N, class T>
Aabb<N, T> bounds(const HalfSpace<N, T>& solid) {
  Aabb<N, T> box = Aabb<N, T>::everything();
  const Dim axis = detail::only_axis(solid.normal);
  if (axis < 0) return box;
  const auto [low, high] = detail::crossing(boundary(solid), axis);
  if (solid.normal[axis] > T(0)) {
    box.max[axis] = high;
  } else {
    box.min[axis] = low;
  }
  return box;
}

/// The least box of a triangle. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Triangle<N, T>& triangle) {
  Aabb<N, T> box = Aabb<N, T>::from_corners(triangle.a, triangle.b);
  box.grow(triangle.c);
  return box;
}

/// A box that contains the capsule: that of its axis, grown by the radius and rounded outward.
template <Dim N, class T>
Aabb<N, T> bounds(const Capsule<N, T>& capsule) {
  return detail::inflated(bounds(axis(capsule)), capsule.radius);
}

/// The least box of a polytope. Exact; takes time proportional to the number of vertices.
template <Dim N, class T>
Aabb<N, T> bounds(const Polytope<N, T>& polytope) {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (const Vec<N, T>& vertex : polytope.vertices()) box.grow(vertex);
  return box;
}

/// The least box of a frustum. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Frustum<N, T>& frustum) {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (const Vec<N, T>& corner : frustum.corners) box.grow(corner);
  return box;
}

/// The box around the boxes of a compound's parts; Aabb::nothing() for a compound without parts.
template <Dim N, class T>
Aabb<N, T> bounds(const Compound<N, T>& compound) {
  if (const auto* const tree = detail::tree_of(compound.parts)) return tree->bounds();
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (const Part<N, T>& part : compound.parts) box.grow(part.box);
  return box;
}

/// The least box of a mesh's faces; Aabb::nothing() without faces. Exact.
template <Dim N, class T>
Aabb<N, T> bounds(const Mesh<N, T>& mesh) {
  return detail::placed(mesh).box();
}

/// The box of the shape held.
template <Dim N, class T>
Aabb<N, T> bounds(const AnyShape<N, T>& shape) {
  return detail::visit([](const auto& held) { return bounds(held); }, shape);
}

/// A box that contains a user's convex shape: its supports along the axes, widened by the rounding that `support` may
/// have.
template <Convex S>
Aabb<dimension_of<S>, scalar_of<S>> bounds(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    const double high = static_cast<double>(support(shape, unit_axis<N, T>(i))[i]);
    const double low = static_cast<double>(support(shape, -unit_axis<N, T>(i))[i]);
    const double slack = tolerance::convex_in<T> * std::fmax(std::fabs(high), std::fabs(low));
    box.min[i] = round_down<T>(low - slack);
    box.max[i] = round_up<T>(high + slack);
  }
  return box;
}

/// A box that contains a posed shape, widened by the rounding relative to the shape before and after it is moved.
template <Convex S>
Aabb<dimension_of<S>, scalar_of<S>> bounds(const Posed<S>& posed) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  using Number = detail::SupportScalar<S>;
  const Aabb<N, T> before = bounds(posed.shape);
  const T largest = std::max(max_abs(before.min), max_abs(before.max)) + max_abs(posed.pose.position);
  const double slack = tolerance::convex_in<Number> * static_cast<double>(largest);
  Aabb<N, T> box;
  for (Dim i = 0; i < N; ++i) {
    const Vec<N, Number> way = unit_axis<N, Number>(i);
    box.min[i] = round_down<T>(static_cast<double>(support(posed, -way)[i]) - slack);
    box.max[i] = round_up<T>(static_cast<double>(support(posed, way)[i]) + slack);
  }
  return box;
}

/// A box grown by more than the rounding error within which `relation` returns `touching` (math/tolerance.hpp): simple
/// shapes whose grown boxes do not overlap are certainly apart. Infinite and empty boxes stay as they are. For an
/// unbounded compound pass the shape instead, because its box does not tell how large the coordinates of its parts are.
template <Dim N, class T>
Aabb<N, T> touching_bounds(Aabb<N, T> box) {
  detail::grow_for_touching(box);
  return box;
}

namespace detail {
template <Dim N, class T>
bool is_bounded(const Aabb<N, T>& box) {
  return is_finite(box.min) && is_finite(box.max);
}

/// The union of the parts' boxes, each grown. Not inlined, because it is rare.
template <Dim N, class T>
[[gnu::noinline]] Aabb<N, T> union_of_grown(const Compound<N, T>& compound);

/// A box around a shape, large enough for touching_bounds to grow: its own, which the caller knows, or for an unbounded
/// compound the union of its parts' boxes, each grown. With a plane y = 0 as another part, the box of all does not
/// reveal that a part lies at x = 1e33, which also determines the rounding of y. For other boxes the largest coordinate
/// is that of a part.
template <Dim N, class T>
Aabb<N, T> sized_box(const Compound<N, T>& compound, Aabb<N, T> box) {
  return is_bounded(box) ? box : union_of_grown(compound);
}

/// Tests the box first, because the shape is farther away in memory.
template <Dim N, class T>
Aabb<N, T> sized_box(const AnyShape<N, T>& shape, Aabb<N, T> box) {
  if (is_bounded(box)) return box;
  const auto* const compound = std::get_if<Compound<N, T>>(&shape);
  return compound == nullptr ? box : union_of_grown(*compound);
}

template <Shape S>
Aabb<dimension_of<S>, scalar_of<S>> sized_box(const S& /*shape*/, Aabb<dimension_of<S>, scalar_of<S>> box) {
  return box;
}
}  // namespace detail

/// The box of a shape, grown likewise: shapes of any type whose grown boxes do not overlap are certainly apart.
template <Shape S>
Aabb<dimension_of<S>, scalar_of<S>> touching_bounds(const S& shape) {
  return touching_bounds(detail::sized_box(shape, bounds(shape)));
}

namespace detail {
template <Dim N, class T>
Aabb<N, T> union_of_grown(const Compound<N, T>& compound) {
  Aabb<N, T> box = Aabb<N, T>::nothing();
  for (const Part<N, T>& part : compound.parts) box.grow(touching_bounds(sized_box(part.shape, part.box)));
  return box;
}

/// Whether a part's box does not reveal how large the coordinates in it are. Then no query skips it by its box, but
/// tests its parts. Rare, so test it last.
template <Dim N, class T>
bool is_hidden_by_box(const Part<N, T>& part) {
  return std::holds_alternative<Compound<N, T>>(part.shape) && !is_bounded(part.box);
}

/// Whether a part may touch what has this grown box. In one function, because boxes that are grown through memory make
/// the processor wait for its own stores.
template <Dim N, class T>
[[gnu::flatten]] bool may_part_touch(const Part<N, T>& part, const Aabb<N, T>& grown) {
  return boxes_overlap(touching_bounds(part.box), grown) || is_hidden_by_box(part);
}

/// Compounds with fewer parts have no tree, because a loop over them is as fast.
inline constexpr std::size_t least_parts_of_tree = 32;

/// The parts with a tree of their grown boxes.
template <Dim N, class T>
Parts<N, T> with_tree(std::vector<Part<N, T>> list) {
  std::vector<Aabb<N, T>> boxes;
  boxes.reserve(list.size());
  Aabb<N, T> whole = Aabb<N, T>::nothing();
  bool has_usual_lengths = true;
  for (const Part<N, T>& part : list) {
    boxes.push_back(touching_bounds(part.box));
    whole.grow(part.box);
    has_usual_lengths = has_usual_lengths && are_usual(part.shape);
  }
  PartTree<N, T> tree(boxes, whole, has_usual_lengths);
  return parts_with_tree(std::move(list), std::move(tree));
}
}  // namespace detail

/// The union of shapes, in their order. Moves them in and calculates the box of each. If there are many, it also builds
/// a tree over the boxes, so that queries take time logarithmic in the number of parts.
template <Dim N, class T>
Compound<N, T> compound_of(std::vector<AnyShape<N, T>> shapes) {
  std::vector<Part<N, T>> list;
  list.reserve(shapes.size());
  for (AnyShape<N, T>& shape : shapes) {
    const Aabb<N, T> box = bounds(shape);
    list.push_back({std::move(shape), box});
  }
  const bool is_large = list.size() >= detail::least_parts_of_tree && list.size() < std::uint32_t(-1);
  return {is_large ? detail::with_tree(std::move(list)) : Parts<N, T>(std::move(list))};
}

}  // namespace graze
