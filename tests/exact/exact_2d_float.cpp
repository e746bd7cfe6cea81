// SPDX-License-Identifier: MIT
#include "exact.hpp"

template graze::test::ExactVerdict graze::test::exact_verdict(const AnyShape<2, float>&, const AnyShape<2, float>&,
                                                              Measure);
