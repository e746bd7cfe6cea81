// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze::test {

template Proximity<2, float> closest_points_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template float distance_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template Proximity<2, double> proximity_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);

}  // namespace graze::test
