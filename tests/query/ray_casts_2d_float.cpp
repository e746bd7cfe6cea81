// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

template std::optional<RayHit<2, float>> hit_of<2, float>(const AnyShape<2, float>&, const Ray<2, float>&, float,
                                                          RayOptions);
template std::optional<RayHit<2, float>> hit_of<2, float>(const AnyShape<2, float>&, const Segment<2, float>&,
                                                          RayOptions);
template bool meet_as_held<2, float>(const AnyShape<2, float>&, const Ray<2, float>&);
template double height_of<2, float>(const AnyShape<2, float>&, const Vec<2, double>&);

}  // namespace graze::test
