// SPDX-License-Identifier: MIT
#include "query/shape_casts_instances.hpp"

namespace graze::test {

template std::optional<Impact<3, float>> impact_of(const AnyShape<3, float>&, const Vec<3, float>&,
                                                   const AnyShape<3, float>&);
template std::optional<detail::Strike<3>> strike_of(const AnyShape<3, float>&, const Vec<3, float>&,
                                                    const AnyShape<3, float>&);

}  // namespace graze::test
