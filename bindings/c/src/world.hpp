// SPDX-License-Identifier: MIT
// Worlds, which C has as numbers, as template arguments.
#pragma once

#include <string>
#include <type_traits>
#include <variant>

#include <graze/math/vec.hpp>

#include "../graze.h"
#include "errors.hpp"

namespace graze::c {

/// A dimension and number type, passed to generic functions.
template <Dim N, class T>
struct In {
  static constexpr bool is_float = sizeof(T) == sizeof(float);
  static constexpr graze_world world =
      N == 2 ? (is_float ? GRAZE_2D_FLOAT : GRAZE_2D) : (is_float ? GRAZE_3D_FLOAT : GRAZE_3D);
};

/// One value for each world. The index of the alternative is the graze_world.
template <template <Dim, class> class Value>
using InAnyWorld = std::variant<Value<3, double>, Value<2, double>, Value<3, float>, Value<2, float>>;

/// Returns use(In<N, T>()). Throws Error for a number that is no world.
template <class Use>
auto in_world(graze_world world, const Use& use) {
  switch (world) {
    case GRAZE_3D:
      return use(In<3, double>());
    case GRAZE_2D:
      return use(In<2, double>());
    case GRAZE_3D_FLOAT:
      return use(In<3, float>());
    case GRAZE_2D_FLOAT:
      return use(In<2, float>());
    default:
      throw Error(GRAZE_INVALID_ARGUMENT, "there is no world " + std::to_string(world) + "; GRAZE_3D, GRAZE_2D, " +
                                              "GRAZE_3D_FLOAT or GRAZE_2D_FLOAT is needed");
  }
}

/// Throws Error unless two worlds are the same.
void require_world(const char* role, graze_world world, const char* other_role, graze_world other);

}  // namespace graze::c
