// SPDX-License-Identifier: MIT
// Whether two manifolds are bit-identical.
#pragma once

#include <cstddef>
#include <cstring>

#include <graze/query/manifold.hpp>

namespace graze::test {

/// Compared in double, which represents floats exactly.
inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

template <class V>
bool same_vectors(const V& a, const V& b) {
  for (int i = 0; i < V::length(); ++i) {
    if (!same_bits(a[i], b[i])) return false;
  }
  return true;
}

template <Dim N, class T>
bool same_manifolds(const Manifold<N, T>& a, const Manifold<N, T>& b) {
  bool same = a == b && same_vectors(a.normal, b.normal) && same_bits(a.error, b.error);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const ManifoldPoint<N, T>& p = a.points[i];
    const ManifoldPoint<N, T>& q = b.points[i];
    same = same && same_vectors(p.point, q.point) && same_vectors(p.point_a, q.point_a) &&
           same_vectors(p.point_b, q.point_b) && same_bits(p.depth, q.depth);
  }
  return same;
}

}  // namespace graze::test
