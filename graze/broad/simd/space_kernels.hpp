// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// The kernels of one instruction set, for each dimension and scalar type.
template <template <Dim, class> class Kernels>
struct SpaceKernels {
  Kernels<2, float> float_2d;
  Kernels<3, float> solid_float;
  Kernels<2, double> double_2d;
  Kernels<3, double> solid_double;

  template <Dim N, class T>
  const Kernels<N, T>& of() const {
    static_assert(N == 2 || N == 3);
    if constexpr (std::is_same_v<T, float>) {
      if constexpr (N == 2) return float_2d;
      if constexpr (N == 3) return solid_float;
    } else {
      static_assert(std::is_same_v<T, double>);
      if constexpr (N == 2) return double_2d;
      if constexpr (N == 3) return solid_double;
    }
  }
};

/// The kernels of one instruction set, for one dimension.
template <template <class> class Kernels>
struct ScalarKernels {
  Kernels<float> of_float;
  Kernels<double> of_double;

  template <class T>
  const Kernels<T>& of() const {
    if constexpr (std::is_same_v<T, float>) {
      return of_float;
    } else {
      static_assert(std::is_same_v<T, double>);
      return of_double;
    }
  }
};

}  // namespace graze::detail
