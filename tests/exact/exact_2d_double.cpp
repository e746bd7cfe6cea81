// SPDX-License-Identifier: MIT
#include "exact/certificate_instances.hpp"
#include "exact/holds_instances.hpp"
#include "exact/point_instances.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

template ExactVerdict exact_verdict(const AnyShape<2, double>&, const AnyShape<2, double>&, Measure);
template GapBounds gap_bounds(const AnyShape<2, double>&, const AnyShape<2, double>&, Relation);
template double exact_signed_distance(const AnyShape<2, double>&, const Vec<2, double>&);
template double exact_distance(const Vec<2, double>&, const Vec<2, double>&);
template double exact_miss(const AnyShape<2, double>&, const Vec<2, double>&, const Vec<2, double>&);
template bool contains_exactly(const Sphere<2, double>&, const Vec<2, double>&);
template bool contains_exactly(const Obb<2, double>&, const Vec<2, double>&);

}  // namespace graze::test
