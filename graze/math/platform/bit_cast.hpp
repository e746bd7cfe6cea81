// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <graze/math/platform/compiler.hpp>

namespace graze {

/// The value of another type that has the same bits: std::bit_cast, by what it is made of in every compiler that graze
/// knows, since the standard library of Emscripten 3.1 (libc++ 13) does not have it yet.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace graze
