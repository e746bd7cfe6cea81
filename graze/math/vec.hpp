// SPDX-License-Identifier: MIT
/// @file
/// Vectors and matrices. The only file of the library that includes GLM.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <graze/math/platform/compiler.hpp>  // first, because it reports compilers that are not supported

namespace graze {

/// The number of dimensions, 2 or 3.
using Dim = glm::length_t;

/// A point or direction. The qualifier is explicit so that a user's GLM macros cannot change the memory layout.
template <Dim N, class T = float>
using Vec = glm::vec<N, T, glm::packed_highp>;

/// A square matrix, stored by columns: `matrix[j]` is column j. Projections use matrices of N + 1 columns.
template <Dim N, class T = float>
using Mat = glm::mat<N, N, T, glm::packed_highp>;

static_assert(sizeof(Vec<2, float>) == 8 && alignof(Vec<2, float>) == alignof(float));
static_assert(sizeof(Vec<3, float>) == 12 && alignof(Vec<3, float>) == alignof(float));
static_assert(sizeof(Vec<3, double>) == 24 && alignof(Vec<3, double>) == alignof(double));

/// The number types that shapes can be stored in.
template <class T>
concept Scalar = std::same_as<T, float> || std::same_as<T, double>;

/// Converts a vector to double, the type that queries calculate in. Exact.
template <Dim N, class T>
constexpr Vec<N, double> wide(const Vec<N, T>& v) {
  return Vec<N, double>(v);
}

/// Converts a matrix to double. Exact.
template <Dim N, class T>
constexpr Mat<N, double> wide_matrix(const Mat<N, T>& m) {
  Mat<N, double> result;
  for (Dim j = 0; j < N; ++j) result[j] = wide<N, T>(m[j]);
  return result;
}

/// The unit vector along coordinate axis `i`.
template <Dim N, class T = double>
constexpr Vec<N, T> unit_axis(Dim i) {
  Vec<N, T> axis(T(0));
  axis[i] = T(1);
  return axis;
}

/// `v` rotated by a quarter turn counter-clockwise (y up).
template <class T>
constexpr Vec<2, T> perpendicular(const Vec<2, T>& v) {
  return {-v.y, v.x};
}

/// The z component of the 3D cross product: positive if `b` points counter-clockwise of `a`. Not robust for nearly
/// parallel vectors: see `accurate_cross`.
template <class T>
constexpr T cross_2d(const Vec<2, T>& a, const Vec<2, T>& b) {
  return a.x * b.y - a.y * b.x;
}

/// The squared length in T, without a square root. Overflows to infinity for coordinates above the square root of T's
/// largest number.
template <Dim N, class T>
constexpr T length_squared(const Vec<N, T>& v) {
  return dot(v, v);
}

/// The absolute value of each coordinate. GLM's own function compiles to a branch per coordinate, which random signs
/// mispredict.
template <Dim N, Scalar T>
[[gnu::always_inline]] inline Vec<N, T> abs(const Vec<N, T>& v) {
  Vec<N, T> result;
  for (Dim i = 0; i < N; ++i) result[i] = std::fabs(v[i]);
  return result;
}

/// The largest absolute coordinate; NaN coordinates are ignored.
template <Dim N, class T>
[[gnu::always_inline]] constexpr T max_abs(const Vec<N, T>& v) {
  T largest = T(0);
  for (Dim i = 0; i < N; ++i) {
    largest = std::max(largest, std::fabs(v[i]));
  }
  return largest;
}

/// The sum of the absolute coordinates.
template <Dim N, class T>
[[gnu::always_inline]] constexpr T sum_abs(const Vec<N, T>& v) {
  T sum = T(0);
  for (Dim i = 0; i < N; ++i) sum += std::fabs(v[i]);
  return sum;
}

/// The element type of a contiguous range: std::vector, std::array, std::span or a plain array.
template <class Row>
using ElementOf = std::remove_cvref_t<decltype(*std::data(std::declval<const Row&>()))>;

namespace detail {
/// The dimension of a vector, 0 for any other type. GLM's own `length()` is not constexpr with all of its macros.
template <class V>
inline constexpr Dim vec_dimension = 0;
template <Dim N, Scalar T>
inline constexpr Dim vec_dimension<Vec<N, T>> = N;
}  // namespace detail

/// A contiguous range of points. Functions of many points take a std::span and have an overload for such ranges,
/// because the dimension and number type of a span cannot be deduced from a type that only converts to it.
template <class Row>
concept PointRow = (detail::vec_dimension<ElementOf<Row>> > 0) && requires(const Row& row) {
  std::size(row);
};

/// A contiguous range of points of dimension N.
template <class Row, Dim N>
concept PointRowIn = PointRow<Row> &&(detail::vec_dimension<ElementOf<Row>> == N);

/// A view of the points; it is valid as long as `points` is neither changed nor destroyed.
template <PointRow Row>
std::span<const ElementOf<Row>> span_of(const Row& points) {
  return {std::data(points), std::size(points)};
}

/// True if no coordinate is infinite or NaN.
template <Dim N, class T>
bool is_finite(const Vec<N, T>& v) {
  for (Dim i = 0; i < N; ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}

}  // namespace graze
