// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>

namespace graze::detail {

template <Dim N, class T>
bool lexicographically_less(const Vec<N, T>& a, const Vec<N, T>& b) {
  for (Dim i = 0; i < N; ++i) {
    if (a[i] != b[i]) return a[i] < b[i];
  }
  return false;
}

}  // namespace graze::detail
