// SPDX-License-Identifier: MIT
#include "exam/ray_exam_instances.hpp"

namespace graze::exam {

template MeasuredPair examine_rays<3, float>(std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
