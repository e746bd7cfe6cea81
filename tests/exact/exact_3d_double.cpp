// SPDX-License-Identifier: MIT
#include "exact.hpp"
#include "exact/certificate_instances.hpp"

template graze::test::ExactVerdict graze::test::exact_verdict(const AnyShape<3, double>&, const AnyShape<3, double>&,
                                                              Measure);
template graze::test::GapBounds graze::test::gap_bounds(const AnyShape<3, double>&, const AnyShape<3, double>&,
                                                        Relation);
