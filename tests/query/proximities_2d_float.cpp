// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

using Any = AnyShape<2, float>;
template Proximity<2, float> closest_points_of<2, float>(const Any&, const Any&);
template float distance_of<2, float>(const Any&, const Any&);
template Proximity<2, double> proximity_of<2, float>(const Any&, const Any&);

}  // namespace graze::test
