// SPDX-License-Identifier: MIT
#include "query/times_of_impact_instances.hpp"

namespace graze::test {

template std::optional<Impact<3, float>> impact_of(const Moving<3, float>&);
template std::optional<detail::Strike<3>> strike_of(const Moving<3, float>&);

}  // namespace graze::test
