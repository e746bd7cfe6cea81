// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace graze::detail {

/// How many values ahead of their use scattered ones are asked for.
inline constexpr std::size_t prefetch_distance = 32;

// Inlined before GCC 12 looks what a function does: one that only asks ahead it takes for one that does nothing, and
// drops calls from functions that are compiled for another instruction set.

/// Asks for the first and the last cache line of a value that will be read soon, which are all that most values have.
/// Changes nothing but the time.
template <class Value>
[[gnu::always_inline]] inline void prefetch([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(sizeof(Value) <= 128);
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + 1) - 1);
#endif
}

/// The same for all cache lines of a value, which begins at one.
template <class Value>
[[gnu::always_inline]] inline void prefetch_whole([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  constexpr std::size_t line = 64;
  for (std::size_t at = 0; at < sizeof(Value); at += line) {
    __builtin_prefetch(reinterpret_cast<const char*>(value) + at);
  }
#endif
}

}  // namespace graze::detail
