// SPDX-License-Identifier: MIT
// graze's distances of any two shapes: compiled once for each space, by proximities.cpp.in, because hundreds of pairs
// take long to compile.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/shape/any_shape.hpp>

// Also compiled there, for separation_test.cpp.
namespace graze {
extern template Proximity<2, double> detail::proximity(const AnyShape<2, float>&, const AnyShape<2, float>&,
                                                       SimplexCache<2>*);
extern template Proximity<2, double> detail::proximity(const AnyShape<2, double>&, const AnyShape<2, double>&,
                                                       SimplexCache<2>*);
extern template Proximity<3, double> detail::proximity(const AnyShape<3, float>&, const AnyShape<3, float>&,
                                                       SimplexCache<3>*);
extern template Proximity<3, double> detail::proximity(const AnyShape<3, double>&, const AnyShape<3, double>&,
                                                       SimplexCache<3>*);
}  // namespace graze

namespace graze::test {

/// closest_points(a, b).
template <Dim N, class T>
Proximity<N, T> closest_points_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// distance(a, b).
template <Dim N, class T>
T distance_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

/// closest_points(a, b) before it is rounded to T.
template <Dim N, class T>
Proximity<N, double> proximity_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b);

}  // namespace graze::test
