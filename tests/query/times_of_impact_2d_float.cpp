// SPDX-License-Identifier: MIT
#include "query/times_of_impact_instances.hpp"

namespace graze::test {

template std::optional<Impact<2, float>> impact_of(const Moving<2, float>&);
template std::optional<detail::Strike<2>> strike_of(const Moving<2, float>&);

}  // namespace graze::test
