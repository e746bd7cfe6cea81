// SPDX-License-Identifier: MIT
#include "query/shape_casts_instances.hpp"

namespace graze::test {

template std::optional<Impact<2, float>> impact_of(const AnyShape<2, float>&, const Vec<2, float>&,
                                                   const AnyShape<2, float>&);
template std::optional<detail::Strike<2>> strike_of(const AnyShape<2, float>&, const Vec<2, float>&,
                                                    const AnyShape<2, float>&);

}  // namespace graze::test
