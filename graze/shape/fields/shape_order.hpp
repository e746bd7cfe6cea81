// SPDX-License-Identifier: MIT
// An order of shapes of one type by their numbers. A query of pairs that calculates with the lesser shape first gives
// the same bits whichever is named first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::detail {

// ---- compare(a, b): -1, 0 or 1. Equal are those whose numbers are, so that nothing can tell them apart.

template <Scalar T>
int compare(T a, T b) {
  return a < b ? -1 : b < a ? 1 : 0;
}

/// A direction that is at right angles to no way along an axis, a diagonal, or the like.
inline constexpr std::array<double, 3> order_direction = {0.97, 0.58, 0.43};

/// By how far they are along that. Of two boxes that stand on each other neither is far along x, so there the next
/// rounding would change which comes first.
template <Dim N, Scalar T>
int compare(const Vec<N, T>& a, const Vec<N, T>& b) {
  const Vec<N, double> way = wide<N, T>(b) - wide<N, T>(a);
  double along = 0;  // the opposite number, to the bit, of b and a
  for (Dim i = 0; i < N; ++i) along += order_direction[static_cast<std::size_t>(i)] * way[i];
  if (along > 0) return -1;
  if (along < 0) return 1;
  for (Dim i = 0; i < N; ++i) {
    if (a[i] != b[i]) return compare(a[i], b[i]);
  }
  return 0;
}

template <Dim N, Scalar T>
int compare(const Mat<N, T>& a, const Mat<N, T>& b) {
  for (Dim j = 0; j < N; ++j) {
    const int columns = compare<N, T>(a[j], b[j]);
    if (columns != 0) return columns;
  }
  return 0;
}

template <Dim N, class T>
auto fields_of(const Segment<N, T>& segment) {
  return std::tie(segment.start, segment.end);
}
template <Dim N, class T>
auto fields_of(const Ray<N, T>& ray) {
  return std::tie(ray.origin, ray.direction);
}
template <Dim N, class T>
auto fields_of(const Sphere<N, T>& sphere) {
  return std::tie(sphere.center, sphere.radius);
}
template <Dim N, class T>
auto fields_of(const Aabb<N, T>& box) {
  return std::tie(box.min, box.max);
}
template <Dim N, class T>
auto fields_of(const Obb<N, T>& box) {
  return std::tie(box.center, box.half_extents, box.axes);
}
template <Dim N, class T>
auto fields_of(const Plane<N, T>& plane) {
  return std::tie(plane.normal, plane.offset);
}
template <Dim N, class T>
auto fields_of(const HalfSpace<N, T>& solid) {
  return std::tie(solid.normal, solid.offset);
}
template <Dim N, class T>
auto fields_of(const Triangle<N, T>& triangle) {
  return std::tie(triangle.a, triangle.b, triangle.c);
}
template <Dim N, class T>
auto fields_of(const Capsule<N, T>& capsule) {
  return std::tie(capsule.a, capsule.b, capsule.radius);
}

/// The first field that differs decides.
template <class S>
int compare(const S& a, const S& b) requires requires {
  fields_of(a);
}
{
  return std::apply(
      [&b](const auto&... of_a) {
        return std::apply(
            [&of_a...](const auto&... of_b) {
              int result = 0;
              (void)(((result = compare(of_a, of_b)) != 0) || ...);
              return result;
            },
            fields_of(b));
      },
      fields_of(a));
}

/// Lists of different lengths are told apart by them.
template <class List, class Compare>
int compare_lists(const List& a, const List& b, const Compare& compare_elements) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int elements = compare_elements(a[i], b[i]);
    if (elements != 0) return elements;
  }
  return 0;
}

template <Dim N, class T>
int compare(const Polytope<N, T>& a, const Polytope<N, T>& b) {
  return compare_lists(a.vertices(), b.vertices(),
                       [](const Vec<N, T>& p, const Vec<N, T>& q) { return compare<N, T>(p, q); });
}

template <Dim N, class T>
int compare(const Compound<N, T>& a, const Compound<N, T>& b);

/// Different types by their place in AnyShape.
template <Dim N, class T>
int compare(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  if (a.index() != b.index()) return a.index() < b.index() ? -1 : 1;
  return detail::visit([&b]<class S>(const S& held) { return compare(held, std::get<S>(b)); }, a);
}

template <Dim N, class T>
int compare(const Compound<N, T>& a, const Compound<N, T>& b) {
  return compare_lists(a.parts, b.parts,
                       [](const Part<N, T>& p, const Part<N, T>& q) { return compare<N, T>(p.shape, q.shape); });
}

}  // namespace graze::detail
