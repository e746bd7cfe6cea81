// SPDX-License-Identifier: MIT
#include "exam/pair_exam_instances.hpp"

namespace graze::exam {

template PairTally examine_pair<2, float>(std::size_t, std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
