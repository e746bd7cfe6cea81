// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze {
template Proximity<2, double> detail::proximity(const AnyShape<2, float>&, const AnyShape<2, float>&, SimplexCache<2>*);
}  // namespace graze

namespace graze::test {

template Proximity<2, float> closest_points_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template float distance_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template Proximity<2, double> proximity_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);

}  // namespace graze::test
