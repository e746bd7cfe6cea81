// SPDX-License-Identifier: MIT
#include "exam/manifold_exam_instances.hpp"

namespace graze::exam {

template MeasuredPair examine_manifolds<3, float>(std::size_t, std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
