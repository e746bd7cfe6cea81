// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, double>;
template Proximity<3, double> closest_points_of<3, double>(const Any&, const Any&);
template double distance_of<3, double>(const Any&, const Any&);
template Proximity<3, double> proximity_of<3, double>(const Any&, const Any&);

}  // namespace graze::test
