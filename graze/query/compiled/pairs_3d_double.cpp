// SPDX-License-Identifier: MIT
#include <graze/query/compiled/pairs-inl.hpp>

namespace graze {

GRAZE_PAIR_INSTANCES(3, double)

}  // namespace graze
