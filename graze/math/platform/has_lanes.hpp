// SPDX-License-Identifier: MIT
// GRAZE_HAS_LANES: the compiler has vector types. GCC 12 and Clang support them on every processor, in registers or
// emulated. Other compilers, and these with GRAZE_NO_LANES defined, use scalar code: verdicts are the same, but
// contacts, manifolds and ray hits are calculated in another order and differ within their error.
#pragma once

#if defined(__has_builtin) && !defined(GRAZE_NO_LANES)
#if __has_builtin(__builtin_shufflevector)
#define GRAZE_HAS_LANES
#endif
#endif

// Functions for wider registers, chosen at run time. The AVX-512 ones could be contracted, see compiler.hpp. On Windows
// GCC does not align them on the stack (bug 54412).
#if defined(GRAZE_HAS_LANES) && defined(__x86_64__) && defined(GRAZE_NO_CONTRACTION) && \
    !(defined(_WIN32) && !defined(__clang__))
#define GRAZE_HAS_WIDER_LANES
#endif
