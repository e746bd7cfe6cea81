// SPDX-License-Identifier: MIT
// The instruction sets that kernels are compiled for; include it before Highway.
#pragma once

// Few enough to compile in seconds; of sets that do not differ in what is used here, only the older. Vectors of
// run-time length cannot be stored in arrays, which kernels need.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

// Without a choice at run time, Highway compiles NEON for every 64-bit ARM processor. With one it also asks for
// cryptographic instructions, and then GCC refuses to inline vectors into constructors that are not written out.
#ifdef __aarch64__
#define TOOLCHAIN_MISS_SYS_AUXV_H
#endif
