// SPDX-License-Identifier: MIT
// relation(a, b) of any two shapes: the same in both orders, and within the documented band of the exact verdict. For
// invalid shapes it must terminate.
#include <cstddef>
#include <cstdint>
#include <ostream>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"
#include "query/pairs.hpp"
#include "query/verdict_band.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const test::fuzz::ShapePair<N, T> pair(input);
  const Relation claim = test::relation_of<N, T>(pair.a, pair.b);
  const Relation swapped = test::relation_of<N, T>(pair.b, pair.a);
  if (!pair.is_judged) return 0;
  test::fuzz::require(claim == swapped, [&](std::ostream& out) {
    out << "the other order gives " << name_of(swapped) << " instead of " << name_of(claim) << ": " << pair;
  });
  const test::ExactVerdict truth = test::true_verdict<N, T>(pair.a, pair.b, claim);
  const test::Judgement judgement = test::judge(claim, truth, pair.a.index(), pair.b.index());
  test::fuzz::require(judgement != test::Judgement::wrong, [&](std::ostream& out) {
    out << name_of(claim) << ": " << pair << ", which are " << name_of(truth.relation) << " by " << truth.gap;
  });
  return 0;
}
