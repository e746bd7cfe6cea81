// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

using Any = AnyShape<2, double>;
template Proximity<2, double> closest_points_of<2, double>(const Any&, const Any&);
template double distance_of<2, double>(const Any&, const Any&);
template Proximity<2, double> proximity_of<2, double>(const Any&, const Any&);

}  // namespace graze::test
