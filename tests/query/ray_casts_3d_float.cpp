// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

template std::optional<RayHit<3, float>> hit_of<3, float>(const AnyShape<3, float>&, const Ray<3, float>&, float,
                                                          RayOptions);
template std::optional<RayHit<3, float>> hit_of<3, float>(const AnyShape<3, float>&, const Segment<3, float>&,
                                                          RayOptions);
template bool meet_as_held<3, float>(const AnyShape<3, float>&, const Ray<3, float>&);
template double height_of<3, float>(const AnyShape<3, float>&, const Vec<3, double>&);

}  // namespace graze::test
