// SPDX-License-Identifier: MIT
// converted<To>(shape, change): a shape with its numbers converted to another type.
#pragma once

#include <cstddef>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::detail {

/// Sets each number of `to` to change(number) of `from`. Values are numbers, vectors, matrices or arrays of vectors.
template <class From, class To, class Change>
void convert(const From& from, To& to, const Change& change) {
  if constexpr (std::is_floating_point_v<From>) {
    to = change(from);
  } else if constexpr (requires { from.size(); }) {
    for (std::size_t i = 0; i < from.size(); ++i) convert(from[i], to[i], change);
  } else {
    for (Dim i = 0; i < from.length(); ++i) convert(from[i], to[i], change);
  }
}

/// A shape with every number replaced by change(number), of type To. Not for polytopes and compounds.
template <class To, template <Dim, class> class S, Dim N, class From, class Change>
S<N, To> converted(const S<N, From>& shape, const Change& change) {
  S<N, To> result;
  description_of<S<N, From>>.apply([&](const auto&... fields) {
    description_of<S<N, To>>.apply(
        [&](const auto&... result_fields) { (convert(fields.in(shape), result_fields.in(result), change), ...); });
  });
  return result;
}

/// A shape of floats or doubles converted to double, exactly.
template <template <Dim, class> class S, Dim N, class T>
S<N, double> widened(const S<N, T>& shape) {
  return converted<double>(shape, [](T number) { return static_cast<double>(number); });
}

}  // namespace graze::detail
