// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze {
template Proximity<3, double> detail::proximity(const AnyShape<3, double>&, const AnyShape<3, double>&,
                                                SimplexCache<3>*);
}  // namespace graze

namespace graze::test {

template Proximity<3, double> closest_points_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);
template double distance_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);
template Proximity<3, double> proximity_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze::test
