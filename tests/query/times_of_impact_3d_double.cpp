// SPDX-License-Identifier: MIT
#include "query/times_of_impact_instances.hpp"

namespace graze::test {

template std::optional<Impact<3, double>> impact_of(const Moving<3, double>&);
template std::optional<detail::Strike<3>> strike_of(const Moving<3, double>&);

}  // namespace graze::test
