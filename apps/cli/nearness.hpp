// SPDX-License-Identifier: MIT
// The distance of two shapes of a scene. A separate source file, because distance(AnyShape, AnyShape) instantiates
// every pair of types.
#pragma once

#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::cli {

/// The distance is 0 if and only if the shapes are not apart.
struct Nearness {
  Relation relation = Relation::apart;
  double distance = 0;
  Status status = Status::converged;
  double error = 0;  ///< Bound on the error of the distance.
};

template <Dim N>
Nearness nearness_of(const AnyShape<N, double>& a, const AnyShape<N, double>& b);

extern template Nearness nearness_of<2>(const AnyShape<2, double>&, const AnyShape<2, double>&);
extern template Nearness nearness_of<3>(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze::cli
