// SPDX-License-Identifier: MIT
#include "query/ray_casts_instances.hpp"

namespace graze::test {

using Any = AnyShape<2, double>;
using Hit = std::optional<RayHit<2, double>>;
template Hit hit_of<2, double>(const Any&, const Ray<2, double>&, double, RayOptions);
template Hit hit_of<2, double>(const Any&, const Segment<2, double>&, RayOptions);
template double height_of<2, double>(const Any&, const Vec<2, double>&);

}  // namespace graze::test
