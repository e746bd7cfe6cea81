// SPDX-License-Identifier: MIT
#include "query/proximities_instances.hpp"

namespace graze {
template Proximity<2, double> detail::proximity(const AnyShape<2, double>&, const AnyShape<2, double>&,
                                                SimplexCache<2>*);
}  // namespace graze

namespace graze::test {

template Proximity<2, double> closest_points_of<2, double>(const AnyShape<2, double>&, const AnyShape<2, double>&);
template double distance_of<2, double>(const AnyShape<2, double>&, const AnyShape<2, double>&);
template Proximity<2, double> proximity_of<2, double>(const AnyShape<2, double>&, const AnyShape<2, double>&);

}  // namespace graze::test
