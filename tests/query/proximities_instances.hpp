// SPDX-License-Identifier: MIT
// The definitions behind proximities.hpp, for the files that instantiate them.
#pragma once

#include <graze/query/distance.hpp>

#include "query/proximities.hpp"

namespace graze::test {

template <Dim N, class T>
Proximity<N, T> closest_points_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return closest_points(a, b);
}

template <Dim N, class T>
T distance_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return distance(a, b);
}

template <Dim N, class T>
Proximity<N, double> proximity_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return detail::proximity(a, b);
}

}  // namespace graze::test
