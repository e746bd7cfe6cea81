// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

template std::optional<RayHit<3, double>> hit_of<3, double>(const AnyShape<3, double>&, const Ray<3, double>&, double,
                                                            RayOptions);
template std::optional<RayHit<3, double>> hit_of<3, double>(const AnyShape<3, double>&, const Segment<3, double>&,
                                                            RayOptions);
template bool meet_as_held<3, double>(const AnyShape<3, double>&, const Ray<3, double>&);
template double height_of<3, double>(const AnyShape<3, double>&, const Vec<3, double>&);

}  // namespace graze::test
