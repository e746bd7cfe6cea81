// SPDX-License-Identifier: MIT
#include <graze/query/compiled/singles-inl.hpp>

namespace graze {

GRAZE_SINGLE_INSTANCES(3, float)
GRAZE_SINGLE_INSTANCES(3, double)

}  // namespace graze
