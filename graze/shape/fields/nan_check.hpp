// SPDX-License-Identifier: MIT
// any_nan(a, b): whether any number of two shapes is NaN. It sums them, because comparisons can drop a NaN.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::detail {

// ---- The sum of the absolute values of a shape's or field's numbers; it may overflow. Polytopes never contain NaN;
// compounds and user-defined shapes are not checked.

template <class Value>
float numbers_of(const Value&) {
  return 0;
}

template <Scalar T>
T numbers_of(const T& number) {
  return std::fabs(number);
}

template <Dim N, Scalar T>
T numbers_of(const Vec<N, T>& v) {
  T sum = std::fabs(v[0]);
  for (Dim i = 1; i < N; ++i) sum += std::fabs(v[i]);
  return sum;
}

template <Dim N, Scalar T>
T numbers_of(const Mat<N, T>& columns) {
  T sum = numbers_of<N, T>(columns[0]);
  for (Dim i = 1; i < N; ++i) sum += numbers_of<N, T>(columns[i]);
  return sum;
}

template <Dim N, Scalar T, std::size_t count>
T numbers_of(const std::array<Vec<N, T>, count>& points) {
  T sum = 0;
  for (const Vec<N, T>& point : points) sum += numbers_of<N, T>(point);
  return sum;
}

template <Described S>
auto numbers_of(const S& shape) {
  return description_of<S>.apply([&](const auto&... fields) { return (numbers_of(fields.in(shape)) + ...); });
}

template <class A, class B>
bool any_nan(const A& a, const B& b) {
  return std::isnan(numbers_of(a) + numbers_of(b));
}

}  // namespace graze::detail
