// SPDX-License-Identifier: MIT
#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>

namespace graze {

GRAZE_GJK_INSTANCES(, 2)
GRAZE_GJK_INSTANCES(, 3)
GRAZE_EPA_INSTANCES(, 2)
GRAZE_EPA_INSTANCES(, 3)

}  // namespace graze
