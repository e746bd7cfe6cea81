// SPDX-License-Identifier: MIT
#include <graze/query/compiled/singles-inl.hpp>

namespace graze {

GRAZE_SINGLE_INSTANCES(2, float)
GRAZE_SINGLE_INSTANCES(2, double)

}  // namespace graze
