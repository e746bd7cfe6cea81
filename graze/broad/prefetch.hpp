// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace graze::detail {

/// How many values ahead of their use scattered ones are asked for.
inline constexpr std::size_t prefetch_distance = 32;

/// Asks for a value, of at most a cache line, that will be read soon. Changes nothing but the time.
template <class Value>
void prefetch([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(sizeof(Value) <= 64);
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + 1) - 1);
#endif
}

}  // namespace graze::detail
