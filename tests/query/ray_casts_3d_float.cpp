// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, float>;
using Hit = std::optional<RayHit<3, float>>;
template Hit hit_of<3, float>(const Any&, const Ray<3, float>&, float, RayOptions);
template Hit hit_of<3, float>(const Any&, const Segment<3, float>&, RayOptions);
template double height_of<3, float>(const Any&, const Vec<3, double>&);

}  // namespace graze::test
