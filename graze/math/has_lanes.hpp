// SPDX-License-Identifier: MIT
// GRAZE_HAS_LANES: vectors as a type of the language. GCC 12 and Clang have them on every processor, by its registers
// or by plain numbers.
#pragma once

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define GRAZE_HAS_LANES
#endif
#endif

#if defined(GRAZE_HAS_LANES) && defined(__x86_64__)
#define GRAZE_HAS_WIDER_LANES
#endif
