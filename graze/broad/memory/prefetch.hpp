// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace graze::detail {

/// How many values ahead scattered values are prefetched.
inline constexpr std::size_t prefetch_distance = 32;

/// Working sets above this size partly leave the L2 cache between uses.
inline constexpr std::size_t bytes_near = std::size_t{1} << 19U;

/// GCC 12 takes a function that only prefetches for one without effect, and drops calls to it and to functions that
/// only call it. This makes the address observable.
[[gnu::always_inline]] inline void keep_calls([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__clang__)
  __asm__ volatile("" : : "r"(address));
#endif
}

/// Prefetches the first and the last cache line of a value that will be read soon, which are all of most values.
/// Affects only the time.
template <class Value>
[[gnu::always_inline]] inline void prefetch([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(sizeof(Value) <= 128);
  keep_calls(value);
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + 1) - 1);
#endif
}

/// Prefetches the first bytes of a value of any size and alignment.
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

/// Prefetches all cache lines of a value that is aligned to one.
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

/// Prefetches consecutive values.
template <class Value>
[[gnu::always_inline]] inline void prefetch_all([[maybe_unused]] std::span<const Value> values) {
#ifdef __GNUC__
  constexpr std::size_t per_line = 64 / sizeof(Value);
  keep_calls(values.data());
  for (std::size_t k = 0; k < values.size(); k += per_line) __builtin_prefetch(values.data() + k);
#endif
}

/// Prefetches for writing all cache lines of a value that is aligned to one.
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

/// Prefetches a cache line for writing.
[[gnu::always_inline]] inline void prefetch_to_write([[maybe_unused]] const void* place) {
#ifdef __GNUC__
  __builtin_prefetch(place, 1);
#endif
}

}  // namespace graze::detail
