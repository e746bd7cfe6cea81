// SPDX-License-Identifier: MIT
// GRAZE_EXPORT marks what the shared library exports: the public functions and classes that are compiled, and the few
// internal ones that its headers call. Everything else is hidden. If the CMake target graze::graze is a shared library,
// it defines GRAZE_SHARED for its users, and GRAZE_BUILDS_SHARED for itself.
#pragma once

#if !defined(GRAZE_SHARED)
#define GRAZE_EXPORT
#elif defined(_WIN32)
#if defined(GRAZE_BUILDS_SHARED)
#define GRAZE_EXPORT __declspec(dllexport)
#else
#define GRAZE_EXPORT __declspec(dllimport)
#endif
#else
#define GRAZE_EXPORT __attribute__((visibility("default")))
#endif
