// SPDX-License-Identifier: MIT
// Numbers, vectors and matrices as C++ source that denotes exactly the same value.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include <graze/math/vec.hpp>

namespace graze::test {

/// The shortest decimal that reads back as the same number, as a literal of its type; INFINITY and NAN from <cmath>.
template <std::floating_point T>
std::string literal(T x) {
  if (std::isnan(x)) return "NAN";
  if (std::isinf(x)) return x > T(0) ? "INFINITY" : "-INFINITY";
  std::array<char, 64> buffer{};
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
  std::string text(buffer.data(), end.ptr);
  if (text.find_first_of(".e") == std::string::npos) {
    const bool fits_int = text.size() < 10 && text != "-0";
    if (fits_int) return text;
    text += ".0";
  }
  return std::same_as<T, float> ? text + "F" : text;
}

/// A number or a braced list of values, without the type's name: the content of a shape's braces.
template <std::floating_point T>
std::string initializer(T x) {
  return literal(x);
}

template <Dim N, class T>
std::string initializer(const Vec<N, T>& v) {
  std::string text = "{";
  for (Dim i = 0; i < N; ++i) text += (i > 0 ? ", " : "") + literal(v[i]);
  return text + "}";
}

template <Dim N, class T>
std::string initializer(const Mat<N, T>& matrix) {
  std::string text = "{";
  for (Dim j = 0; j < N; ++j) text += (j > 0 ? ", " : "") + initializer<N, T>(matrix[j]);
  return text + "}";
}

/// `Name<2, float>`.
template <Dim N, Scalar T>
std::string type_source(std::string_view name) {
  return std::string(name) + "<" + std::to_string(N) + ", " + (std::same_as<T, float> ? "float" : "double") + ">";
}

}  // namespace graze::test
