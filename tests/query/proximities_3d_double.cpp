// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

template Proximity<3, double> closest_points_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);
template double distance_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);
template Proximity<3, double> proximity_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze::test
