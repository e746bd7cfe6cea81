// SPDX-License-Identifier: MIT
#include <graze/query/compiled/pairs-inl.hpp>

namespace graze {

GRAZE_PAIR_INSTANCES(2, float)

}  // namespace graze
