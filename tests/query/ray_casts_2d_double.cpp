// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

template std::optional<RayHit<2, double>> hit_of<2, double>(const AnyShape<2, double>&, const Ray<2, double>&, double,
                                                            RayOptions);
template std::optional<RayHit<2, double>> hit_of<2, double>(const AnyShape<2, double>&, const Segment<2, double>&,
                                                            RayOptions);
template bool meet_as_held<2, double>(const AnyShape<2, double>&, const Ray<2, double>&);
template double height_of<2, double>(const AnyShape<2, double>&, const Vec<2, double>&);

}  // namespace graze::test
