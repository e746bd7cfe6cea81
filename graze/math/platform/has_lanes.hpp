// SPDX-License-Identifier: MIT
// GRAZE_HAS_LANES: vectors as a type of the language. GCC 12 and Clang have them on every processor, by its registers
// or by plain numbers. Other compilers do without, and so do these where GRAZE_NO_LANES is defined: verdicts are the
// same, but contacts, manifolds and ray hits are calculated in another order, so they differ within their error.
#pragma once

#if defined(__has_builtin) && !defined(GRAZE_NO_LANES)
#if __has_builtin(__builtin_shufflevector)
#define GRAZE_HAS_LANES
#endif
#endif

// Functions for wider registers, chosen at run time. Those of AVX-512 could be contracted, see compiler.hpp.
#if defined(GRAZE_HAS_LANES) && defined(__x86_64__) && defined(GRAZE_NO_CONTRACTION)
#define GRAZE_HAS_WIDER_LANES
#endif
