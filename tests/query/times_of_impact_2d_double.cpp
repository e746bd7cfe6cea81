// SPDX-License-Identifier: MIT
#include "query/times_of_impact_instances.hpp"

namespace graze::test {

template std::optional<Impact<2, double>> impact_of(const Moving<2, double>&);
template std::optional<detail::Strike<2>> strike_of(const Moving<2, double>&);

}  // namespace graze::test
