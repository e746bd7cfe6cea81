// SPDX-License-Identifier: MIT
// The instruction sets that kernels are compiled for; include it before Highway.
#pragma once

// Few enough to compile in seconds; of sets that do not differ in what is used here, only the older. Vectors of
// run-time length cannot be stored in arrays, which kernels need.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
