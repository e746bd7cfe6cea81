// SPDX-License-Identifier: MIT
// Rejects compilers and options that break graze's guarantees, with one #error that names the way out. Include it
// before anything else that such a compiler would reject.
#pragma once

// If the processor has a fused multiply-add, GCC and Clang contract a * b + c to it unless told not to, and define no
// macro for that option. x86 has it from FMA on, WebAssembly never, all other processors always.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(GRAZE_NO_CONTRACTION)
#if defined(__x86_64__) || defined(__i386__)
#if defined(__FMA__) || defined(__FMA4__) || defined(__AVX512F__)
#define GRAZE_MAY_BE_CONTRACTED
#endif
#elif !defined(__wasm__)
#define GRAZE_MAY_BE_CONTRACTED
#endif
#endif

#if (defined(_MSVC_LANG) && _MSVC_LANG < 202002L) || (!defined(_MSVC_LANG) && __cplusplus < 202002L)
#error graze needs C++20: compile with -std=c++20 (GCC, Clang) or /std:c++20 (MSVC), or newer
#define GRAZE_IS_REFUSED
#elif defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(_M_FP_FAST)
#error graze needs exact arithmetic: compile without -ffast-math, -Ofast, -ffinite-math-only, /fp:fast
#define GRAZE_IS_REFUSED
#elif defined(__GCC_IEC_559) && __GCC_IEC_559 < 2
#error graze needs exact arithmetic: compile without all parts of -ffast-math and -fsingle-precision-constant
#define GRAZE_IS_REFUSED
#elif defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error graze needs exact arithmetic: compile without all parts of -ffast-math
#define GRAZE_IS_REFUSED
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 1 || __FLT_EVAL_METHOD__ == 2)
#error graze needs exact arithmetic, which the x87 unit does not have: compile with -msse2 -mfpmath=sse
#define GRAZE_IS_REFUSED
#elif defined(_M_IX86_FP) && _M_IX86_FP < 2
#error graze needs exact arithmetic, which the x87 unit does not have: compile with /arch:SSE2
#define GRAZE_IS_REFUSED
#elif defined(_M_FP_CONTRACT)
#error graze needs exact arithmetic: compile without /fp:contract
#define GRAZE_IS_REFUSED
#elif defined(GRAZE_MAY_BE_CONTRACTED)
#error graze needs exact arithmetic: compile for FMA with -ffp-contract=off -DGRAZE_NO_CONTRACTION, as graze::geometry does
#define GRAZE_IS_REFUSED
#elif defined(GLM_FORCE_CTOR_INIT)
#error graze needs GLM vectors that can be copied as bytes: compile without GLM_FORCE_CTOR_INIT
#define GRAZE_IS_REFUSED
#elif defined(GLM_FORCE_CXX98) || defined(GLM_FORCE_CXX03) || defined(GLM_FORCE_CXX_UNKNOWN)
#error graze needs GLM vectors that are constexpr: compile without GLM_FORCE_CXX98, GLM_FORCE_CXX03, GLM_FORCE_CXX_UNKNOWN
#define GRAZE_IS_REFUSED
#elif defined(min) || defined(max)
#error graze needs std::min and std::max, but min or max is a macro: define NOMINMAX before including windows.h
#define GRAZE_IS_REFUSED
#endif

#ifdef GRAZE_IS_REFUSED
#include "see the error above"  // GCC and Clang continue after an #error; a missing include stops them
#endif

// Clang has no macro for parts of fast math, but rejects this pragma together with any of them.
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(push)
#pragma float_control(except, on)  // graze needs exact arithmetic: compile without all parts of -ffast-math
#pragma float_control(pop)
#pragma clang diagnostic pop
#endif
