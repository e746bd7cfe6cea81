// SPDX-License-Identifier: MIT
#include "exact.hpp"

template graze::test::ExactVerdict graze::test::exact_verdict(const AnyShape<3, double>&, const AnyShape<3, double>&,
                                                              Measure);
