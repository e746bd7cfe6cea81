// SPDX-License-Identifier: MIT
// Which instruction sets kernels are compiled for; to be included before Highway.
#pragma once

// Few enough to compile in seconds: of sets that differ in nothing that is used here, the older one. Vectors whose
// length is known at run time only cannot be held in arrays, as kernels hold them.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
