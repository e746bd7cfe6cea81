// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace graze::detail {

/// How many values ahead of their use scattered ones are asked for.
inline constexpr std::size_t prefetch_distance = 32;

/// Of more bytes, some have left the second cache when they are used again.
inline constexpr std::size_t bytes_near = std::size_t{1} << 19U;

/// GCC 12 takes a function that only asks ahead for one that does nothing, and drops calls of it and of those that do
/// nothing but call it: unless they say that the address matters.
[[gnu::always_inline]] inline void keep_calls([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__clang__)
  __asm__ volatile("" : : "r"(address));
#endif
}

/// Asks for the first and the last cache line of a value that will be read soon, which are all that most values have.
/// Changes nothing but the time.
template <class Value>
[[gnu::always_inline]] inline void prefetch([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(sizeof(Value) <= 128);
  keep_calls(value);
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + 1) - 1);
#endif
}

/// The same for the first bytes of a value of any size, wherever it begins.
template <std::size_t bytes, class Value>
[[gnu::always_inline]] inline void prefetch_first([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(bytes <= sizeof(Value));
  constexpr std::size_t line = 64;
  keep_calls(value);
  const char* const begin = reinterpret_cast<const char*>(value);
  for (std::size_t at = 0; at < bytes; at += line) __builtin_prefetch(begin + at);
  __builtin_prefetch(begin + bytes - 1);
#endif
}

/// The same for all cache lines of a value, which begins at one.
template <class Value>
[[gnu::always_inline]] inline void prefetch_whole([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  constexpr std::size_t line = 64;
  keep_calls(value);
  for (std::size_t at = 0; at < sizeof(Value); at += line) {
    __builtin_prefetch(reinterpret_cast<const char*>(value) + at);
  }
#endif
}

/// The same for values in a row.
template <class Value>
[[gnu::always_inline]] inline void prefetch_all([[maybe_unused]] std::span<const Value> values) {
#ifdef __GNUC__
  constexpr std::size_t per_line = 64 / sizeof(Value);
  keep_calls(values.data());
  for (std::size_t k = 0; k < values.size(); k += per_line) __builtin_prefetch(values.data() + k);
#endif
}

/// Asks for all cache lines of a value that will be written to, which begins at one.
template <class Value>
[[gnu::always_inline]] inline void prefetch_whole_to_write([[maybe_unused]] Value* value) {
#ifdef __GNUC__
  constexpr std::size_t line = 64;
  keep_calls(value);
  for (std::size_t at = 0; at < sizeof(Value); at += line) {
    __builtin_prefetch(reinterpret_cast<const char*>(value) + at, 1);
  }
#endif
}

/// Asks for a cache line that will be written to.
[[gnu::always_inline]] inline void prefetch_to_write([[maybe_unused]] const void* place) {
#ifdef __GNUC__
  __builtin_prefetch(place, 1);
#endif
}

}  // namespace graze::detail
