// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, double>;
using Hit = std::optional<RayHit<3, double>>;
template Hit hit_of<3, double>(const Any&, const Ray<3, double>&, double, RayOptions);
template Hit hit_of<3, double>(const Any&, const Segment<3, double>&, RayOptions);
template double height_of<3, double>(const Any&, const Vec<3, double>&);

}  // namespace graze::test
