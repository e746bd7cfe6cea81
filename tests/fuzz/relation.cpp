// SPDX-License-Identifier: MIT
// relation(a, b) of any two shapes: the same in both orders, and no further from the exact verdict than it may be. With
// shapes that are none it has to come to an end.
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
  const AnyShape<N, T> a = test::fuzz::any_shape<N, T>(input);
  const AnyShape<N, T> b = test::fuzz::any_shape<N, T>(input);
  const Relation claim = test::relation_of<N, T>(a, b);
  const Relation swapped = test::relation_of<N, T>(b, a);
  if (!input.is_in_range() || !is_valid(a) || !is_valid(b)) return 0;
  const auto pair = [&](std::ostream& out) {
    out << name_of(claim) << ": " << test::to_source<N, T>(a) << ", " << test::to_source<N, T>(b);
  };
  test::fuzz::require(claim == swapped, [&](std::ostream& out) {
    out << "in both orders the same, but " << name_of(swapped) << " in the other than ";
    pair(out);
  });
  const test::ExactVerdict truth = test::true_verdict<N, T>(a, b, claim);
  test::fuzz::require(test::judge(claim, truth, a.index(), b.index()) != test::Judgement::wrong,
                      [&](std::ostream& out) {
                        pair(out);
                        out << ", which are " << name_of(truth.relation) << " by " << truth.gap;
                      });
  return 0;
}
