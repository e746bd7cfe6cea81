// SPDX-License-Identifier: MIT
#include "exam/impact_exam_instances.hpp"

namespace graze::exam {

template MeasuredPair examine_impacts<3, double>(std::size_t, std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
