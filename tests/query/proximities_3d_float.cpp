// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, float>;
template Proximity<3, float> closest_points_of<3, float>(const Any&, const Any&);
template float distance_of<3, float>(const Any&, const Any&);
template Proximity<3, double> proximity_of<3, float>(const Any&, const Any&);

}  // namespace graze::test
