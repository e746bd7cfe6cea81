// SPDX-License-Identifier: MIT
// hold_nan(a, b): whether any number of two shapes is NaN. Comparisons drop a NaN as easily as not; sums keep it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::detail {

// ---- The sum of the absolute numbers of a shape, or of a field's value; it may overflow. A polytope holds no NaN; a
// compound and a user's type are not looked into.

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
bool hold_nan(const A& a, const B& b) {
  return std::isnan(numbers_of(a) + numbers_of(b));
}

}  // namespace graze::detail
