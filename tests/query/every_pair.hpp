// SPDX-License-Identifier: MIT
// Cases of one kind for every pair of types, in the number and with the seed from the environment: GRAZE_TEST_SCALE
// multiplies their number (default 1), GRAZE_TEST_SEED selects others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "number_of_cases.hpp"
#include "query/case_maker.hpp"

namespace graze::test {

inline std::uint64_t seed_of_cases() {
  return static_cast<std::uint64_t>(number_from_environment("GRAZE_TEST_SEED", 1));
}

/// Calls check(pair) for the cases of `count` draws for each pair of types. Calls `goes_on()` before each draw.
template <Dim N, class T, class Check, class GoesOn>
void for_each_case(CaseKind kind, std::size_t count, const Check& check, const GoesOn& goes_on) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, T>>;
  for (std::size_t a = 0; a < types; ++a) {
    for (std::size_t b = a; b < types; ++b) {
      CaseMaker<N, T> maker(a, b, seed_of_cases() + a * types + b);
      for (std::size_t i = 0; i < count && goes_on(); ++i) {
        for (const AnyPair<N, T>& pair : maker.make(kind)) check(pair);
      }
    }
  }
}

}  // namespace graze::test
