// SPDX-License-Identifier: MIT
// A triangle is the same whatever the order of its corners.
#pragma once

#include <array>

#include <graze/math/vec.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::test {

/// The same triangle, its corners in every order.
template <Dim N, class T>
std::array<Triangle<N, T>, 6> orders_of(const Triangle<N, T>& t) {
  return {{{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.a, t.c, t.b}, {t.c, t.b, t.a}, {t.b, t.a, t.c}}};
}

/// Any other shape as it is.
template <class S>
std::array<S, 1> orders_of(const S& shape) {
  return {shape};
}

}  // namespace graze::test
