// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace graze::detail {

/// How many values ahead of their use scattered ones are asked for.
inline constexpr std::size_t prefetch_distance = 32;

/// Asks for the first and the last cache line of a value that will be read soon, which are all that most values have.
/// Changes nothing but the time.
template <class Value>
void prefetch([[maybe_unused]] const Value* value) {
#ifdef __GNUC__
  static_assert(sizeof(Value) <= 128);
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + 1) - 1);
#endif
}

}  // namespace graze::detail
