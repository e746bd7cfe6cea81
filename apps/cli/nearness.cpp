// SPDX-License-Identifier: MIT
#include "nearness.hpp"

#include <graze/query/closest_points.hpp>

namespace graze::cli {

template <Dim N>
Nearness nearness_of(const AnyShape<N, double>& a, const AnyShape<N, double>& b) {
  const Proximity<N, double> nearest = closest_points(a, b);
  return {nearest.relation, nearest.distance, nearest.status, nearest.error};
}

template Nearness nearness_of<2>(const AnyShape<2, double>&, const AnyShape<2, double>&);
template Nearness nearness_of<3>(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze::cli
