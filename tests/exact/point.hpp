// SPDX-License-Identifier: MIT
// The exact answers to point queries, in rational numbers: how far a point is from a shape as stored, and how far a
// claimed nearest point is from the true one. Compiled once for each space, by exact.cpp.in.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// The distance, or minus the depth; for planes positive on the normal's side. Throws std::invalid_argument for
/// compounds, whose parts must be queried one by one.
template <Dim N, class T>
double exact_signed_distance(const AnyShape<N, T>& shape, const Vec<N, T>& point);

/// The distance of two points, rounded once.
template <Dim N, class T>
double exact_distance(const Vec<N, T>& a, const Vec<N, T>& b);

/// How far `given` is from the shape's point nearest to `point`, which must be outside. Compounds as above.
template <Dim N, class T>
double exact_miss(const AnyShape<N, T>& shape, const Vec<N, T>& point, const Vec<N, T>& given);

extern template double exact_signed_distance(const AnyShape<2, float>&, const Vec<2, float>&);
extern template double exact_distance(const Vec<2, float>&, const Vec<2, float>&);
extern template double exact_miss(const AnyShape<2, float>&, const Vec<2, float>&, const Vec<2, float>&);
extern template double exact_signed_distance(const AnyShape<3, float>&, const Vec<3, float>&);
extern template double exact_distance(const Vec<3, float>&, const Vec<3, float>&);
extern template double exact_miss(const AnyShape<3, float>&, const Vec<3, float>&, const Vec<3, float>&);
extern template double exact_signed_distance(const AnyShape<2, double>&, const Vec<2, double>&);
extern template double exact_distance(const Vec<2, double>&, const Vec<2, double>&);
extern template double exact_miss(const AnyShape<2, double>&, const Vec<2, double>&, const Vec<2, double>&);
extern template double exact_signed_distance(const AnyShape<3, double>&, const Vec<3, double>&);
extern template double exact_distance(const Vec<3, double>&, const Vec<3, double>&);
extern template double exact_miss(const AnyShape<3, double>&, const Vec<3, double>&, const Vec<3, double>&);

}  // namespace graze::test
