// SPDX-License-Identifier: MIT
#include "exam/point_exam_instances.hpp"

namespace graze::exam {

template PointTally examine_points<3, float>(std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
