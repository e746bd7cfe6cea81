// SPDX-License-Identifier: MIT
#include "query/shape_casts_instances.hpp"

namespace graze::test {

template std::optional<Impact<3, double>> impact_of(const AnyShape<3, double>&, const Vec<3, double>&,
                                                    const AnyShape<3, double>&);
template std::optional<detail::Strike<3>> strike_of(const AnyShape<3, double>&, const Vec<3, double>&,
                                                    const AnyShape<3, double>&);

}  // namespace graze::test
