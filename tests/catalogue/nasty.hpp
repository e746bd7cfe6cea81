// SPDX-License-Identifier: MIT
// Invalid and extreme numbers, substituted for every number of every shape.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/shape.hpp>

#include "../catalogue.hpp"

namespace graze::test {

template <class T>
using limits = std::numeric_limits<T>;

template <class T>
inline constexpr std::array<T, 11> nasty_values = {limits<T>::quiet_NaN(),
                                                   limits<T>::infinity(),
                                                   -limits<T>::infinity(),
                                                   limits<T>::max(),
                                                   limits<T>::lowest(),
                                                   T(-1),
                                                   T(1),
                                                   T(0),
                                                   -T(0),
                                                   limits<T>::denorm_min(),
                                                   -limits<T>::denorm_min()};

/// Writes one number of a field: the field itself, a coordinate, or an entry of a matrix by columns.
template <Scalar T>
void set_number(T& field, Dim, T value) {
  field = value;
}
template <Dim N, class T>
void set_number(Vec<N, T>& field, Dim index, T value) {
  field[index] = value;
}
template <Dim N, class T>
void set_number(Mat<N, T>& field, Dim index, T value) {
  field[index / N][index % N] = value;
}

/// Replaces every number of `shape` in turn by every nasty value and compares `defect` with the expectation: one
/// function of (value, index) for each field, in the fields' order. Counts the cases.
template <class S, class... Expected>
std::size_t expect_defects(const S& shape, const Expected&... expected) {
  using T = scalar_of<S>;
  std::size_t cases = 0;
  const auto replace_in = [&](const auto& field, const auto& expected_defect) {
    constexpr std::size_t count = sizeof(field.in(shape)) / sizeof(T);
    for (Dim index = 0; index < static_cast<Dim>(count); ++index) {
      for (const T value : nasty_values<T>) {
        S changed = shape;
        set_number(field.in(changed), index, value);
        EXPECT_EQ(defect(changed), expected_defect(value, index)) << to_source(changed);
        EXPECT_EQ(is_valid(changed), expected_defect(value, index).empty()) << to_source(changed);
        ++cases;
      }
    }
  };
  detail::description_of<S>.apply([&](const auto&... fields) { (replace_in(fields, expected), ...); });
  return cases;
}

/// A field whose numbers must only be finite.
inline auto finite(std::string_view otherwise) {
  return [otherwise](auto value, Dim) { return std::isfinite(value) ? std::string_view() : otherwise; };
}

/// A size: finite and not below zero (minus zero is not below).
inline auto finite_size(std::string_view not_finite, std::string_view negative) {
  return [=](auto value, Dim) {
    if (!std::isfinite(value)) return not_finite;
    return value < 0 ? negative : std::string_view();
  };
}

/// A direction with one nonzero coordinate: finite, and that one must not become zero.
inline auto direction_along(Dim axis, std::string_view not_finite, std::string_view zero) {
  return [=](auto value, Dim index) {
    if (!std::isfinite(value)) return not_finite;
    return index == axis && value == 0 ? zero : std::string_view();
  };
}

}  // namespace graze::test
