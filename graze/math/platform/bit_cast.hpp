// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <graze/math/platform/compiler.hpp>

namespace graze {

/// std::bit_cast, by the builtin that it uses: the standard library of Emscripten 3.1 (libc++ 13) lacks std::bit_cast.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace graze
