// SPDX-License-Identifier: MIT
#include "catalogue.hpp"
#include "catalogue/instances.hpp"

GRAZE_TEST_SPACE(, 3, float)
