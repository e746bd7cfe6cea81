// SPDX-License-Identifier: MIT
#include "exact/certificate_instances.hpp"
#include "exact/holds_instances.hpp"
#include "exact/point_instances.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

template ExactVerdict exact_verdict(const AnyShape<3, double>&, const AnyShape<3, double>&, Measure);
template GapBounds gap_bounds(const AnyShape<3, double>&, const AnyShape<3, double>&, Relation);
template double exact_signed_distance(const AnyShape<3, double>&, const Vec<3, double>&);
template double exact_distance(const Vec<3, double>&, const Vec<3, double>&);
template double exact_miss(const AnyShape<3, double>&, const Vec<3, double>&, const Vec<3, double>&);
template bool contains_exactly(const Sphere<3, double>&, const Vec<3, double>&);
template bool contains_exactly(const Obb<3, double>&, const Vec<3, double>&);

}  // namespace graze::test
