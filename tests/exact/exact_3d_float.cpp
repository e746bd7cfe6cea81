// SPDX-License-Identifier: MIT
#include "exact/certificate_instances.hpp"
#include "exact/holds_instances.hpp"
#include "exact/point_instances.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test {

template ExactVerdict exact_verdict(const AnyShape<3, float>&, const AnyShape<3, float>&, Measure);
template GapBounds gap_bounds(const AnyShape<3, float>&, const AnyShape<3, float>&, Relation);
template double exact_signed_distance(const AnyShape<3, float>&, const Vec<3, float>&);
template double exact_distance(const Vec<3, float>&, const Vec<3, float>&);
template double exact_miss(const AnyShape<3, float>&, const Vec<3, float>&, const Vec<3, float>&);
template bool contains_exactly(const Sphere<3, float>&, const Vec<3, float>&);
template bool contains_exactly(const Obb<3, float>&, const Vec<3, float>&);

}  // namespace graze::test
