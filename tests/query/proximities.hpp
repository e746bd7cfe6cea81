// SPDX-License-Identifier: MIT
// What graze says about the distance of any two shapes: compiled once for each space, in proximities_*.cpp, because
// hundreds of pairs take their time.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// closest_points(a, b).
template <Dim N, class T>
Proximity<N, T> closest_points_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// distance(a, b).
template <Dim N, class T>
T distance_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// What closest_points(a, b) rounds to T.
template <Dim N, class T>
Proximity<N, double> proximity_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

}  // namespace graze::test
