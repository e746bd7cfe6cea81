// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze {
template Proximity<3, double> detail::proximity(const AnyShape<3, float>&, const AnyShape<3, float>&, SimplexCache<3>*);
}  // namespace graze

namespace graze::test {

template Proximity<3, float> closest_points_of<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&);
template float distance_of<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&);
template Proximity<3, double> proximity_of<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&);

}  // namespace graze::test
