// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

using Any = AnyShape<2, float>;
using Hit = std::optional<RayHit<2, float>>;
template Hit hit_of<2, float>(const Any&, const Ray<2, float>&, float, RayOptions);
template Hit hit_of<2, float>(const Any&, const Segment<2, float>&, RayOptions);
template double height_of<2, float>(const Any&, const Vec<2, double>&);

}  // namespace graze::test
