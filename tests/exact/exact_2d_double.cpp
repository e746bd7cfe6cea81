// SPDX-License-Identifier: MIT
#include "exact.hpp"

template graze::test::ExactVerdict graze::test::exact_verdict(const AnyShape<2, double>&, const AnyShape<2, double>&,
                                                              Measure);
