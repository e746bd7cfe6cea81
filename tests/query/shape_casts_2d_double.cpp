// SPDX-License-Identifier: MIT
#include "query/shape_casts_instances.hpp"

namespace graze::test {

template std::optional<Impact<2, double>> impact_of(const AnyShape<2, double>&, const Vec<2, double>&,
                                                    const AnyShape<2, double>&);
template std::optional<detail::Strike<2>> strike_of(const AnyShape<2, double>&, const Vec<2, double>&,
                                                    const AnyShape<2, double>&);

}  // namespace graze::test
