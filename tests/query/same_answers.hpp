// SPDX-License-Identifier: MIT
// Whether two answers are equal to the bit, those without points included.
#pragma once

#include <cmath>

#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>

namespace graze::test {

/// NaN equals NaN here.
template <Dim N, class T>
bool same_point(const Vec<N, T>& a, const Vec<N, T>& b) {
  for (Dim i = 0; i < N; ++i) {
    if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) return false;
  }
  return true;
}

/// Points are NaN if there is no part with points.
template <Dim N, class T>
bool same(const Proximity<N, T>& a, const Proximity<N, T>& b) {
  return a.distance == b.distance && same_point<N, T>(a.point_a, b.point_a) && same_point<N, T>(a.point_b, b.point_b) &&
         a.normal == b.normal && a.relation == b.relation && a.status == b.status && a.error == b.error;
}

}  // namespace graze::test
