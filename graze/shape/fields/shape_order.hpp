// SPDX-License-Identifier: MIT
// A total order of shapes of the same type, by their numbers. A symmetric query that puts the lesser shape first
// returns the same bits for both orders of its arguments.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::detail {

// ---- compare(a, b): -1, 0 or 1. Shapes with equal numbers are equal, because nothing can distinguish them.

template <Scalar T>
int compare(T a, T b) {
  return a < b ? -1 : b < a ? 1 : 0;
}

/// A direction that is not perpendicular to an axis, a diagonal or another common direction.
inline constexpr std::array<double, 3> order_direction = {0.97, 0.58, 0.43};

/// Compares positions along `order_direction`. Lexicographic order would be unstable: for two stacked boxes, x is
/// nearly equal, and rounding of x would decide the order.
template <Dim N, Scalar T>
int compare(const Vec<N, T>& a, const Vec<N, T>& b) {
  const Vec<N, double> way = wide<N, T>(b) - wide<N, T>(a);
  double along = 0;  // exactly the negative of what b and a give
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
int compare(const Part<N, T>& a, const Part<N, T>& b);

/// The shorter list comes first.
template <class List>
int compare_lists(const List& a, const List& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  int result = 0;
  for (std::size_t i = 0; i < a.size() && result == 0; ++i) result = compare(a[i], b[i]);
  return result;
}

template <Dim N, Scalar T>
int compare(std::span<const Vec<N, T>> a, std::span<const Vec<N, T>> b) {
  return compare_lists(a, b);
}

/// By their boxes, which nearly always decide, then by all that they contain.
template <Dim N, class T>
int compare(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  const PlacedMesh<N, T>& of_a = placed(a);
  const PlacedMesh<N, T>& of_b = placed(b);
  if (&of_a == &of_b) return 0;
  if (const int low = compare<N, T>(of_a.box().min, of_b.box().min); low != 0) return low;
  if (const int high = compare<N, T>(of_a.box().max, of_b.box().max); high != 0) return high;
  if (a.kind() != b.kind()) return a.kind() < b.kind() ? -1 : 1;
  if (const int vertices = compare<N, T>(a.vertices(), b.vertices()); vertices != 0) return vertices;
  const auto faces_a = a.faces();
  const auto faces_b = b.faces();
  if (std::equal(faces_a.begin(), faces_a.end(), faces_b.begin(), faces_b.end())) return 0;
  const bool is_less = std::lexicographical_compare(faces_a.begin(), faces_a.end(), faces_b.begin(), faces_b.end());
  return is_less ? -1 : 1;
}

template <Dim N, class T>
int compare(const Parts<N, T>& a, const Parts<N, T>& b) {
  return compare_lists(a, b);
}

template <class S>
concept Ordered = Described<S> && !description_of<S>.name.empty();

/// The first field that differs decides.
template <Ordered S>
int compare(const S& a, const S& b) {
  int result = 0;
  description_of<S>.apply(
      [&](const auto&... fields) { (void)(((result = compare(fields.in(a), fields.in(b))) != 0) || ...); });
  return result;
}

/// Different types are ordered by their index in AnyShape.
template <Dim N, class T>
int compare(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  if (a.index() != b.index()) return a.index() < b.index() ? -1 : 1;
  return detail::visit([&b]<class S>(const S& held) { return compare(held, std::get<S>(b)); }, a);
}

template <Dim N, class T>
int compare(const Part<N, T>& a, const Part<N, T>& b) {
  return compare<N, T>(a.shape, b.shape);
}

}  // namespace graze::detail
